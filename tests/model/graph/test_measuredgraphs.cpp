// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/essentialgraph.h"
#include "model/graph/measuredgraphs.h"
#include "model/graph/shortestpath.h"
#include "model/graph/walkrows.h"
#include "tests/model/graph/randomtransitions.h"

#include <gtest/gtest.h>
#include <mutex>

using namespace quadrille;

namespace {

Table<double> allRows(const Digraph& graph)
{
    Table<double> all = Table<double>::Constant(graph.nodeCount(), graph.nodeCount(), -1);
    std::mutex mutex;
    forEachWalkRows(graph, [&](NodeIndex first, const Table<double>& rows) {
        const std::scoped_lock lock(mutex);
        all.middleRows(first, rows.rows()) = rows;
    });
    return all;
}

void expectSameSummary(const PathCostSummary& given, const PathCostSummary& expected)
{
    EXPECT_EQ(given.reachablePairs, expected.reachablePairs);
    EXPECT_EQ(given.unreachablePairs, expected.unreachablePairs);
    EXPECT_NEAR(given.mean, expected.mean, 1e-12); // sums in another order
    EXPECT_NEAR(given.standardDeviation, expected.standardDeviation, 1e-12);
}

} // namespace

TEST(WalkRows, AreThoseOfThePlainPathCosts)
{
    // Weights are multiples of a power of two: sums are exact in any order.
    for (const double density : {0.0, 0.01, 0.05, 0.5}) {
        for (const NodeIndex nodes : {1, 31, 32, 33, 100}) {
            const Digraph graph = randomDigraph(7, nodes, density, 64);
            EXPECT_TRUE((allRows(graph) == plainPathCosts(weightTable(graph))).all())
                << nodes << " nodes, density " << density;
        }
    }
    EXPECT_EQ(allRows(Digraph()).size(), 0);
}

TEST(WalkRows, StopWhenCancelled)
{
    const Digraph graph = randomDigraph(1, 100, 0.1, 64);
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.4)
            token.cancel();
    });
    EXPECT_THROW(forEachWalkRows(
                     graph, [](NodeIndex, const Table<double>&) { /* not needed */ }, progress),
                 Error);
}

TEST(MeasuredGraphs, AreThoseThatTablesOfAllPairsGive)
{
    for (const double missing : {0.05, 0.6, 0.97, 1.0}) {
        const TransitionCosts costs =
            makeTransitions({.seed = 3, .counts = {40, 1, 50, 22}, .missing = missing});
        const auto minima = std::make_shared<const std::vector<FramePair>>(costMinima(costs));
        std::shared_ptr<const GraphPair> first;
        const auto graphs = std::make_shared<const GraphPair>(
            graphsAt(costs, minima, 0.02, {}, [&](auto begun) { first = std::move(begun); }));
        ASSERT_NE(first, nullptr);
        EXPECT_FALSE(first->isWhole);
        EXPECT_TRUE(graphs->isWhole);
        EXPECT_EQ(first->alpha, 0.02);
        EXPECT_EQ(first->motion, graphs->motion);
        EXPECT_LE(first->essential.edges().size(), graphs->essential.edges().size());
        const MeasuredGraphs both = measured(graphs);
        const EssentialGraph plain = essentialGraph(costs, 0.02);
        EXPECT_EQ(graphs->alpha, 0.02);
        EXPECT_EQ(graphs->essential, plain.graph);
        EXPECT_EQ(graphs->motion, motionGraph(costs, *minima, 0.02));
        EXPECT_EQ(both.graphs, graphs);
        EXPECT_EQ(both.essential.edges, static_cast<std::int64_t>(plain.graph.edges().size()));
        expectSameSummary(both.essential.pathCosts, summarizePathCosts(plain.pathCosts));
        expectSameSummary(both.motion.pathCosts, summarizePathCosts(shortestPathCosts(graphs->motion)));
    }
}
