// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/actionpalette.h"

#include "widgets/theme/theme.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr int entryRole = Qt::UserRole;
constexpr int groupRole = Qt::UserRole + 1;
constexpr int shortcutRole = Qt::UserRole + 2;

QString plainText(const QAction& action)
{
    return action.text().remove(QLatin1Char('&'));
}

/// Name left, group behind it, shortcut right.
class EntryDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        return {QStyledItemDelegate::sizeHint(option, index).width(), 28};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        const bool isEnabled = index.flags().testFlag(Qt::ItemIsEnabled);
        painter->save();
        painter->setPen(Theme::color(isEnabled ? ColorRole::TextMuted : ColorRole::TextDisabled));
        const QRect box = option.rect.adjusted(8, 0, -8, 0);
        const QString group = index.data(groupRole).toString();
        const QString shortcut = index.data(shortcutRole).toString();
        const QString right = shortcut.isEmpty() ? group : group + QStringLiteral("   ") + shortcut;
        painter->drawText(box, Qt::AlignVCenter | Qt::AlignRight, right);
        painter->restore();
    }
};

} // namespace

ActionPalette::ActionPalette(QWidget* parent)
    : QDialog(parent, Qt::Popup), m_field(new QLineEdit), m_list(new QListWidget), m_nothing(new QLabel)
{
    setObjectName(QStringLiteral("actionPalette"));
    m_field->setObjectName(QStringLiteral("actionPaletteField"));
    m_field->setClearButtonEnabled(true);
    m_field->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("actionPaletteList"));
    m_list->setItemDelegate(new EntryDelegate(m_list));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setUniformItemSizes(true);
    m_nothing->setObjectName(QStringLiteral("actionPaletteNothing"));
    m_nothing->setAlignment(Qt::AlignCenter);
    m_nothing->setForegroundRole(QPalette::PlaceholderText);
    m_nothing->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    column->addWidget(m_field);
    column->addWidget(m_list, 1);
    column->addWidget(m_nothing, 1);
    connect(m_field, &QLineEdit::textChanged, this, &ActionPalette::refill);
    connect(m_list, &QListWidget::itemClicked, this, &ActionPalette::run);
    retranslate();
}

int ActionPalette::score(const QString& typed, const QString& name)
{
    int sum = 1;
    for (const QString& word : typed.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        const auto at = name.indexOf(word, 0, Qt::CaseInsensitive);
        if (at < 0)
            return 0;
        const bool beginsWord = at == 0 || !name[at - 1].isLetterOrNumber();
        sum += beginsWord ? 4 : 1;
        sum += at == 0 ? 2 : 0;
    }
    return sum;
}

void ActionPalette::ask(const std::vector<Entry>& entries)
{
    m_entries = entries;
    m_field->clear();
    refill();
    const QWidget* over = parentWidget() != nullptr ? parentWidget()->window() : nullptr;
    resize(520, 360);
    if (over != nullptr)
        move(over->mapToGlobal(QPoint((over->width() - width()) / 2, over->height() / 8)));
    show();
    m_field->setFocus();
}

void ActionPalette::refill()
{
    struct Match
    {
        std::size_t entry;
        int score;
    };
    const QString typed = m_field->text();
    std::vector<Match> matches;
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const auto recent = m_recent.indexOf(m_entries[i].action);
        const QString name = plainText(*m_entries[i].action);
        const int fit = score(typed, name + QLatin1Char(' ') + m_entries[i].group);
        const bool isExact = name.compare(typed.trimmed(), Qt::CaseInsensitive) == 0;
        if (fit > 0)
            matches.push_back(
                {i, 100 * (isExact ? 2 * fit : fit) + (recent < 0 ? 0 : 50 - static_cast<int>(recent))});
    }
    std::ranges::stable_sort(matches, std::greater{}, &Match::score);
    m_list->clear();
    for (const Match& match : matches) {
        const auto& [action, group] = m_entries[match.entry];
        auto* item = new QListWidgetItem(action->icon(), plainText(*action), m_list);
        item->setData(entryRole, static_cast<int>(match.entry));
        item->setData(groupRole, group);
        item->setData(shortcutRole, action->shortcut().toString(QKeySequence::NativeText));
        item->setToolTip(action->toolTip());
        if (!action->isEnabled())
            item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    m_list->setCurrentRow(0);
    m_list->setVisible(m_list->count() > 0);
    m_nothing->setVisible(m_list->count() == 0);
}

void ActionPalette::run()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (item == nullptr || !item->flags().testFlag(Qt::ItemIsEnabled))
        return;
    QAction* action = m_entries[static_cast<std::size_t>(item->data(entryRole).toInt())].action;
    m_recent.removeAll(action);
    m_recent.prepend(action);
    close();
    action->trigger();
}

bool ActionPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            QApplication::sendEvent(m_list, event);
            return true;
        }
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            run();
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void ActionPalette::retranslate()
{
    m_field->setPlaceholderText(tr("What do you want to do?"));
    m_field->setAccessibleName(tr("Find an action"));
    m_list->setAccessibleName(tr("Actions"));
    m_nothing->setText(tr("No action has this name."));
}

void ActionPalette::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

} // namespace quadrille::widgets

#include "moc_actionpalette.cpp"
