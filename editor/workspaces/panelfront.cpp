// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/panelfront.h"

#include <QDockWidget>
#include <QEvent>
#include <utility>

namespace quadrille {

PanelFront::PanelFront(QWidget& panel) : QObject(&panel), m_panel(panel)
{
    panel.installEventFilter(this);
    watchDock();
    update();
}

void PanelFront::watchDock()
{
    auto* dock = qobject_cast<QDockWidget*>(m_panel.parentWidget());
    if (dock == m_dock)
        return;
    if (m_dock)
        m_dock->removeEventFilter(this);
    m_dock = dock;
    if (m_dock)
        m_dock->installEventFilter(this);
}

void PanelFront::update()
{
    const QRect place = m_dock ? m_dock->geometry() : QRect();
    const bool isAside = m_dock && !m_dock->isFloating() && (place.right() < 0 || place.bottom() < 0);
    const bool isInFront = m_panel.isVisible() && !isAside;
    if (std::exchange(m_isInFront, isInFront) != isInFront)
        emit changed(isInFront);
}

bool PanelFront::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ParentChange:
        watchDock();
        update();
        break;
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::Move:
        update();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace quadrille

#include "moc_panelfront.cpp"
