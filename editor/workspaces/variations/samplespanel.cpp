// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/samplespanel.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/variationresult.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/partlist.h"
#include "editor/fields/sliderfield.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/acrossfields.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

namespace quadrille {

namespace {

constexpr int samplesMargin = 12;    // pixels
constexpr int leastListHeight = 130; // of the variations, pixels: a few of them and the header
constexpr double middle = 0.5;
constexpr double whole = 100; // percent

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
    , m_form(new LabelForm)
    , m_fields(*m_form, [this](const QString& text, const char* property,
                               const auto& change) { m_variation.editSet(text, property, change); })
    , m_common(*m_form,
               [this](const QString& text, const char* property, const auto& change) {
                   if (m_variation.entry() != nullptr)
                       m_variation.edit(text, QLatin1String(property), change);
               })
    , m_weight(new SliderField("sampleWeight", "samplePercent"))
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
    connectLists();
    connect(&variation, &CurrentVariation::changed, this, &SamplesPanel::refresh);
    connect(&variation, &CurrentVariation::resultChanged, this, &SamplesPanel::refreshVariations);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &SamplesPanel::refreshVariations);
    retranslates(this, [this] { retranslate(); });
}

QWidget* SamplesPanel::makeSets()
{
    ActionRegistry& actions = m_variation.context().actions;
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* sets = new QVBoxLayout;
    sets->setContentsMargins(samplesMargin, 4, samplesMargin, 0);
    sets->setSpacing(4);
    auto* setButtons = new QHBoxLayout;
    setButtons->setSpacing(4);
    for (const char* id : {"variations.addSet", "variations.removeSet"})
        setButtons->addWidget(makeActionButton(actions.action(QLatin1String(id))));
    setButtons->addStretch(1);
    sets->addLayout(setButtons);
    sets->addWidget(m_sets);
    column->addLayout(sets);
    auto* form = static_cast<QFormLayout*>(m_form->layout());
    form->setContentsMargins(samplesMargin, 4, samplesMargin, 0);
    form->setVerticalSpacing(4);
    column->addWidget(m_form);
    addTakes();
    addWeight();
    addAcrossFields(m_fields, m_variation);
    addDrawing();
    return page;
}

void SamplesPanel::addTakes()
{
    auto of = lensOf<SamplesEntry>(&SamplesEntry::of);
    of.set = [](SamplesEntry& set, std::string take) {
        set.of = std::move(take);
        if (set.to == set.of)
            set.to.clear();
        dropImpossibleAcross(set);
    };
    auto to = lensOf<SamplesEntry>(&SamplesEntry::to);
    to.set = [](SamplesEntry& set, std::string take) {
        set.to = std::move(take);
        set.weight = set.to.empty() ? 0 : set.weight > 0 ? set.weight : middle;
        dropImpossibleAcross(set);
    };
    m_fields.addItems({"sampleOf",
                       [] { return tr("Of"); },
                       [] { return tr("The take that is varied"); },
                       {},
                       [] { return tr("Vary another take"); }},
                      of, [this](const SamplesEntry& /*set*/) { return takeItems(m_variation, {}); });
    m_fields.addItems(
        {"sampleTo",
         [] { return tr("Towards"); },
         [] {
             return tr("The second take of a blend; blend the two in the movement to learn the way between");
         },
         {},
         [] { return tr("Vary a blend"); }},
        to, [this](const SamplesEntry& set) {
            auto items = takeItems(m_variation, {set.of});
            items.insert(items.begin(), {tr("nothing: the take alone"), std::string()});
            return items;
        });
}

void SamplesPanel::addWeight()
{
    connect(m_weight, &SliderField::edited, this, [this](int percent, bool isFinal) {
        m_variation.editSet(
            tr("Change the weight of a blend"), "sampleWeight",
            [percent](SamplesEntry& set) { set.weight = percent / whole; },
            isFinal ? EditPhase::Final : EditPhase::Dragging);
    });
    m_fields.addOther({"sampleWeightRow", [] { return tr("Weight"); },
                       [] { return tr("The share of the second take"); },
                       [](const SamplesEntry& set) { return !set.to.empty(); }},
                      m_weight, [this](const SamplesEntry& set) {
                          m_weight->setValue(static_cast<int>(std::lround(set.weight * whole)));
                      });
}

void SamplesPanel::addDrawing()
{
    m_fields.addNumber({"sampleCount",
                        [] { return tr("Count"); },
                        [] { return tr("How many variations are drawn"); },
                        {},
                        [] { return tr("Change the number of variations"); }},
                       &SamplesEntry::count,
                       {.path = "samples.count", .step = 1, .decimals = 0, .lowest = 1});
    auto seed = lensOf<SamplesEntry>(&SamplesEntry::seed);
    seed.set = [](SamplesEntry& set, std::uint64_t number) {
        set.seed = number;
        set.discarded.clear();
    };
    m_seed = m_fields.addNumber({"sampleSeed",
                                 [] { return tr("Seed"); },
                                 [] { return tr("The same seed draws the same variations"); },
                                 {},
                                 [] { return tr("Change the seed"); },
                                 makeActionButton(m_variation.context().actions.action("variations.again"))},
                                seed, {.path = "samples.seed", .step = 1, .decimals = 0});
    m_common.addNumber({"spread",
                        [] { return tr("Spread"); },
                        [] {
                            return tr("How far variations are apart, as a share of how far the takes are; of "
                                      "all sets alike. Usually %1")
                                .arg(QLocale().toString(TrajectoryLimits().spread));
                        },
                        {},
                        [] { return tr("Change how far variations are apart"); }},
                       at(&VariationEntry::extent, &TrajectoryLimits::spread), {.path = "sampling.spread"});
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

void SamplesPanel::connectLists()
{
    connect(m_sets, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!m_isShowing && row >= 0)
            m_variation.setSet(row);
    });
    connect(m_sets, &PartList::deletionRequested, this, [this] { removeSet(); });
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

void SamplesPanel::retranslate()
{
    m_fields.retranslate();
    m_common.retranslate();
    m_weight->setTexts(tr("Weight"), tr(" %", "percent"), tr("The share of the second take"));
    m_sets->setAccessibleName(tr("What variations are drawn of"));
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

#include "moc_samplespanel.cpp"
