// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/evaluations/evaluationchooser.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/evaluationtexts.h"
#include "editor/language/retranslate.h"

#include <QApplication>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int tableRole = Qt::UserRole;
constexpr int sentenceRole = Qt::UserRole + 1;

/// A title with a sentence below, as wide as the list.
class SentenceDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const int width = roomFor(option);
        const QRect sentence = option.fontMetrics.boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap,
                                                               index.data(sentenceRole).toString());
        return {width, option.fontMetrics.height() + sentence.height() + 2 * margin};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QStyleOptionViewItem own = option;
        initStyleOption(&own, index);
        own.text.clear();
        const QStyle* style = own.widget != nullptr ? own.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &own, painter, own.widget);
        const bool isEnabled = own.state.testFlag(QStyle::State_Enabled);
        const bool isSelected = own.state.testFlag(QStyle::State_Selected);
        const auto group = isEnabled ? QPalette::Active : QPalette::Disabled;
        painter->save();
        painter->setPen(own.palette.color(group, isSelected ? QPalette::HighlightedText : QPalette::Text));
        QFont heavier = own.font;
        heavier.setWeight(QFont::DemiBold);
        painter->setFont(heavier);
        QRect place = own.rect.adjusted(margin, margin, -margin, -margin);
        painter->drawText(place, Qt::AlignLeft | Qt::AlignTop, index.data().toString());
        painter->setFont(own.font);
        if (!isSelected)
            painter->setPen(own.palette.color(group, QPalette::PlaceholderText));
        place.setTop(place.top() + own.fontMetrics.height());
        painter->drawText(place, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                          index.data(sentenceRole).toString());
        painter->restore();
    }

private:
    static constexpr int margin = 6;

    static int roomFor(const QStyleOptionViewItem& option)
    {
        const auto* list = qobject_cast<const QAbstractItemView*>(option.widget);
        return list == nullptr ? option.rect.width() : list->viewport()->width() - 2 * margin;
    }
};

} // namespace

EvaluationChooser::EvaluationChooser(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_heading(new QLabel)
    , m_list(new QListWidget)
    , m_add(new QPushButton)
{
    setObjectName(QStringLiteral("evaluationChooser"));
    m_heading->setObjectName(QStringLiteral("evaluationHeading"));
    m_list->setObjectName(QStringLiteral("evaluationChoices"));
    m_add->setObjectName(QStringLiteral("evaluationAdd"));
    m_heading->setWordWrap(true);
    m_list->setItemDelegate(new SentenceDelegate(m_list));
    m_list->setResizeMode(QListView::Adjust);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setAlternatingRowColors(false);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(12, 8, 8, 8);
    row->addWidget(m_heading, 1);
    row->addWidget(m_add, 0, Qt::AlignRight);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(m_list, 1);
    connect(m_list, &QListWidget::itemActivated, this, &EvaluationChooser::add);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        m_add->setEnabled(item != nullptr && (item->flags() & Qt::ItemIsEnabled));
    });
    connect(m_add, &QPushButton::clicked, this, &EvaluationChooser::add);
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind != ChangeEvent::Kind::File)
            refresh();
    });
    retranslates(this, [this] {
        m_heading->setText(
            tr("Evaluations measure the project’s own takes, as the papers do, and what shows of "
               "what is made of them. Choose one to add."));
        m_add->setText(tr("Add"));
        m_list->setAccessibleName(tr("Evaluations that can be added"));
        refresh();
    });
}

/// Where there is little room, the list has it.
void EvaluationChooser::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    constexpr int leastLines = 7;
    m_heading->setVisible(height() >= leastLines * fontMetrics().lineSpacing());
}

void EvaluationChooser::begin()
{
    if (m_list->currentRow() < 0) {
        for (int row = 0; row < m_list->count() && m_list->currentRow() < 0; ++row)
            if (m_list->item(row)->flags().testFlag(Qt::ItemIsEnabled))
                m_list->setCurrentRow(row);
    }
    m_list->setFocus();
}

/// Why a table cannot be added; empty where it can.
QString EvaluationChooser::hindrance(const QString& table) const
{
    const Project& project = m_context.document.project();
    const auto isIt = [&](const EvaluationEntry& entry) {
        return entry.table == table.toStdString() &&
               (entry.character.empty() || project.characters.size() < 2);
    };
    if (std::ranges::any_of(project.evaluations, isIt))
        return tr("The project has it already.");
    if (project.sequences.empty())
        return tr("There are no takes yet.");
    const auto hasAngles = [](const SequenceEntry& sequence) { return !sequence.jointAngles.empty(); };
    if (table == QLatin1String("table1") && std::ranges::none_of(project.sequences, hasAngles))
        return tr("No take has reference joint angles (a BVH file, in its properties).");
    if (needsVariations(table.toStdString()) && project.variations.empty())
        return tr("The project has no variations.");
    if (needsAppearance(table.toStdString()) && project.appearances.empty())
        return tr("The project has no model of appearance.");
    const std::size_t spaces = neededMotionSpaces(table.toStdString());
    const auto hasTakes = [](const MotionSpaceEntry& entry) { return entry.takes.size() > 1; };
    if (std::ranges::count_if(project.motionSpaces, hasTakes) < static_cast<std::ptrdiff_t>(spaces))
        return spaces > 1 ? tr("The project has no two motion spaces of several takes.")
                          : tr("The project has no motion space of several takes.");
    const auto isUnknown = [](const TransferEntry& transfer) { return transfer.truth.empty(); };
    if (needsTruth(table.toStdString()) && std::ranges::all_of(project.transfers, isUnknown))
        return tr("No transfer names a clip that shows what it ought to be.");
    return {};
}

void EvaluationChooser::refresh()
{
    const int current = m_list->currentRow();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const std::string_view each : evaluationTables) {
        const QString table = QString::fromUtf8(each.data(), static_cast<qsizetype>(each.size()));
        auto* item = new QListWidgetItem(evaluationTitle(table), m_list);
        const QString reason = hindrance(table);
        item->setData(tableRole, table);
        //: what an evaluation shows, then why it cannot be added
        item->setData(sentenceRole, reason.isEmpty() ? evaluationSentence(table)
                                                     : tr("%1. %2").arg(evaluationSentence(table), reason));
        item->setData(Qt::AccessibleDescriptionRole, item->data(sentenceRole));
        if (!reason.isEmpty())
            item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    if (current >= 0)
        m_list->setCurrentRow(current);
    const QListWidgetItem* item = m_list->currentItem();
    m_add->setEnabled(item != nullptr && item->flags().testFlag(Qt::ItemIsEnabled));
}

void EvaluationChooser::add()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (item == nullptr || !item->flags().testFlag(Qt::ItemIsEnabled))
        return;
    EvaluationEntry entry;
    entry.table = item->data(tableRole).toString().toStdString();
    if (const QString name = addEvaluation(m_context.document, std::move(entry)); !name.isEmpty())
        emit added(name);
}

} // namespace quadrille

#include "moc_evaluationchooser.cpp"
