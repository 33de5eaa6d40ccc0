// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/viewmenu.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/theme/icons.h"

#include <QMenu>

namespace quadrille {

ViewMenu::ViewMenu(EditorContext& context, SceneView& view) : QObject(&view), m_context(context), m_view(view)
{
    connect(&view.viewport(), &widgets::Viewport::contextMenuRequested, this, &ViewMenu::show);
}

void ViewMenu::addActions(QMenu& menu, const QStringList& ids)
{
    for (const QString& id : ids) {
        if (id.isEmpty())
            menu.addSeparator();
        else if (QAction* action = m_context.actions.action(id); action->isVisible())
            menu.addAction(action);
    }
}

void ViewMenu::show(const QPoint& globalPosition)
{
    auto* menu = new QMenu(&m_view);
    menu->setObjectName(QStringLiteral("viewportMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addActions(*menu, {"view.frame", "view.frameAll", "view.follow"});
    addActions(*menu->addMenu(tr("Look &from")), {"view.front", "view.side", "view.top"});
    addActions(*menu->addMenu(tr("&Shading")), {"view.textured", "view.clay", "view.wire", "view.heatMap"});
    addActions(*menu, {"", "view.grid", "view.shadow", "view.trajectory", "view.names"});
    addActions(*menu, {"", "view.ghosts", "view.pinGhost", "view.unpinGhosts"});
    if (m_view.scene().isComparing())
        addActions(*menu, {"", "view.sideBySide", "view.overlay"});
    addActions(*menu, {"", "view.measure", "view.copy", "view.savePicture", ""});
    menu->addAction(widgets::icons::icon(QStringLiteral("help")), tr("&Help on the view"), this, [this] {
        m_view.viewport().setFocus();
        m_context.actions.action(QStringLiteral("help.here"))->trigger();
    });
    menu->popup(globalPosition);
}

} // namespace quadrille

#include "moc_viewmenu.cpp"
