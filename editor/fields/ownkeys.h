// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QKeyEvent>
#include <algorithm>
#include <initializer_list>

namespace quadrille {

/// For QWidget::event(): takes keys that are shortcuts of the window, too, for the widget itself.
/// \return whether the event was about one of them, and is done with.
inline bool takesOwnKeys(QEvent& event, std::initializer_list<int> keys)
{
    if (event.type() != QEvent::ShortcutOverride ||
        std::ranges::find(keys, static_cast<QKeyEvent&>(event).key()) == keys.end())
        return false;
    event.accept();
    return true;
}

} // namespace quadrille
