// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>
#include <QString>
#include <vector>

namespace quadrille::test {

/// A window of another program, as the window manager knows it.
struct DesktopWindow
{
    unsigned long id = 0;
    QString title;
};

/// What is asked of the window manager, as its keys and buttons do.
enum class WindowWish
{
    Maximise,
    FillScreen,
    Close
};

/// The windows of a running program that the window manager has taken over.
std::vector<DesktopWindow> windowsOf(qint64 processId);
void ask(WindowWish wish, const DesktopWindow& window);
/// Device pixels, without the frame; empty when the window is gone.
QSize sizeOf(const DesktopWindow& window);

} // namespace quadrille::test
