// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/viewtools.h"

#include "editor/context/actionregistry.h"
#include "editor/language/retranslate.h"

#include <QSpinBox>

namespace quadrille {

namespace {

constexpr int defaultInterval = 10;
constexpr int longestInterval = 500;
constexpr int iconPixels = 16;

} // namespace

ViewTools::ViewTools(ActionRegistry& actions, QWidget* parent) : QToolBar(parent), m_interval(new QSpinBox)
{
    setObjectName(QStringLiteral("viewTools"));
    setIconSize({iconPixels, iconPixels});
    m_interval->setObjectName(QStringLiteral("ghostInterval"));
    m_interval->setRange(1, longestInterval);
    m_interval->setValue(defaultInterval);
    m_interval->setKeyboardTracking(false);
    m_interval->setFocusPolicy(Qt::ClickFocus);

    addTools(actions, {"view.textured", "view.clay", "view.wire", "", "view.grid", "view.shadow",
                       "view.trajectory", "view.names", "", "view.ghosts"});
    QAction* interval = addWidget(m_interval);
    QAction* ghosts = actions.action(QStringLiteral("view.ghosts"));
    interval->setVisible(ghosts->isChecked());
    connect(ghosts, &QAction::toggled, interval, &QAction::setVisible);
    addTools(actions, {"view.pinGhost"});
    connect(m_interval, &QSpinBox::valueChanged, this, &ViewTools::ghostIntervalChanged);
    m_comparing += addSeparator();
    for (const char* id : {"view.sideBySide", "view.overlay", "view.heatMap"}) {
        addTools(actions, {id});
        m_comparing += actions.action(QLatin1String(id));
    }
    addTools(actions, {"", "view.follow", "view.frame", "view.frameAll", "view.front", "view.side",
                       "view.top", "", "view.measure", "view.savePicture"});
    setComparing(false);
    retranslates(this, [this] { retranslate(); });
}

void ViewTools::addTools(ActionRegistry& actions, const QStringList& ids)
{
    for (const QString& id : ids) {
        if (id.isEmpty()) {
            addSeparator();
            continue;
        }
        QAction* action = actions.action(id);
        addAction(action);
        QWidget* button = widgetForAction(action);
        button->setObjectName(QStringLiteral("tool.") + id);
        button->setFocusPolicy(Qt::TabFocus);
    }
}

int ViewTools::ghostInterval() const
{
    return m_interval->value();
}

void ViewTools::setComparing(bool comparing)
{
    for (QAction* action : m_comparing) {
        action->setVisible(comparing);
        action->setEnabled(comparing);
    }
}

void ViewTools::retranslate()
{
    setWindowTitle(tr("View tools"));
    m_interval->setPrefix(tr("every ", "every 10 frames: a ghost"));
    m_interval->setToolTip(tr("Frames from one ghost to the next"));
    m_interval->setAccessibleName(m_interval->toolTip());
}

} // namespace quadrille

#include "moc_viewtools.cpp"
