// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/blendlist.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/rightmenu.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "model/project/document/blendedges.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int rowHeight = 24; // pixels
constexpr int pairColumn = 0;
constexpr int weightsColumn = 1;
constexpr double percent = 100;

/// Between the weights of both pairs of a square.
QString times()
{
    return QStringLiteral(" × ");
}

QString pairText(const BlendEntry& blend)
{
    const auto text = [](const std::string& from, const std::string& to) {
        return BlendList::tr("%1 → %2").arg(QString::fromStdString(from), QString::fromStdString(to));
    };
    const QString pair = text(blend.from, blend.to);
    return blend.across ? pair + times() + text(blend.across->from, blend.across->to) : pair;
}

QString allWeightsText(const BlendEntry& blend)
{
    const QString weights = weightsText(blend.weights);
    return blend.across ? weights + times() + weightsText(blend.across->weights) : weights;
}

/// Takes weights as allWeightsText writes them. \return false where there are none.
bool takeWeightsOf(BlendEntry& blend, const QString& text)
{
    const QStringList pairs = text.split(times().trimmed());
    if (pairs.size() != (blend.across ? 2 : 1))
        return false;
    blend.weights = weightsIn(pairs.front());
    if (blend.across)
        blend.across->weights = weightsIn(pairs.back());
    return !blend.weights.empty() && !(blend.across && blend.across->weights.empty());
}

} // namespace

QString weightsText(const std::vector<double>& weights)
{
    QStringList parts;
    for (const double weight : weights)
        parts += BlendList::tr("%1 %", "share in percent").arg(QLocale().toString(weight * percent, 'g', 4));
    return parts.join(QStringLiteral(", "));
}

std::vector<double> weightsIn(const QString& text)
{
    const bool hasDecimalComma = QLocale().decimalPoint() == QLatin1String(",");
    const QStringList parts = text.split(
        QRegularExpression(hasDecimalComma ? QStringLiteral("[;%\\s]+|,\\s+") : QStringLiteral("[;,%\\s]+")),
        Qt::SkipEmptyParts);
    std::vector<double> weights;
    for (const QString& part : parts) {
        bool isNumber = false;
        const double value = QLocale().toDouble(part, &isNumber) / percent;
        if (isNumber && value > 0 && value < 1)
            weights.push_back(value);
    }
    std::ranges::sort(weights);
    weights.erase(std::unique(weights.begin(), weights.end()), weights.end());
    return weights;
}

BlendList::BlendList(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent)
    , m_variation(variation)
    , m_blends(new QTreeWidget)
    , m_hint(new QLabel)
    , m_from(new QComboBox)
    , m_to(new QComboBox)
    , m_add(new QPushButton)
    , m_adding(new QWidget)
{
    setObjectName(QStringLiteral("blendList"));
    m_blends->setObjectName(QStringLiteral("blends"));
    addRightMenu(*m_blends);
    m_blends->setRootIsDecorated(false);
    m_blends->setUniformRowHeights(true);
    m_blends->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_blends->header()->setStretchLastSection(false);
    m_blends->header()->setSectionResizeMode(pairColumn, QHeaderView::Stretch);
    m_blends->header()->setSectionResizeMode(weightsColumn, QHeaderView::ResizeToContents);
    m_blends->installEventFilter(this);
    m_hint->setObjectName(QStringLiteral("blendHint"));
    m_hint->setWordWrap(true);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_from->setObjectName(QStringLiteral("blendFrom"));
    m_to->setObjectName(QStringLiteral("blendTo"));
    m_add->setObjectName(QStringLiteral("blendAdd"));
    m_add->setIcon(widgets::icons::icon(QStringLiteral("add")));
    for (QComboBox* box : {m_from, m_to}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(5);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(box, &QComboBox::activated, this, &BlendList::refreshAdding);
    }
    auto* row = new QHBoxLayout(m_adding);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_from, 1);
    row->addWidget(new QLabel(QStringLiteral("→")));
    row->addWidget(m_to, 1);
    row->addWidget(m_add);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_hint);
    column->addWidget(m_blends);
    column->addWidget(m_adding);
    connect(m_add, &QPushButton::clicked, this, &BlendList::add);
    connect(m_blends, &QTreeWidget::itemDoubleClicked, this,
            [this](QTreeWidgetItem* item) { m_blends->editItem(item, weightsColumn); });
    connect(m_blends, &QTreeWidget::itemChanged, this, &BlendList::takeWeights);
    connect(&variation, &CurrentVariation::changed, this, &BlendList::refresh);
    retranslates(this, [this] {
        m_blends->setHeaderLabels({tr("Pair"), tr("Weights")});
        m_blends->setAccessibleName(tr("Blends"));
        m_blends->setToolTip(tr("Return or a double click edits the weights of the second; Delete removes "
                                "the pair"));
        m_from->setAccessibleName(tr("First take"));
        m_to->setAccessibleName(tr("Second take"));
        m_add->setText(tr("Blend"));
        m_add->setToolTip(tr("Learn from blends of the two takes, too, so that variations between them can "
                             "be drawn"));
        refresh();
    });
}

void BlendList::refresh()
{
    const QScopedValueRollback showing(m_isShowing, true);
    const VariationEntry* entry = m_variation.entry();
    const QString from = m_from->currentText();
    const QString to = m_to->currentText();
    const int row = m_blends->indexOfTopLevelItem(m_blends->currentItem());
    m_from->clear();
    m_to->clear();
    m_blends->clear();
    if (entry != nullptr) {
        for (const TrainingEntry& take : entry->training) {
            m_from->addItem(QString::fromStdString(take.sequence));
            m_to->addItem(QString::fromStdString(take.sequence));
        }
        for (const BlendEntry& blend : entry->blends) {
            const QString pair = pairText(blend);
            auto* item = new QTreeWidgetItem(m_blends, {pair, allWeightsText(blend)});
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            item->setToolTip(pairColumn, pair);
            item->setTextAlignment(weightsColumn, Qt::AlignRight | Qt::AlignVCenter);
            item->setFont(weightsColumn, widgets::Theme::tabularFont(font()));
        }
    }
    m_from->setCurrentIndex(std::max(m_from->findText(from), 0));
    m_to->setCurrentIndex(m_to->findText(to) < 0 ? std::min(1, m_to->count() - 1) : m_to->findText(to));
    const int blends = m_blends->topLevelItemCount();
    if (row >= 0 && row < blends)
        m_blends->setCurrentItem(m_blends->topLevelItem(row));
    m_blends->setVisible(blends > 0);
    m_blends->setFixedHeight((blends + 1) * rowHeight + 2 * m_blends->frameWidth());
    refreshAdding();
}

void BlendList::refreshAdding()
{
    const VariationEntry* entry = m_variation.entry();
    const auto isPair = [this](const BlendEntry& blend) {
        const std::string from = m_from->currentText().toStdString();
        const std::string to = m_to->currentText().toStdString();
        return std::ranges::any_of(edgesOf(blend),
                                   [&](const BlendEdge& edge) { return edge.isBetween(from, to); });
    };
    const bool areTwo = m_from->count() > 1;
    m_add->setEnabled(areTwo && m_from->currentText() != m_to->currentText() &&
                      std::ranges::none_of(entry->blends, isPair));
    m_hint->setText(areTwo ? QString() : tr("Choose two takes or more to blend between them."));
    m_hint->setVisible(!areTwo);
    m_adding->setVisible(areTwo);
}

void BlendList::add()
{
    BlendEntry blend;
    blend.from = m_from->currentText().toStdString();
    blend.to = m_to->currentText().toStdString();
    m_variation.edit(tr("Blend “%1” and “%2”").arg(m_from->currentText(), m_to->currentText()),
                     QStringLiteral("blends"), [&](VariationEntry& entry) { entry.blends.push_back(blend); });
}

void BlendList::remove(int row)
{
    m_variation.edit(tr("Remove a blend"), QStringLiteral("blends"), [row](VariationEntry& entry) {
        const BlendEntry gone = entry.blends[static_cast<std::size_t>(row)];
        entry.blends.erase(entry.blends.begin() + row);
        std::erase_if(entry.samples, [&](const SamplesEntry& samples) {
            return samples.of == gone.from && samples.to == gone.to &&
                   samples.across.has_value() == gone.across.has_value();
        });
    });
}

void BlendList::takeWeights(QTreeWidgetItem* item)
{
    if (m_isShowing)
        return;
    const auto row = static_cast<std::size_t>(m_blends->indexOfTopLevelItem(item));
    BlendEntry blend = m_variation.entry()->blends.at(row);
    if (!takeWeightsOf(blend, item->text(weightsColumn))) {
        refresh();
        return;
    }
    m_variation.edit(tr("Change the weights of a blend"), QStringLiteral("blends"),
                     [&](VariationEntry& entry) { entry.blends[row] = blend; });
    refresh();
}

bool BlendList::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int row = m_blends->indexOfTopLevelItem(m_blends->currentItem());
    if (row < 0 || (key != Qt::Key_Delete && key != Qt::Key_Return && key != Qt::Key_Enter))
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress && key == Qt::Key_Delete)
        remove(row);
    else if (event->type() == QEvent::KeyPress)
        m_blends->editItem(m_blends->topLevelItem(row), weightsColumn);
    event->accept();
    return true;
}

} // namespace quadrille

#include "moc_blendlist.cpp"
