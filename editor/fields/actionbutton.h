// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

class QAction;
class QToolButton;

namespace quadrille {

/// A small button that shows an action's icon and runs it, called "tool.ID" after the action. It is reached
/// by Tab, and leaves the focus where it is when it is clicked.
QToolButton* makeActionButton(QAction* action);

} // namespace quadrille
