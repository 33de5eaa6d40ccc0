// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/workspace.h"

#include <QDockWidget>

namespace quadrille {

void Workspace::showPanel(QWidget* content)
{
    if (auto* dock = qobject_cast<QDockWidget*>(content->parentWidget())) {
        dock->show();
        dock->raise();
    }
}

} // namespace quadrille

#include "moc_workspace.cpp"
