// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphexplorer.h"

#include "editor/jobs/jobrunner.h"
#include "model/graph/essentialedges.h"
#include "model/graph/measuredgraph.h"

#include <algorithm>
#include <array>
#include <utility>

namespace quadrille {

namespace {

/// Those of SMCAS Fig. 9 and some on both sides.
constexpr std::array<double, 12> comparedAlphas{0.001, 0.002, 0.005, 0.01, 0.02, 0.03,
                                                0.05,  0.1,   0.2,   0.3,  0.5,  1.0};

template <typename Value>
bool areEqual(const Table<Value>& a, const Table<Value>& b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           std::equal(a.data(), a.data() + a.size(), b.data());
}

bool haveSameTransitions(const OpenedCharacter& a, const OpenedCharacter& b)
{
    if (a.graph.hasTablesOf(b.graph))
        return true;
    return a.graph.layout() == b.graph.layout() && a.graph.work().sequences == b.graph.work().sequences &&
           areEqual(a.graph.costs().cost(), b.graph.costs().cost()) &&
           areEqual(a.graph.costs().length(), b.graph.costs().length());
}

/// Without thinned graphs, which take most of the time of compareGraphs.
GraphComparison compareAt(const TransitionCosts& costs, const std::vector<FramePair>& minima, double alpha,
                          const Progress& progress)
{
    const MeasuredGraph essential = measuredEssentialGraph(costs, alpha, progress);
    const Digraph motion = motionGraph(costs, minima, alpha);
    GraphComparison comparison;
    comparison.alpha = alpha;
    comparison.essential = graphStatistics(essential.graph, essential.pathCosts);
    comparison.motion = graphStatistics(motion, measuredPathCosts(motion, progress));
    return comparison;
}

bool isBusy(const QPointer<Job>& job)
{
    return job && !job->isOver();
}

} // namespace

GraphExplorer::GraphExplorer(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {}

GraphExplorer::~GraphExplorer() = default;

void GraphExplorer::cancelAll()
{
    for (QPointer<Job>* job : {&m_graphsJob, &m_pathsJob, &m_gapsJob, &m_comparing}) {
        if (*job)
            (*job)->cancel();
        job->clear();
    }
}

void GraphExplorer::setCharacter(std::shared_ptr<const OpenedCharacter> opened)
{
    if (opened == m_opened)
        return;
    const bool isSame = opened && m_opened && haveSameTransitions(*opened, *m_opened);
    m_opened = std::move(opened);
    if (isSame) {
        emit characterReplaced();
        return;
    }
    ++m_generation;
    cancelAll();
    m_graphs.reset();
    m_paths.reset();
    m_gaps.reset();
    m_comparison.clear();
    m_filter = {};
    emit characterChanged();
    emit filterChanged();
    computeGraphs();
}

void GraphExplorer::setAlpha(double alpha)
{
    if (alpha == m_alpha)
        return;
    m_alpha = alpha;
    computeGraphs();
}

void GraphExplorer::setFilter(TakeFilter filter)
{
    const bool isAll =
        m_opened && filter.takes.size() == static_cast<std::size_t>(m_opened->graph.layout().sequenceCount());
    if (isAll)
        filter = {};
    if (filter == m_filter)
        return;
    m_filter = std::move(filter);
    emit filterChanged();
}

void GraphExplorer::computeGraphs()
{
    if (!m_opened || isBusy(m_graphsJob) || (m_graphs && m_graphs->alpha == m_alpha))
        return;
    const auto minima = m_graphs ? m_graphs->minima : nullptr;
    m_graphsJob = m_jobs.start(
        {.name = tr("Graphs"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .background = true},
        [opened = m_opened, minima, alpha = m_alpha](const Progress& progress) {
            const TransitionCosts& costs = opened->graph.costs();
            auto made = std::make_shared<ExploredGraphs>();
            made->alpha = alpha;
            made->minima = minima;
            if (!minima)
                made->minima = std::make_shared<const std::vector<FramePair>>(
                    costMinima(costs, opened->graph.work().graph.smoothing, progress));
            made->essential = essentialEdges(costs, alpha, progress);
            made->motion = motionGraph(costs, *made->minima, alpha);
            return std::shared_ptr<const ExploredGraphs>(std::move(made));
        },
        [this](std::shared_ptr<const ExploredGraphs> graphs) { take(std::move(graphs)); });
}

void GraphExplorer::take(std::shared_ptr<const ExploredGraphs> graphs)
{
    m_graphsJob.clear();
    m_graphs = std::move(graphs);
    emit graphsChanged();
    computeGraphs();
    computePaths();
}

void GraphExplorer::computePaths()
{
    if (!m_graphs || isBusy(m_pathsJob) || (m_paths && m_paths->graphs == m_graphs))
        return;
    m_pathsJob = m_jobs.start(
        {.name = tr("Path costs"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .background = true},
        [graphs = m_graphs](const Progress& progress) {
            auto made = std::make_shared<ExploredPaths>();
            made->graphs = graphs;
            made->essentialCosts = measuredPathCosts(graphs->essential, progress);
            made->motionCosts = measuredPathCosts(graphs->motion, progress);
            made->essentialConnectivity = connectivity(graphs->essential);
            made->motionConnectivity = connectivity(graphs->motion);
            return std::shared_ptr<const ExploredPaths>(std::move(made));
        },
        [this](std::shared_ptr<const ExploredPaths> paths) { take(std::move(paths)); });
}

void GraphExplorer::take(std::shared_ptr<const ExploredPaths> paths)
{
    m_pathsJob.clear();
    m_paths = std::move(paths);
    emit pathsChanged();
    computePaths();
    computeGaps();
}

void GraphExplorer::computeGaps()
{
    const bool isAtRest = m_paths && m_paths->graphs->alpha == m_alpha;
    if (!isAtRest || isBusy(m_gapsJob) || (m_gaps && m_gaps->alpha == m_alpha))
        return;
    m_gapsJob = m_jobs.start(
        {.name = tr("Gaps of the graphs"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .background = true},
        [opened = m_opened, paths = m_paths](const Progress& progress) {
            const CharacterGraph& graph = opened->graph;
            auto made = std::make_shared<ExploredGaps>();
            made->alpha = paths->graphs->alpha;
            made->essential = findGaps(paths->graphs->essential, paths->essentialConnectivity, graph.costs(),
                                       graph.distances(), made->alpha);
            progress.report(0.5);
            made->motion = findGaps(paths->graphs->motion, paths->motionConnectivity, graph.costs(),
                                    graph.distances(), made->alpha);
            return std::shared_ptr<const ExploredGaps>(std::move(made));
        },
        [this](std::shared_ptr<const ExploredGaps> gaps) {
            m_gapsJob.clear();
            m_gaps = std::move(gaps);
            emit gapsChanged();
            computeGaps();
            askForComparison();
        });
}

void GraphExplorer::askForComparison()
{
    if (!m_graphs || isBusy(m_comparing) || !m_comparison.empty())
        return;
    m_comparing = m_jobs.start(
        {.name = tr("Graphs against α"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .background = true},
        [opened = m_opened, minima = m_graphs->minima](const Progress& progress) {
            std::vector<GraphComparison> comparison;
            for (std::size_t i = 0; i < comparedAlphas.size(); ++i) {
                const double share = 1.0 / comparedAlphas.size();
                const auto part = static_cast<double>(i);
                comparison.push_back(compareAt(opened->graph.costs(), *minima, comparedAlphas[i],
                                               progress.part(part * share, (part + 1) * share)));
            }
            return comparison;
        },
        [this](std::vector<GraphComparison> comparison) {
            m_comparing.clear();
            m_comparison = std::move(comparison);
            emit comparisonChanged();
        });
    connect(m_comparing, &Job::ended, this, [this] { emit comparisonChanged(); });
}

} // namespace quadrille
