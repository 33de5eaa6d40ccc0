// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/samplespanel.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/variationresult.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/partlist.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/acrossfields.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace quadrille {

namespace {

constexpr int samplesMargin = 12;    // pixels
constexpr int leastListHeight = 130; // of the variations, pixels: a few of them and the header
constexpr int mostVariations = 10'000;
constexpr int greatestSeed = 999'999;

} // namespace

QString nameOf(const SamplesEntry& samples)
{
    QString of = QString::fromStdString(samples.of);
    if (samples.to.empty())
        return of;
    const auto pair = [](const QString& first, const std::string& second, double weight) {
        constexpr double percent = 100;
        //: two takes, and the share of the second
        return SamplesPanel::tr("%1 → %2, %3 %")
            .arg(first, QString::fromStdString(second), QLocale().toString(weight * percent, 'f', 0));
    };
    QString along = pair(of, samples.to, samples.weight);
    if (!samples.across)
        return along;
    //: two pairs of takes at the corners of a square
    return SamplesPanel::tr("%1 × %2").arg(
        along, pair(QString::fromStdString(samples.across->of), samples.across->to, samples.across->weight));
}

SamplesPanel::SamplesPanel(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent)
    , m_variation(variation)
    , m_pages(new QStackedWidget)
    , m_empty(new QLabel)
    , m_sets(new PartList(QStringLiteral("sampleSets")))
    , m_of(new QComboBox)
    , m_to(new QComboBox)
    , m_weight(new QSlider(Qt::Horizontal))
    , m_percent(new QSpinBox)
    , m_weightRow(new QWidget)
    , m_weightLabel(new QLabel)
    , m_across(new AcrossFields(variation))
    , m_acrossLabel(new QLabel)
    , m_count(new QSpinBox)
    , m_seed(new QSpinBox)
    , m_spread(new QDoubleSpinBox)
    , m_again(nullptr)
    , m_summary(new QLabel)
    , m_variations(new QTreeWidget)
{
    setObjectName(QStringLiteral("samplesPanel"));
    makeActions();
    m_empty->setObjectName(QStringLiteral("samplesEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setMargin(16);
    auto* content = new QWidget;
    auto* contentColumn = new QVBoxLayout(content);
    contentColumn->setContentsMargins(0, 0, 0, 0);
    contentColumn->setSpacing(8);
    contentColumn->addWidget(makeSets());
    contentColumn->addWidget(makeVariations(), 1);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(verticalScroll(content));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages);
    connectFields();
    connect(&variation, &CurrentVariation::changed, this, &SamplesPanel::refresh);
    connect(&variation, &CurrentVariation::resultChanged, this, &SamplesPanel::refreshVariations);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &SamplesPanel::refreshVariations);
    retranslates(this, [this] { retranslate(); });
}

QWidget* SamplesPanel::makeSets()
{
    ActionRegistry& actions = m_variation.context().actions;
    m_of->setObjectName(QStringLiteral("sampleOf"));
    m_to->setObjectName(QStringLiteral("sampleTo"));
    m_weight->setObjectName(QStringLiteral("sampleWeight"));
    m_percent->setObjectName(QStringLiteral("samplePercent"));
    m_count->setObjectName(QStringLiteral("sampleCount"));
    m_seed->setObjectName(QStringLiteral("sampleSeed"));
    m_spread->setObjectName(QStringLiteral("spread"));
    m_weight->setRange(0, 100);
    m_percent->setRange(0, 100);
    m_count->setRange(1, mostVariations);
    m_seed->setRange(0, greatestSeed);
    m_spread->setRange(0, greatestSpread);
    m_spread->setSingleStep(0.1);
    for (QAbstractSpinBox* field :
         std::initializer_list<QAbstractSpinBox*>{m_percent, m_count, m_seed, m_spread}) {
        field->setAlignment(Qt::AlignRight);
        field->setKeyboardTracking(false);
    }
    for (QComboBox* box : {m_of, m_to}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
    }
    m_again = makeActionButton(actions.action(QStringLiteral("variations.again")));
    auto* weightRow = new QHBoxLayout(m_weightRow);
    weightRow->setContentsMargins(0, 0, 0, 0);
    weightRow->addWidget(m_weight, 1);
    weightRow->addWidget(m_percent);
    auto* seedRow = new QHBoxLayout;
    seedRow->addWidget(m_seed, 1);
    seedRow->addWidget(m_again);
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(samplesMargin, 4, samplesMargin, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    auto* setButtons = new QHBoxLayout;
    setButtons->setSpacing(4);
    for (const char* id : {"variations.addSet", "variations.removeSet"})
        setButtons->addWidget(makeActionButton(actions.action(QLatin1String(id))));
    setButtons->addStretch(1);
    const auto addRow = [&](int row, std::function<QString()> text, QWidget* buddy) {
        auto* label = new QLabel;
        label->setBuddy(buddy);
        m_labels.emplaceBack(label, std::move(text));
        grid->addWidget(label, row, 0);
        return label;
    };
    grid->addLayout(setButtons, 0, 0, 1, 2);
    grid->addWidget(m_sets, 1, 0, 1, 2);
    addRow(
        2, [] { return tr("Of"); }, m_of);
    grid->addWidget(m_of, 2, 1);
    addRow(
        3, [] { return tr("Towards"); }, m_to);
    grid->addWidget(m_to, 3, 1);
    m_weightLabel = addRow(
        4, [] { return tr("Weight"); }, m_weight);
    grid->addWidget(m_weightRow, 4, 1);
    m_acrossLabel = addRow(
        5, [] { return tr("Across"); }, m_across);
    m_acrossLabel->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    grid->addWidget(m_across, 5, 1);
    addRow(
        6, [] { return tr("Count"); }, m_count);
    grid->addWidget(m_count, 6, 1);
    addRow(
        7, [] { return tr("Seed"); }, m_seed);
    grid->addLayout(seedRow, 7, 1);
    addRow(
        8, [] { return tr("Spread"); }, m_spread);
    grid->addWidget(m_spread, 8, 1);
    return page;
}

QWidget* SamplesPanel::makeVariations()
{
    ActionRegistry& actions = m_variation.context().actions;
    m_summary->setObjectName(QStringLiteral("samplesSummary"));
    m_summary->setWordWrap(true);
    m_summary->setForegroundRole(QPalette::PlaceholderText);
    m_summary->setContentsMargins(samplesMargin, 0, samplesMargin, 0);
    m_variations->setObjectName(QStringLiteral("drawnVariations"));
    m_variations->setRootIsDecorated(false);
    m_variations->setUniformRowHeights(true);
    m_variations->setAllColumnsShowFocus(true);
    m_variations->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_variations->setFrameShape(QFrame::NoFrame);
    m_variations->setColumnCount(5);
    m_variations->setMinimumHeight(leastListHeight);
    m_variations->header()->setTextElideMode(Qt::ElideRight);
    m_variations->header()->setStretchLastSection(false);
    m_variations->header()->setSectionResizeMode(QHeaderView::Stretch);
    m_variations->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_variations->installEventFilter(this);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(samplesMargin, 0, samplesMargin, 4);
    buttons->setSpacing(4);
    for (const char* id :
         {"variations.keep", "variations.discard", "variations.addSequence", "variations.export"}) {
        QToolButton* button = makeActionButton(actions.action(QLatin1String(id)));
        // What is done most says its name.
        if (buttons->count() < 2)
            button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        buttons->addWidget(button);
        m_variations->addAction(actions.action(QLatin1String(id)));
    }
    m_variations->setContextMenuPolicy(Qt::ActionsContextMenu);
    buttons->addStretch(1);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_summary);
    column->addLayout(buttons);
    column->addWidget(m_variations, 1);
    return page;
}

void SamplesPanel::connectFields()
{
    connect(m_sets, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!m_isShowing && row >= 0)
            m_variation.setSet(row);
    });
    connect(m_sets, &PartList::deletionRequested, this, [this] { removeSet(); });
    connect(m_of, &QComboBox::textActivated, this, [this](const QString& take) {
        editSet(tr("Vary another take"), "of", [&](SamplesEntry& set) {
            set.of = take.toStdString();
            if (set.to == set.of)
                set.to.clear();
            dropImpossibleAcross(set);
        });
    });
    connect(m_to, &QComboBox::activated, this, [this](int index) {
        editSet(tr("Vary a blend"), "to", [&](SamplesEntry& set) {
            constexpr double middle = 0.5;
            set.to = index == 0 ? std::string() : m_to->currentText().toStdString();
            set.weight = set.to.empty() ? 0 : set.weight > 0 ? set.weight : middle;
            dropImpossibleAcross(set);
        });
    });
    connect(m_weight, &QSlider::valueChanged, this, [this](int percent) {
        setWeight(percent, m_weight->isSliderDown() ? EditPhase::Dragging : EditPhase::Final);
    });
    connect(m_weight, &QSlider::sliderReleased, this,
            [this] { setWeight(m_weight->value(), EditPhase::Final); });
    connect(m_percent, &QSpinBox::valueChanged, this,
            [this](int percent) { setWeight(percent, EditPhase::Final); });
    connect(m_count, &QSpinBox::valueChanged, this, [this](int count) {
        editSet(tr("Change the number of variations"), "count",
                [count](SamplesEntry& set) { set.count = count; });
    });
    connect(m_seed, &QSpinBox::valueChanged, this, [this](int seed) {
        editSet(tr("Change the seed"), "seed", [seed](SamplesEntry& set) {
            set.seed = static_cast<std::uint64_t>(seed);
            set.discarded.clear();
        });
    });
    connect(m_spread, &QDoubleSpinBox::valueChanged, this, &SamplesPanel::setSpread);
    connect(m_variations, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isShowing)
            m_variation.setHidden(item->data(0, Qt::UserRole).toInt(), item->checkState(0) != Qt::Checked);
    });
    connect(m_variations, &QTreeWidget::itemSelectionChanged, this, &SamplesPanel::updateActions);
    connect(&m_variation, &CurrentVariation::picked, this, [this](int inSet, bool adds) {
        QTreeWidgetItem* item = m_variations->topLevelItem(inSet - 1);
        if (item == nullptr)
            return;
        m_variations->setCurrentItem(item, 0,
                                     adds ? QItemSelectionModel::Toggle | QItemSelectionModel::Rows
                                          : QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        m_variations->setFocus();
    });
}

void SamplesPanel::editSet(const QString& text, const char* property,
                           const std::function<void(SamplesEntry&)>& edit, EditPhase phase)
{
    if (m_isShowing || m_variation.samples() == nullptr)
        return;
    m_variation.edit(
        text, QLatin1String(property) + QString::number(m_variation.set()),
        [&](VariationEntry& entry) { edit(entry.samples[static_cast<std::size_t>(m_variation.set())]); },
        phase);
}

void SamplesPanel::setWeight(int percent, EditPhase phase)
{
    constexpr double whole = 100;
    editSet(
        tr("Change the weight of a blend"), "weight",
        [percent](SamplesEntry& set) { set.weight = percent / whole; }, phase);
}

void SamplesPanel::setSpread(double spread)
{
    if (!m_isShowing && m_variation.entry() != nullptr)
        m_variation.edit(tr("Change how far variations are apart"), QStringLiteral("spread"),
                         [spread](VariationEntry& entry) { entry.extent.spread = spread; });
}

void SamplesPanel::retranslate()
{
    for (const auto& [label, text] : m_labels)
        label->setText(text());
    m_sets->setAccessibleName(tr("What variations are drawn of"));
    m_of->setAccessibleName(tr("Of"));
    m_of->setToolTip(tr("The take that is varied"));
    m_to->setAccessibleName(tr("Towards"));
    m_to->setToolTip(
        tr("The second take of a blend; blend the two in the movement to learn the way between"));
    m_weight->setAccessibleName(tr("Weight"));
    m_weight->setToolTip(tr("The share of the second take"));
    m_percent->setAccessibleName(tr("Weight in percent"));
    m_percent->setSuffix(tr(" %", "percent"));
    m_count->setAccessibleName(tr("Count"));
    m_count->setToolTip(tr("How many variations are drawn"));
    m_seed->setAccessibleName(tr("Seed"));
    m_seed->setToolTip(tr("The same seed draws the same variations"));
    m_spread->setAccessibleName(tr("Spread"));
    m_spread->setToolTip(tr("How far variations are apart, as a share of how far the takes are; of all sets "
                            "alike. Usually %1")
                             .arg(QLocale().toString(VariationEntry().extent.spread)));
    m_variations->setAccessibleName(tr("Variations"));
    m_empty->setText(
        tr("Check the takes to learn from in the panel Movement; what is drawn of them comes here."));
    m_variations->setHeaderLabels({tr("No."), tr("Distance"), tr("Skate"), tr("Crossings"), tr("Volume")});
    QTreeWidgetItem* header = m_variations->headerItem();
    header->setToolTip(1, tr("Mean distance from the nearest pose that was learned from"));
    header->setToolTip(2, tr("How fast standing feet slide"));
    header->setToolTip(3, tr("Pairs of triangles that go through each other, most of a frame"));
    header->setToolTip(4, tr("How far the body’s volume leaves that of the takes"));
    refresh();
}

} // namespace quadrille
