// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

class QMainWindow;
class QWidget;

namespace quadrille {

/// The place and size of a window, and how it fills the screen, for placeWindow().
QByteArray placeOf(const QWidget& window);

/// Gives a window the place and size that it had, as far as the screen of now has room: it is never larger
/// than the screen, nor beside it. One that filled the screen fills that of now.
/// \param place  as placeOf() gave it; with an empty one the window only comes onto the screen.
void placeWindow(QMainWindow& window, const QByteArray& place);

/// Arranges a window's docks. \param state  as QMainWindow::saveState gave it.
/// \return whether it could be read; otherwise the docks stay as they are.
bool restoreDocks(QMainWindow& window, const QByteArray& state);

} // namespace quadrille
