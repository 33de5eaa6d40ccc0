// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphexplorer.h"

#include "editor/jobs/jobrunner.h"

#include <algorithm>
#include <array>
#include <utility>

namespace quadrille {

namespace {

/// Those of SMCAS Fig. 9 and some on both sides.
constexpr std::array<double, 12> alphasToCompare{0.001, 0.002, 0.005, 0.01, 0.02, 0.03,
                                                 0.05,  0.1,   0.2,   0.3,  0.5,  1.0};

template <typename Value>
bool areEqual(TableView<Value> a, TableView<Value> b)
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
GraphComparison compareAt(const TransitionCosts& costs,
                          const std::shared_ptr<const std::vector<FramePair>>& minima, double alpha,
                          const Progress& progress)
{
    const MeasuredGraphs graphs =
        measured(std::make_shared<const GraphPair>(graphsAt(costs, minima, alpha, progress)), progress);
    GraphComparison comparison;
    comparison.alpha = alpha;
    comparison.essential = graphs.essential;
    comparison.motion = graphs.motion;
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
    for (QPointer<Job>* job : {&m_graphsJob, &m_gapsJob, &m_comparing}) {
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
    m_measured.reset();
    m_gaps.reset();
    m_comparison.clear();
    m_compared.clear();
    m_isComparisonWanted = false;
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
    // It goes on where it was once α rests.
    if (isBusy(m_comparing))
        m_comparing->cancel();
    m_comparing.clear();
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
    if (!m_opened || (m_measured && m_measured->graphs->alpha == m_alpha))
        return;
    if (isBusy(m_graphsJob)) {
        // Edges are shown while α moves; their paths wait until it rests.
        const bool hasEdges = m_graphs && m_graphs->alpha == m_computedAlpha;
        if (m_computedAlpha == m_alpha || !hasEdges)
            return;
        m_graphsJob->cancel();
    }
    m_computedAlpha = m_alpha;
    const auto stands = [this, generation = m_generation, alpha = m_alpha] {
        return generation == m_generation && alpha == m_computedAlpha;
    };
    m_graphsJob = m_jobs.start(
        {.name = tr("Graphs"), .receiver = this, .stillStands = stands, .background = true},
        [opened = m_opened, alpha = m_alpha, post = m_mailbox.address(), stands,
         hasMany = m_opened->graph.layout().frameCount() >= m_manyFrames, this](const Progress& progress) {
            return opened->graph.at(alpha, progress, [&](std::shared_ptr<const GraphPair> edges) {
                if (edges->isWhole || hasMany)
                    post.post([this, stands, edges = std::move(edges)] {
                        if (stands())
                            take(edges);
                    });
            });
        },
        [this](std::shared_ptr<const MeasuredGraphs> graphs) { take(std::move(graphs)); });
}

void GraphExplorer::take(std::shared_ptr<const GraphPair> graphs)
{
    if (graphs == m_graphs)
        return;
    m_graphs = std::move(graphs);
    emit graphsChanged();
    computeGraphs();
}

void GraphExplorer::take(std::shared_ptr<const MeasuredGraphs> measured)
{
    m_graphsJob.clear();
    m_measured = std::move(measured);
    if (std::exchange(m_graphs, m_measured->graphs) != m_measured->graphs)
        emit graphsChanged();
    emit pathsChanged();
    computeGraphs();
    computeGaps();
}

void GraphExplorer::computeGaps()
{
    const bool isAtRest = m_measured && m_measured->graphs->alpha == m_alpha;
    if (!isAtRest || isBusy(m_gapsJob))
        return;
    if (m_gaps && m_gaps->alpha == m_alpha) {
        askForComparison();
        return;
    }
    m_gapsJob = m_jobs.start(
        {.name = tr("Gaps of the graphs"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .background = true},
        [opened = m_opened, measured = m_measured](const Progress& progress) {
            const CharacterGraph& graph = opened->graph;
            auto made = std::make_shared<ExploredGaps>();
            made->alpha = measured->graphs->alpha;
            made->essential = findGaps(measured->graphs->essential, measured->essential.connectivity,
                                       graph.costs(), graph.distances(), made->alpha);
            progress.report(0.5);
            made->motion = findGaps(measured->graphs->motion, measured->motion.connectivity, graph.costs(),
                                    graph.distances(), made->alpha);
            graph.unloadTables();
            return std::shared_ptr<const ExploredGaps>(std::move(made));
        },
        [this](std::shared_ptr<const ExploredGaps> gaps) {
            m_gapsJob.clear();
            m_gaps = std::move(gaps);
            emit gapsChanged();
            computeGaps();
        });
}

bool GraphExplorer::comparesUnasked() const
{
    return m_isComparisonWanted || (m_opened && m_opened->graph.layout().frameCount() <= m_mostCompared);
}

std::pair<int, int> GraphExplorer::comparedAlphas() const
{
    return {static_cast<int>(m_compared.size()), static_cast<int>(alphasToCompare.size())};
}

void GraphExplorer::wantComparison()
{
    m_isComparisonWanted = true;
    askForComparison();
}

void GraphExplorer::askForComparison()
{
    if (!m_graphs || !comparesUnasked() || isBusy(m_comparing) || !m_comparison.empty())
        return;
    m_comparing = m_jobs.start(
        {.name = tr("Graphs against α"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .background = true},
        [opened = m_opened, minima = m_graphs->minima, alpha = alphasToCompare.at(m_compared.size())](
            const Progress& progress) { return compareAt(opened->graph.costs(), minima, alpha, progress); },
        [this](GraphComparison compared) {
            m_comparing.clear();
            m_compared.push_back(std::move(compared));
            if (m_compared.size() < alphasToCompare.size())
                askForComparison();
            else
                m_comparison = std::exchange(m_compared, {});
            emit comparisonChanged();
        });
    connect(m_comparing, &Job::ended, this, [this](Job::State state) {
        if (state != Job::State::Done)
            emit comparisonChanged();
    });
}

} // namespace quadrille

#include "moc_graphexplorer.cpp"
