// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/panelactions.h"

#include <QAction>
#include <QChildEvent>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QTabBar>
#include <algorithm>

namespace quadrille {

PanelActions::PanelActions(const QList<QDockWidget*>& docks, QMainWindow& window)
    : QObject(&window), m_window(window)
{
    m_items.reserve(static_cast<std::size_t>(docks.size()));
    for (QDockWidget* dock : docks)
        add(dock);
    // The tabs of panels that share a place are Qt's: they come and go.
    window.installEventFilter(this);
    for (auto* tabs : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        tabs->installEventFilter(this);
}

void PanelActions::add(QDockWidget* dock)
{
    auto* action = new QAction(dock->windowTitle(), this);
    action->setObjectName(QStringLiteral("panel.") + dock->objectName());
    action->setCheckable(true);
    action->setChecked(dock->toggleViewAction()->isChecked());
    const std::size_t index = m_items.size();
    m_items.push_back({dock, action});
    connect(action, &QAction::triggered, this, [this, dock] { toggle(dock); });
    connect(dock, &QWidget::windowTitleChanged, action, &QAction::setText);
    connect(dock, &QDockWidget::visibilityChanged, this,
            [this, index](bool isInFront) { m_items[index].isInFront = isInFront; });
    const auto follow = [action, own = dock->toggleViewAction()] {
        action->setVisible(own->isVisible());
        action->setChecked(own->isChecked());
    };
    connect(dock->toggleViewAction(), &QAction::changed, action, follow);
    connect(dock->toggleViewAction(), &QAction::toggled, action, follow);
    dock->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(dock, &QWidget::customContextMenuRequested, this,
            [this, dock](const QPoint& place) { showMenu(dock, dock->mapToGlobal(place)); });
}

QList<QAction*> PanelActions::actions() const
{
    QList<QAction*> actions;
    for (const Item& item : m_items)
        actions += item.action;
    return actions;
}

void PanelActions::toggle(const QDockWidget* dock)
{
    const auto item = std::ranges::find(m_items, dock, &Item::dock);
    const bool hides = item->isInFront && item->dock->isVisible();
    item->dock->setVisible(!hides);
    if (!hides)
        item->dock->raise();
    item->action->setChecked(!hides);
}

void PanelActions::showMenu(QDockWidget* dock, const QPoint& place)
{
    QMenu menu(dock);
    menu.setObjectName(QStringLiteral("panelMenu"));
    menu.addAction(dock->isFloating() ? tr("Put back into the window") : tr("Take out of the window"), dock,
                   [dock] { dock->setFloating(!dock->isFloating()); });
    menu.addAction(tr("Hide “%1”").arg(dock->windowTitle()), dock, &QWidget::close);
    emit menuRequested(dock, menu);
    menu.exec(place);
}

bool PanelActions::showTabMenu(QTabBar& tabs, const QPoint& place, const QPoint& onScreen)
{
    const int tab = tabs.tabAt(place);
    if (tab < 0)
        return false;
    tabs.setCurrentIndex(tab); // the panel that is meant is the one that can be seen then
    const auto item = std::ranges::find_if(m_items, [&](const Item& each) {
        return each.isInFront && each.dock->windowTitle() == tabs.tabText(tab);
    });
    if (item == m_items.end())
        return false;
    showMenu(item->dock, onScreen);
    return true;
}

bool PanelActions::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_window && event->type() == QEvent::ChildPolished) {
        if (auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child()))
            tabs->installEventFilter(this);
    } else if (auto* tabs = qobject_cast<QTabBar*>(watched);
               tabs != nullptr && event->type() == QEvent::ContextMenu) {
        const auto* menu = static_cast<QContextMenuEvent*>(event);
        return showTabMenu(*tabs, menu->pos(), menu->globalPos());
    }
    return false;
}

} // namespace quadrille

#include "moc_panelactions.cpp"
