// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/context/windowplace.h"

#include <QMainWindow>
#include <QScreen>
#include <algorithm>

namespace quadrille {

namespace {

constexpr Qt::WindowStates screenFilling = Qt::WindowMaximized | Qt::WindowFullScreen;
/// How a place begins.
constexpr char fullScreen = 'F';
constexpr char maximised = 'M';
constexpr char neither = 'N';
/// What a title bar and edges take; a window learns of its own only after it is shown.
constexpr QMargins usualFrame(8, 40, 8, 8);

/// Does something to a window while it is not on its way to fill the screen.
template <typename Action>
void doneUnfilled(QMainWindow& window, Action action)
{
    const Qt::WindowStates states = window.windowState();
    const bool isOnItsWay = !window.isVisible() && (states & screenFilling);
    if (isOnItsWay)
        window.setWindowState(states & ~screenFilling);
    action();
    if (isOnItsWay)
        window.setWindowState(states);
}

/// Onto the screen, frame and all.
void moveOntoScreen(QMainWindow& window)
{
    QRect place = window.geometry();
    const QRect screen = window.screen()->availableGeometry();
    if (screen.contains(place))
        return;
    const QRect room = screen.marginsRemoved(usualFrame);
    place.setSize(place.size().boundedTo(room.size()));
    place.moveLeft(std::clamp(place.left(), room.left(), room.right() + 1 - place.width()));
    place.moveTop(std::clamp(place.top(), room.top(), room.bottom() + 1 - place.height()));
    window.setGeometry(place);
}

} // namespace

QByteArray placeOf(const QWidget& window)
{
    // Qt forgets it where the screen is much larger or smaller the next time, or its scale is.
    const char fills = window.isFullScreen() ? fullScreen : window.isMaximized() ? maximised : neither;
    return fills + window.saveGeometry();
}

void placeWindow(QMainWindow& window, const QByteArray& place)
{
    const Qt::WindowStates fills = place.startsWith(fullScreen)  ? Qt::WindowFullScreen
                                   : place.startsWith(maximised) ? Qt::WindowMaximized
                                                                 : Qt::WindowNoState;
    if (!place.isEmpty() && window.isVisible() && (window.windowState() & screenFilling)) {
        // Qt would give it the size that it has when it does not fill the screen, and think that it still
        // does.
        if (fills == (window.windowState() & screenFilling))
            return;
        window.setWindowState(window.windowState() & ~screenFilling);
    }
    if (!place.isEmpty() && !window.restoreGeometry(place.mid(1)))
        window.setWindowState(window.windowState() | fills);
    if (window.isVisible() && (window.windowState() & screenFilling))
        return; // the window manager gives it its size
    doneUnfilled(window, [&window] { moveOntoScreen(window); });
}

bool restoreDocks(QMainWindow& window, const QByteArray& state)
{
    // When a hidden window is going to be maximised, Qt keeps a second copy of the arrangement until the
    // window has its size; that copy points at parts which go when docks are shown, hidden or raised
    // meanwhile. Without the flag it makes none.
    bool isRestored = false;
    doneUnfilled(window, [&] { isRestored = window.restoreState(state); });
    return isRestored;
}

} // namespace quadrille
