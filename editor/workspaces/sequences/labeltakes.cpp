// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/labeltakes.h"

#include "editor/commands/markedits.h"
#include "editor/documents/sequencemedia.h"
#include "editor/workspaces/sequences/knownlabels.h"

#include <QComboBox>
#include <QCompleter>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QVBoxLayout>

namespace quadrille {

namespace {

enum Column
{
    Take,
    Label,
    ColumnCount
};

/// Fields that know the labels there are. Return takes what is typed; it must not reach the dialog, which
/// would close without it.
class LabelDelegate : public QStyledItemDelegate
{
public:
    LabelDelegate(QStringList labels, QObject* parent)
        : QStyledItemDelegate(parent), m_labels(std::move(labels))
    {
    }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                          const QModelIndex& /*index*/) const override
    {
        auto* field = new QLineEdit(parent);
        field->setObjectName(QStringLiteral("takeLabel"));
        field->setFrame(false);
        field->setCompleter(new QCompleter(m_labels, field));
        return field;
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const int key =
            event->type() == QEvent::KeyPress ? static_cast<const QKeyEvent*>(event)->key() : Qt::Key_unknown;
        if (key != Qt::Key_Return && key != Qt::Key_Enter)
            return QStyledItemDelegate::eventFilter(watched, event);
        auto* field = qobject_cast<QWidget*>(watched);
        emit commitData(field);
        emit closeEditor(field, QAbstractItemDelegate::NoHint);
        return true;
    }

private:
    QStringList m_labels;
};

} // namespace

QString proposedLabel(const QString& take)
{
    static const QRegularExpression between(QStringLiteral(R"([\d_\s]+)"));
    static const QRegularExpression ends(QStringLiteral(R"(^[\s.\-–#()]+|[\s.\-–#()]+$)"));
    QString label = QString(take).replace(between, QStringLiteral(" ")).remove(ends);
    return label.isEmpty() ? take : label;
}

LabelTakes::LabelTakes(ProjectDocument& document, const SequenceMedia& media, const QStringList& takes,
                       QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_media(media)
    , m_all(new QComboBox)
    , m_table(new QTableWidget)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setObjectName(QStringLiteral("labelTakes"));
    setWindowTitle(tr("Label %n take(s)", nullptr, static_cast<int>(takes.size())));
    const QStringList labels = knownLabels(document.project());
    m_all->setObjectName(QStringLiteral("labelOfAll"));
    m_all->setEditable(true);
    m_all->addItems(labels);
    m_all->setCurrentIndex(-1);
    m_all->lineEdit()->setPlaceholderText(tr("as below"));
    m_all->setToolTip(tr("One label for all of these takes"));
    m_table->setObjectName(QStringLiteral("labelTable"));
    m_table->setItemDelegate(new LabelDelegate(labels, m_table));
    m_table->setEditTriggers(QAbstractItemView::AllEditTriggers);
    m_table->setAccessibleName(tr("Labels of the takes"));
    m_table->setTabKeyNavigation(false);
    fill(takes);

    auto* allLabel = new QLabel(tr("&Label for all:"));
    allLabel->setBuddy(m_all);
    auto* allRow = new QHBoxLayout;
    allRow->addWidget(allLabel);
    allRow->addWidget(m_all, 1);
    auto* hint = new QLabel(tr("Each label covers its whole take. A take without one is left as it is."));
    hint->setWordWrap(true);
    hint->setForegroundRole(QPalette::PlaceholderText);
    m_buttons->setObjectName(QStringLiteral("labelTakesButtons"));
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Label"));
    auto* column = new QVBoxLayout(this);
    column->addLayout(allRow);
    column->addWidget(m_table, 1);
    column->addWidget(hint);
    column->addWidget(m_buttons);
    connect(m_all, &QComboBox::editTextChanged, this, &LabelTakes::labelAll);
    connect(m_table, &QTableWidget::itemChanged, this, &LabelTakes::updateButton);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &LabelTakes::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &LabelTakes::reject);
    constexpr QSize usualSize(420, 460);
    resize(usualSize);
    m_buttons->button(QDialogButtonBox::Ok)->setDefault(true);
    m_buttons->button(QDialogButtonBox::Ok)->setFocus();
    updateButton();
}

void LabelTakes::fill(const QStringList& takes)
{
    m_table->setColumnCount(ColumnCount);
    m_table->setRowCount(static_cast<int>(takes.size()));
    m_table->setHorizontalHeaderLabels({tr("Take"), tr("Label")});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QString& take = takes[row];
        const bool isOpen = m_media.usedFrames(take).count() > 0;
        auto* name = new QTableWidgetItem(take);
        name->setFlags(isOpen ? Qt::ItemIsEnabled : Qt::NoItemFlags);
        name->setToolTip(take);
        auto* label = new QTableWidgetItem(isOpen ? proposedLabel(take) : QString());
        label->setFlags(isOpen ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable
                               : Qt::NoItemFlags);
        if (!isOpen)
            label->setToolTip(tr("This take is not open."));
        m_table->setItem(row, Take, name);
        m_table->setItem(row, Label, label);
    }
}

void LabelTakes::labelAll(const QString& label)
{
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QTableWidgetItem* item = m_table->item(row, Label);
        if (item->flags().testFlag(Qt::ItemIsEditable))
            item->setText(label.trimmed().isEmpty() ? proposedLabel(m_table->item(row, Take)->text())
                                                    : label.trimmed());
    }
}

void LabelTakes::updateButton()
{
    bool hasLabel = false;
    for (int row = 0; row < m_table->rowCount(); ++row)
        hasLabel = hasLabel || !m_table->item(row, Label)->text().trimmed().isEmpty();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(hasLabel);
}

void LabelTakes::accept()
{
    // What is still being typed counts, too.
    m_table->setCurrentCell(-1, -1);
    m_buttons->setFocus();
    std::vector<std::pair<QString, std::vector<LabelSpan>>> labels;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QString take = m_table->item(row, Take)->text();
        const QString label = m_table->item(row, Label)->text().trimmed();
        const SequenceEntry* entry = m_document.sequence(take);
        if (label.isEmpty() || entry == nullptr)
            continue;
        const LabelSpan whole{label.toStdString(), FrameRange::all(m_media.usedFrames(take).count())};
        std::vector<LabelSpan> spans = entry->labels;
        if (std::ranges::find(spans, whole) == spans.end())
            spans.insert(spans.begin(), whole);
        labels.emplace_back(take, std::move(spans));
    }
    setLabelsOfSequences(m_document, labels);
    QDialog::accept();
}

} // namespace quadrille

#include "moc_labeltakes.cpp"
