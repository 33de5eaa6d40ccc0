// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/actionbutton.h"

#include <QAction>
#include <QToolButton>

namespace quadrille {

QToolButton* makeActionButton(QAction* action)
{
    constexpr int iconPixels = 16;
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("tool.") + action->objectName());
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({iconPixels, iconPixels});
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace quadrille
