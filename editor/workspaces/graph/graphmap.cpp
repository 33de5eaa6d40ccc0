// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphmap.h"

#include "editor/fields/actionbutton.h"
#include "editor/jobs/jobrunner.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "widgets/graph/arcview.h"
#include "widgets/graph/matrixview.h"
#include "widgets/graph/takegraphview.h"
#include "widgets/theme/theme.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

using widgets::ArcView;
using widgets::MatrixView;
using widgets::TakeGraphView;

constexpr int sampledCells = 200000; // for what the filter keeps

struct Picture
{
    std::shared_ptr<const widgets::MatrixPyramid> pyramid;
    widgets::ScalarRange range;
    double kept = 1; ///< share of the transitions that pass the filter
};

widgets::ScalarRange shownRange(const CostRange& range)
{
    widgets::ScalarRange shown;
    shown.minimum = range.minimum;
    shown.maximum = range.maximum;
    return shown;
}

/// The share of transitions that pass, judged by some of them.
double keptBy(const widgets::MatrixFilter& filter, const widgets::MatrixValues& values)
{
    const auto count = static_cast<std::size_t>(values.side) * static_cast<std::size_t>(values.side);
    const std::size_t step = std::max<std::size_t>(count / sampledCells, 1);
    std::size_t looked = 0;
    std::size_t passing = 0;
    for (std::size_t i = 0; i < count; i += step) {
        const float value = values.values.get()[i];
        if (!(value < std::numeric_limits<float>::infinity()))
            continue;
        ++looked;
        passing += filter.passes(value, values.lengths.get()[i]) ? 1 : 0;
    }
    return looked > 0 ? static_cast<double>(passing) / static_cast<double>(looked) : 1;
}

Picture makePicture(const TransitionCosts& costs, const widgets::MatrixValues& values,
                    const widgets::MatrixFilter& filter, const Progress& progress)
{
    Picture picture;
    picture.range = shownRange(costRange(costs.cost()));
    if (filter != widgets::MatrixFilter())
        picture.kept = keptBy(filter, values);
    picture.pyramid =
        widgets::buildMatrixPyramid(values, static_cast<float>(picture.range.minimum),
                                    static_cast<float>(picture.range.maximum), filter, [&progress] {
                                        progress.report(0);
                                        return false;
                                    });
    return picture;
}

} // namespace

QString costUnit(const GraphExplorer& explorer)
{
    const auto& opened = explorer.character();
    return costUnit(opened ? opened->graph.work().graph.pose.metric : PoseMetric::Surface);
}

QString costUnit(PoseMetric metric)
{
    return metric == PoseMetric::Surface ? GraphMap::tr("rad") : GraphMap::tr("m");
}

GraphMap::GraphMap(GraphExplorer& explorer, FramePictures& pictures, JobRunner& jobs, QWidget* parent)
    : QWidget(parent)
    , m_explorer(explorer)
    , m_pictures(pictures)
    , m_jobs(jobs)
    , m_pages(new QStackedWidget)
    , m_matrix(new MatrixView)
    , m_arcs(new ArcView)
    , m_takes(new TakeGraphView)
    , m_filters(new QWidget)
    , m_tools(new QHBoxLayout)
    , m_costLabel(new QLabel)
    , m_largestCost(new QDoubleSpinBox)
    , m_lengthLabel(new QLabel)
    , m_shortest(new QSpinBox)
    , m_longest(new QSpinBox)
    , m_kept(new QLabel)
    , m_takeFilter(new QToolButton)
{
    setObjectName(QStringLiteral("graphMap"));
    m_matrix->setObjectName(QStringLiteral("graphMatrix"));
    m_arcs->setObjectName(QStringLiteral("graphArcs"));
    m_takes->setObjectName(QStringLiteral("graphTakes"));
    makeFilters();
    makeTakeFilter();
    for (QWidget* page : std::initializer_list<QWidget*>{m_matrix, m_arcs, m_takes})
        m_pages->addWidget(page);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_tools->setContentsMargins(8, 4, 8, 0);
    m_tools->setSpacing(2);
    m_tools->addWidget(m_kept, 1);
    m_tools->addWidget(m_takeFilter);
    column->addLayout(m_tools);
    column->addWidget(m_filters);
    column->addWidget(m_pages, 1);
    connectViews();
    connect(&explorer, &GraphExplorer::characterChanged, this, &GraphMap::followCharacter);
    connect(&explorer, &GraphExplorer::characterReplaced, this, &GraphMap::followReplacement);
    connect(&explorer, &GraphExplorer::graphsChanged, this, &GraphMap::followGraphs);
    connect(&explorer, &GraphExplorer::filterChanged, this, &GraphMap::showTakeFilter);
    connect(&pictures, &FramePictures::drawn, this, &GraphMap::showPictures);
    retranslates(this, [this] { retranslate(); });
}

void GraphMap::makeFilters()
{
    m_largestCost->setObjectName(QStringLiteral("filterCost"));
    m_largestCost->setDecimals(3);
    m_largestCost->setRange(0, 0);
    m_shortest->setObjectName(QStringLiteral("filterShortest"));
    m_longest->setObjectName(QStringLiteral("filterLongest"));
    m_kept->setObjectName(QStringLiteral("filterKept"));
    m_kept->setForegroundRole(QPalette::PlaceholderText);
    m_kept->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_costLabel->setBuddy(m_largestCost);
    m_lengthLabel->setBuddy(m_shortest);
    auto* row = new QHBoxLayout(m_filters);
    row->setContentsMargins(8, 0, 8, 4);
    row->setSpacing(4);
    row->addWidget(m_costLabel);
    row->addWidget(m_largestCost);
    row->addSpacing(8);
    row->addWidget(m_lengthLabel);
    row->addWidget(m_shortest);
    row->addWidget(new QLabel(QStringLiteral("–")));
    row->addWidget(m_longest);
    row->addStretch(1);
    for (QAbstractSpinBox* field :
         {static_cast<QAbstractSpinBox*>(m_largestCost), static_cast<QAbstractSpinBox*>(m_shortest),
          static_cast<QAbstractSpinBox*>(m_longest)}) {
        field->setFont(widgets::Theme::tabularFont(field->font()));
        field->setAlignment(Qt::AlignRight);
    }
    connect(m_largestCost, &QDoubleSpinBox::valueChanged, this, &GraphMap::followFilter);
    connect(m_shortest, &QSpinBox::valueChanged, this, &GraphMap::followFilter);
    connect(m_longest, &QSpinBox::valueChanged, this, &GraphMap::followFilter);
}

void GraphMap::addTools(const QList<QAction*>& actions)
{
    for (QAction* action : actions) {
        if (action == nullptr) {
            m_tools->insertSpacing(m_tools->count() - 2, 8);
            continue;
        }
        m_tools->insertWidget(m_tools->count() - 2, makeActionButton(action));
    }
}

void GraphMap::connectViews()
{
    const auto end = [this] { emit hovered(std::nullopt); };
    connect(m_matrix, &MatrixView::cellHovered, this, [this](int row, int column) {
        emit hovered(FramePair{row, column});
    });
    connect(m_matrix, &MatrixView::hoverEnded, this, end);
    connect(m_matrix, &MatrixView::currentCellChanged, this, [this](int row, int column) {
        emit moved(FramePair{row, column});
    });
    connect(m_matrix, &MatrixView::cellActivated, this, [this](int row, int column) {
        emit activated(FramePair{row, column});
    });
    connect(m_matrix, &MatrixView::menuRequested, this, [this](int row, int column, const QPoint& place) {
        emit menuRequested(FramePair{row, column}, place);
    });
    connect(m_arcs, &ArcView::arcHovered, this, [this](int from, int to) {
        emit hovered(FramePair{from, to});
    });
    connect(m_arcs, &ArcView::hoverEnded, this, end);
    connect(m_arcs, &ArcView::arcActivated, this, [this](int from, int to) {
        emit activated(FramePair{from, to});
    });
}

void GraphMap::setFps(double fps)
{
    m_fps = fps;
    retranslate();
}

void GraphMap::setCurrent(const std::optional<FramePair>& pair)
{
    if (!pair) {
        m_matrix->setCurrentCell(std::nullopt);
        return;
    }
    const widgets::MatrixCell cell{pair->source, pair->destination};
    m_matrix->setCurrentCell(cell);
    m_matrix->reveal(cell);
}

void GraphMap::followCharacter()
{
    if (m_job)
        m_job->cancel();
    m_job.clear();
    m_shown.reset();
    m_pyramid.reset();
    const auto& opened = m_explorer.character();
    std::vector<widgets::MatrixBlock> blocks;
    std::vector<widgets::ArcSequence> sequences;
    std::vector<widgets::TakeNode> nodes;
    if (opened) {
        const FrameLayout& layout = opened->graph.layout();
        for (int s = 0; s < layout.sequenceCount(); ++s) {
            const QString name =
                QString::fromStdString(opened->graph.work().sequences[static_cast<std::size_t>(s)]);
            blocks.push_back({name, layout.countOf(s)});
            sequences.push_back({name, layout.countOf(s), widgets::Theme::categorical(s)});
            nodes.push_back({name, widgets::Theme::categorical(s), {}});
        }
    }
    // What shows from afar stays until the same costs are drawn from their table.
    const bool showsOverview = opened && m_overview && m_overview->layout == opened->graph.layout();
    if (!showsOverview)
        m_matrix->setMatrix({}, nullptr, {});
    m_matrix->setBlocks(std::move(blocks));
    m_matrix->setEnabled(true);
    m_arcs->setSequences(std::move(sequences));
    m_takes->setNodes(std::move(nodes));
    showPictures();
    retranslate();
    buildPicture();
}

void GraphMap::showOverview(std::shared_ptr<const CostOverview> overview, const QStringList& sequences,
                            PoseMetric metric)
{
    if (overview == m_overview)
        return;
    m_overview = std::move(overview);
    if (m_explorer.character())
        return;
    m_matrix->setEnabled(!m_overview);
    if (!m_overview) {
        m_matrix->setMatrix({}, nullptr, {});
        return;
    }
    std::vector<widgets::MatrixBlock> blocks;
    blocks.reserve(static_cast<std::size_t>(m_overview->layout.sequenceCount()));
    for (int s = 0; s < m_overview->layout.sequenceCount(); ++s)
        blocks.push_back({sequences.value(s), m_overview->layout.countOf(s)});
    const widgets::MatrixOverview known{
        .side = m_overview->layout.frameCount(),
        .cellsEach = m_overview->framesOfCell,
        .least = std::shared_ptr<const float>(m_overview, m_overview->least.data())};
    widgets::ScalarRange range = shownRange(m_overview->range);
    range.title = tr("Cost");
    range.unit = costUnit(metric);
    m_matrix->setBlocks(std::move(blocks));
    m_matrix->setMatrix({.side = known.side},
                        widgets::buildMatrixPyramid(known, static_cast<float>(range.minimum),
                                                    static_cast<float>(range.maximum)),
                        range);
}

void GraphMap::followReplacement()
{
    if (m_pyramid)
        m_matrix->setMatrix(values(), m_pyramid, m_range);
}

widgets::MatrixValues GraphMap::values() const
{
    const auto& opened = m_explorer.character();
    const TransitionCosts& costs = opened->graph.costs();
    return {static_cast<int>(opened->graph.layout().frameCount()),
            std::shared_ptr<const float>(opened, costs.cost().data()),
            std::shared_ptr<const std::uint16_t>(opened, costs.length().data())};
}

widgets::MatrixFilter GraphMap::filter() const
{
    widgets::MatrixFilter filter;
    if (m_largestCost->value() > 0)
        filter.largestValue = static_cast<float>(m_largestCost->value());
    filter.leastLength = m_shortest->value();
    if (m_longest->value() > 0)
        filter.greatestLength = m_longest->value();
    return filter;
}

void GraphMap::followFilter()
{
    if (m_shown != filter())
        buildPicture();
}

/// Made for the newest filter; while one is made, others wait.
void GraphMap::buildPicture()
{
    if (!m_explorer.character() || (m_job && !m_job->isOver()))
        return;
    m_shown = filter();
    m_job = m_jobs.start(
        {.name = tr("Drawing the costs"), .receiver = this, .background = true},
        [opened = m_explorer.character(), values = values(), shown = *m_shown](const Progress& progress) {
            return makePicture(opened->graph.costs(), values, shown, progress);
        },
        [this](Picture picture) {
            m_job.clear();
            picture.range.title = tr("Cost");
            picture.range.unit = costUnit(m_explorer);
            m_pyramid = picture.pyramid;
            m_range = picture.range;
            m_matrix->setMatrix(values(), m_pyramid, m_range);
            m_largestCost->setMaximum(std::max(m_range.maximum * 10, 0.001));
            m_largestCost->setSingleStep(std::max(m_range.maximum / 20, 0.001));
            m_kept->setText(picture.kept < 1 ? tr("%1 % in colour")
                                                   .arg(QLocale().toString(100 * picture.kept, 'f',
                                                                           picture.kept < 0.1 ? 1 : 0))
                                             : QString());
            followFilter();
        });
}

void GraphMap::retranslate()
{
    m_matrix->setAccessibleName(tr("Costs of transitions"));
    m_arcs->setAccessibleName(tr("Transitions as arcs"));
    const QString empty = tr("Rows are the frames that transitions leave, columns those where they arrive.");
    m_matrix->setEmptyText(empty);
    m_arcs->setEmptyText(tr("Sequences as bars, with the transitions between their frames as arcs."));
    m_takes->setAccessibleName(tr("Takes and the transitions between them"));
    m_takes->setEmptyText(
        tr("Takes with their pictures, and how many transitions lead from one to another."));
    m_costLabel->setText(tr("&Cost up to"));
    m_largestCost->setSuffix(QLatin1Char(' ') + costUnit(m_explorer));
    m_largestCost->setSpecialValueText(tr("any"));
    m_largestCost->setToolTip(tr("Transitions that cost more are greyed; 0 shows all"));
    m_lengthLabel->setText(tr("&Length"));
    const QString tip = tr("Transitions that last shorter or longer, in frames (%1 a second), are greyed")
                            .arg(QLocale().toString(m_fps));
    for (QSpinBox* field : {m_shortest, m_longest}) {
        field->setRange(0, 9999);
        field->setToolTip(tip);
        field->setSpecialValueText(tr("any"));
    }
    m_largestCost->setAccessibleName(tr("Greatest cost shown"));
    m_shortest->setAccessibleName(tr("Least length shown"));
    m_longest->setAccessibleName(tr("Greatest length shown"));
    followGraphs();
}

} // namespace quadrille

#include "moc_graphmap.cpp"
