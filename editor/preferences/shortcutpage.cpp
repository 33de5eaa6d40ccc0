// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/preferences/shortcutpage.h"

#include "editor/context/actionregistry.h"
#include "editor/language/retranslate.h"
#include "widgets/controls/messagestrip.h"

#include <QAction>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace quadrille {

namespace {

QString nameOf(const QAction& action)
{
    return action.text().remove(QLatin1Char('&'));
}

} // namespace

ShortcutPage::ShortcutPage(ActionRegistry& actions, QWidget* parent)
    : QWidget(parent)
    , m_actions(actions)
    , m_search(new QLineEdit)
    , m_list(new QTreeWidget)
    , m_keys(new QKeySequenceEdit)
    , m_reset(new QPushButton)
    , m_resetAll(new QPushButton)
    , m_strip(new widgets::MessageStrip)
{
    m_search->setObjectName(QStringLiteral("shortcutSearch"));
    m_search->setClearButtonEnabled(true);
    m_list->setObjectName(QStringLiteral("shortcutList"));
    m_list->setColumnCount(2);
    m_list->setUniformRowHeights(true);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_keys->setObjectName(QStringLiteral("shortcutKeys"));
    m_reset->setObjectName(QStringLiteral("shortcutReset"));
    m_resetAll->setObjectName(QStringLiteral("shortcutResetAll"));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_keys, 1);
    row->addWidget(m_reset);
    row->addWidget(m_resetAll);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(8);
    column->addWidget(m_search);
    column->addWidget(m_list, 1);
    column->addLayout(row);
    column->addWidget(m_strip);
    connect(m_search, &QLineEdit::textChanged, this, &ShortcutPage::filter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutPage::showCurrent);
    connect(m_keys, &QKeySequenceEdit::editingFinished, this, &ShortcutPage::change);
    connect(m_reset, &QPushButton::clicked, this, &ShortcutPage::resetCurrent);
    connect(m_resetAll, &QPushButton::clicked, this, &ShortcutPage::resetAll);
    retranslates(this, [this] { retranslate(); });
}

void ShortcutPage::fill()
{
    const QAction* current = actionOf(m_list->currentItem());
    const QString currentId = current != nullptr ? current->objectName() : QString();
    m_list->clear();
    QHash<QString, QTreeWidgetItem*> groups;
    for (QAction* action : m_actions.actions()) {
        const QString group = m_actions.group(action);
        QTreeWidgetItem*& parent = groups[group];
        if (parent == nullptr) {
            parent = new QTreeWidgetItem(m_list, {group});
            parent->setFlags(Qt::ItemIsEnabled);
            parent->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(
            parent, {nameOf(*action), action->shortcut().toString(QKeySequence::NativeText)});
        item->setData(0, Qt::UserRole, action->objectName());
        item->setIcon(0, action->icon());
        QFont font = item->font(1);
        font.setBold(action->shortcuts() != m_actions.ownShortcuts(action));
        item->setFont(1, font);
        if (action->objectName() == currentId)
            m_list->setCurrentItem(item);
    }
    filter(m_search->text());
    showCurrent();
}

QAction* ShortcutPage::actionOf(const QTreeWidgetItem* item) const
{
    const QString id = item == nullptr ? QString() : item->data(0, Qt::UserRole).toString();
    return id.isEmpty() ? nullptr : m_actions.action(id);
}

void ShortcutPage::filter(const QString& text)
{
    for (int g = 0; g < m_list->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = m_list->topLevelItem(g);
        bool any = false;
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem* item = group->child(i);
            const bool fits = item->text(0).contains(text, Qt::CaseInsensitive) ||
                              item->text(1).contains(text, Qt::CaseInsensitive);
            item->setHidden(!fits);
            any = any || fits;
        }
        group->setHidden(!any);
    }
}

void ShortcutPage::showCurrent()
{
    const QAction* action = actionOf(m_list->currentItem());
    m_strip->clear();
    m_keys->setEnabled(action != nullptr);
    m_reset->setEnabled(action != nullptr && action->shortcuts() != m_actions.ownShortcuts(action));
    m_keys->setKeySequence(action != nullptr ? action->shortcut() : QKeySequence());
}

void ShortcutPage::change()
{
    QAction* action = actionOf(m_list->currentItem());
    const QKeySequence keys = m_keys->keySequence();
    if (action == nullptr || action->shortcut() == keys)
        return;
    for (QAction* other : m_actions.actions()) {
        if (other == action || keys.isEmpty() || !other->shortcuts().contains(keys))
            continue;
        m_strip->show(
            widgets::MessageStrip::Kind::Warning,
            tr("%1 belongs to “%2” already.").arg(keys.toString(QKeySequence::NativeText), nameOf(*other)),
            tr("Choose other keys, or give “%1” others first.").arg(nameOf(*other)));
        m_keys->setKeySequence(action->shortcut());
        return;
    }
    m_actions.setShortcuts(action, keys.isEmpty() ? QList<QKeySequence>() : QList{keys});
    fill();
}

void ShortcutPage::resetCurrent()
{
    if (QAction* action = actionOf(m_list->currentItem()))
        m_actions.setShortcuts(action, m_actions.ownShortcuts(action));
    fill();
}

void ShortcutPage::resetAll()
{
    for (QAction* action : m_actions.actions())
        m_actions.setShortcuts(action, m_actions.ownShortcuts(action));
    fill();
}

void ShortcutPage::retranslate()
{
    m_search->setPlaceholderText(tr("Find an action or its keys"));
    m_search->setAccessibleName(tr("Find"));
    m_list->setHeaderLabels({tr("Action"), tr("Keys")});
    m_list->setAccessibleName(tr("Shortcuts"));
    m_keys->setAccessibleName(tr("New keys"));
    m_keys->setToolTip(tr("Click here and press the keys"));
    m_reset->setText(tr("Reset"));
    m_resetAll->setText(tr("Reset all"));
    fill();
}

} // namespace quadrille

#include "moc_shortcutpage.cpp"
