// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The panels of the window, and the menus.
#include "editor/application/layouts.h"
#include "editor/application/menus.h"
#include "editor/application/panelactions.h"
#include "editor/docks/cardspanel.h"
#include "editor/docks/projectpanel.h"
#include "editor/docks/texturepanel.h"
#include "editor/errors/issuespanel.h"
#include "editor/evaluations/evaluationpanel.h"
#include "editor/help/helpflow.h"
#include "editor/language/retranslate.h"
#include "editor/mainwindow.h"
#include "editor/properties/propertiespanel.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/appearance/appearanceworkspace.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/live/liveworkspace.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/transfer/transferworkspace.h"
#include "editor/workspaces/variations/variationsworkspace.h"
#include "editor/workspaces/workspacetabs.h"

#include <QDockWidget>
#include <QHash>
#include <QMenu>
#include <QUndoView>

namespace quadrille {

QDockWidget* MainWindow::addDock(const char* name, std::function<QString()> title, QWidget* content,
                                 Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(this);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(content);
    addDockWidget(area, dock);
    retranslates(dock, [dock, title = std::move(title)] { dock->setWindowTitle(title()); });
    m_docks += dock;
    return dock;
}

void MainWindow::makeDocks()
{
    auto* projectPanel = new ProjectPanel(m_context); // has actions that the cards share
    auto* cards = addDock(
        "cardsDock", [] { return tr("Cards"); }, new CardsPanel(m_context), Qt::LeftDockWidgetArea);
    auto* project = addDock(
        "projectDock", [] { return tr("Project"); }, projectPanel, Qt::LeftDockWidgetArea);
    m_propertiesDock = addDock(
        "propertiesDock", [] { return tr("Properties"); }, new PropertiesPanel(m_context),
        Qt::RightDockWidgetArea);
    tabifyDockWidget(cards, project);
    m_workspaces->setFirstDock(cards);
    auto* changes = new QUndoView(m_context.document.undoStack());
    changes->setObjectName(QStringLiteral("historyView"));
    auto* history = addDock(
        "historyDock", [] { return tr("History"); }, changes, Qt::RightDockWidgetArea);
    m_issuesDock = addDock(
        "issuesDock", [] { return tr("Issues"); }, new IssuesPanel(m_context.issues),
        Qt::BottomDockWidgetArea);
    auto* texture = addDock(
        "textureDock", [] { return tr("Texture"); }, new TexturePanel(m_context, m_sequences->scene()),
        Qt::RightDockWidgetArea);
    auto* evaluation = addDock(
        "evaluationDock", [] { return tr("Evaluation"); }, new EvaluationPanel(m_context),
        Qt::BottomDockWidgetArea);
    tabifyDockWidget(m_issuesDock, evaluation);
    splitDockWidget(m_propertiesDock, texture, Qt::Vertical);
    tabifyDockWidget(m_propertiesDock, history);
    m_propertiesDock->raise();
    history->hide();
    texture->hide();
    m_issuesDock->hide();
    evaluation->hide();
    resizeDocks({cards, m_propertiesDock}, {240, 280}, Qt::Horizontal);
}

void MainWindow::makeWorkspaces()
{
    const auto add = [this](const char* id, ActionRegistry::Text title, Workspace* workspace) {
        QList<QDockWidget*> docks;
        QHash<Qt::DockWidgetArea, QDockWidget*> firstOf;
        QDockWidget* lower = nullptr;
        for (const Workspace::Panel& panel : workspace->panels()) {
            docks += addDock(panel.name, panel.title, panel.content, panel.area);
            docks.back()->setProperty("isShownFirst", panel.isShown);
            if (panel.isLower) {
                // Docks that share a place cannot be split: the one below them can be shared.
                docks.back()->setProperty("isLower", true);
                tabifyDockWidget(findChild<QDockWidget*>(QStringLiteral("textureDock")), docks.back());
                if (lower == nullptr)
                    lower = docks.back();
                continue;
            }
            // Side by side they would be too low to be of use.
            if (panel.area == Qt::RightDockWidgetArea)
                tabifyDockWidget(findChild<QDockWidget*>(QStringLiteral("propertiesDock")), docks.back());
            QDockWidget*& first = firstOf[panel.area];
            if (first != nullptr)
                tabifyDockWidget(first, docks.back());
            else
                first = docks.back();
        }
        for (QDockWidget* first : std::as_const(firstOf))
            first->raise();
        if (lower != nullptr)
            lower->raise();
        // Its own panels take the place of the properties.
        m_workspaces->add({QLatin1String(id), std::move(title), workspace, docks,
                           firstOf.contains(Qt::RightDockWidgetArea)});
    };
    m_workspaces->setPropertiesDock(m_propertiesDock);
    add(
        "sequences", [] { return tr("&Sequences"); }, m_sequences);
    add(
        "graph", [] { return tr("&Graph"); }, m_graph);
    add(
        "animate", [] { return tr("&Animate"); }, m_animate);
    add(
        "variations", [] { return tr("&Variations"); }, m_variations);
    add(
        "appearance", [] { return tr("A&ppearance"); }, m_appearance);
    add(
        "transfer", [] { return tr("T&ransfer"); }, m_transfer);
    add(
        "live", [] { return tr("&Live"); }, m_live);
}

void MainWindow::makeMenus()
{
    auto* panels = new PanelActions(m_docks, *this);
    auto* layouts = new LayoutMenu(m_context.actions, *m_workspaces, *this);
    auto* menus = new Menus(m_context, *this);
    m_panelMenu = menus->addSubmenu(menus->view(), "panelsMenu", [] { return tr("Pa&nels"); });
    m_panelMenu->addActions(panels->actions());
    QMenu* layoutMenu = menus->addSubmenu(menus->view(), "layoutsMenu", [] { return tr("La&yout"); });
    layouts->fill(*layoutMenu);
    connect(panels, &PanelActions::menuRequested, this,
            [this, layoutMenu](const QDockWidget* dock, QMenu& menu) {
                menu.addSeparator();
                menu.addAction(tr("Help on “%1”").arg(dock->windowTitle()), this,
                               [this, dock] { m_help->show(helpTopicOf(dock->widget())); });
                menu.addSeparator();
                menu.addMenu(m_panelMenu);
                menu.addMenu(layoutMenu);
            });
}

/// The right mouse button on bars of the window.
QMenu* MainWindow::createPopupMenu()
{
    auto* menu = new QMenu(this);
    menu->addActions(m_panelMenu->actions());
    return menu;
}

} // namespace quadrille
