// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/context/actionregistry.h"

#include "editor/context/settings.h"
#include "widgets/theme/icons.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

ActionRegistry::ActionRegistry(Settings& settings, QObject* parent) : QObject(parent), m_settings(settings) {}

QAction* ActionRegistry::make(Entry entry)
{
    auto* action = new QAction(this);
    action->setObjectName(entry.id);
    if (!entry.icon.isEmpty())
        action->setIcon(widgets::icons::icon(entry.icon));
    action->setShortcuts(m_settings.shortcuts(entry.id, entry.shortcuts));
    m_items.push_back({std::move(entry), action});
    translate(m_items.back());
    return action;
}

QAction* ActionRegistry::add(Entry entry, std::function<void()> run)
{
    QAction* action = make(std::move(entry));
    connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    return action;
}

QAction* ActionRegistry::addToggle(Entry entry, bool checked, std::function<void(bool)> run)
{
    QAction* action = make(std::move(entry));
    action->setCheckable(true);
    action->setChecked(checked);
    connect(action, &QAction::toggled, this, std::move(run));
    return action;
}

void ActionRegistry::translate(const Item& item)
{
    const QString text = item.entry.text();
    item.action->setText(text);
    QString tip = item.entry.tip ? item.entry.tip() : QString(text).remove(QLatin1Char('&'));
    item.action->setStatusTip(tip);
    if (!item.action->shortcut().isEmpty())
        tip += QStringLiteral(" (%1)").arg(item.action->shortcut().toString(QKeySequence::NativeText));
    item.action->setToolTip(tip);
}

const ActionRegistry::Item& ActionRegistry::item(const QAction* action) const
{
    const auto found = std::ranges::find(m_items, action, &Item::action);
    assert(found != m_items.end());
    return *found;
}

QAction* ActionRegistry::action(const QString& id) const
{
    const auto found = std::ranges::find(m_items, id, [](const Item& each) { return each.entry.id; });
    assert(found != m_items.end());
    return found->action;
}

QList<QAction*> ActionRegistry::actions() const
{
    QList<QAction*> result;
    for (const Item& each : m_items)
        result += each.action;
    return result;
}

QString ActionRegistry::group(const QAction* action) const
{
    return item(action).entry.group();
}

QList<QKeySequence> ActionRegistry::ownShortcuts(const QAction* action) const
{
    return item(action).entry.shortcuts;
}

void ActionRegistry::setShortcuts(QAction* action, const QList<QKeySequence>& shortcuts)
{
    action->setShortcuts(shortcuts);
    m_settings.setShortcuts(action->objectName(), shortcuts, ownShortcuts(action));
    translate(item(action));
}

void ActionRegistry::retranslate()
{
    std::ranges::for_each(m_items, translate);
}

} // namespace quadrille

#include "moc_actionregistry.cpp"
