// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/detours.h"
#include "tests/model/graph/randomtransitions.h"

#include <gtest/gtest.h>
#include <numeric>
#include <tbb/global_control.h>

using namespace quadrille;

namespace {

/// The cheapest way between two nodes that does not take the edge between them.
double plainDetour(const Table<double>& weights, NodeIndex from, NodeIndex to)
{
    return bellmanFord(weights, from, to)[static_cast<std::size_t>(to)];
}

struct DetourCase
{
    NodeIndex nodes;
    double density;
    int levels;
};

using Search = Table<double> (*)(const Table<double>&, const Progress&);

class Detours : public ::testing::TestWithParam<std::tuple<DetourCase, Search>>
{
};

class DetourSearch : public ::testing::TestWithParam<Search>
{
};

Table<double> denseDetours(const Table<double>& weights, const Progress& progress)
{
    Table<double> detours = Table<double>::Constant(weights.rows(), weights.cols(), unreachable);
    std::vector<NodeIndex> all(static_cast<std::size_t>(weights.rows()));
    std::iota(all.begin(), all.end(), 0);
    lowerDetoursDensely(weights, all, detours, progress);
    return detours;
}

Table<double> sparseDetours(const Table<double>& weights, const Progress& progress)
{
    Table<double> detours = Table<double>::Constant(weights.rows(), weights.cols(), unreachable);
    lowerDetoursSparsely(weights, detours, progress);
    return detours;
}

const auto searches = ::testing::Values(&denseDetours, &sparseDetours, &cheapestDetours);

// Sizes around those of tiles (16 columns, 4 rows), bands and lanes (32 rows) and rounds (64 nodes).
INSTANTIATE_TEST_SUITE_P(
    Sizes, Detours,
    ::testing::Combine(::testing::Values(DetourCase{1, 1, 0}, DetourCase{2, 1, 0}, DetourCase{5, 0.5, 3},
                                         DetourCase{16, 0.3, 0}, DetourCase{17, 0.3, 5},
                                         DetourCase{33, 0.1, 0}, DetourCase{63, 0.2, 4},
                                         DetourCase{64, 0.05, 0}, DetourCase{65, 0.1, 6},
                                         DetourCase{130, 0.03, 3}, DetourCase{147, 0.5, 0}),
                       searches));
INSTANTIATE_TEST_SUITE_P(Searches, DetourSearch, searches);

} // namespace

TEST_P(Detours, AreTheCheapestWaysRoundAnEdge)
{
    const auto [nodes, density, levels] = std::get<DetourCase>(GetParam());
    const Table<double> weights =
        weightTable(randomDigraph(static_cast<std::uint32_t>(nodes), nodes, density, levels));
    const Table<double> detours = std::get<Search>(GetParam())(weights, {});
    const Table<double> paths = plainPathCosts(weights);
    ASSERT_EQ(detours.rows(), nodes);
    ASSERT_EQ(detours.cols(), nodes);
    // Few sums of numbers up to 1 in another order: 1e-12.
    constexpr double tolerance = 1e-12;
    for (NodeIndex i = 0; i < nodes; ++i) {
        for (NodeIndex j = 0; j < nodes; ++j) {
            if (i == j)
                continue;
            const double shortest = std::min(weights(i, j), detours(i, j));
            if (paths(i, j) == unreachable) {
                EXPECT_EQ(shortest, unreachable);
            } else {
                EXPECT_NEAR(shortest, paths(i, j), tolerance) << i << " to " << j;
            }
            if (nodes > 65)
                continue;
            const double detour = plainDetour(weights, i, j);
            if (detour <= weights(i, j) && detour < unreachable) {
                EXPECT_NEAR(detours(i, j), detour, tolerance) << i << " to " << j;
            } else {
                EXPECT_GE(detours(i, j), std::min(weights(i, j), detour)) << i << " to " << j;
            }
        }
    }
}

TEST_P(DetourSearch, OfADiamondAreItsOtherSides)
{
    // 0 → 3 directly, or by 1 or 2.
    Table<double> weights = Table<double>::Constant(4, 4, unreachable);
    weights(0, 3) = 10;
    weights(0, 1) = 2;
    weights(1, 3) = 3;
    weights(0, 2) = 1;
    weights(2, 3) = 3;
    weights(3, 0) = 0.5;
    const Table<double> detours = GetParam()(weights, {});
    EXPECT_EQ(detours(0, 3), 4);
    EXPECT_GT(detours(0, 1), 2) << "no way round: dearer than the edge";
    EXPECT_EQ(detours(1, 0), 3.5);
    EXPECT_EQ(detours(1, 2), 4.5);
    EXPECT_EQ(detours(0, 0), 4.5);
}

TEST_P(DetourSearch, DoNotReadTheDiagonal)
{
    Table<double> weights = weightTable(randomDigraph(3, 20, 0.3, 0));
    const Table<double> detours = GetParam()(weights, {});
    weights.matrix().diagonal().setZero();
    EXPECT_TRUE((GetParam()(weights, {}) == detours).all());
}

TEST_P(DetourSearch, OfNoNodesAreNone)
{
    EXPECT_EQ(GetParam()(Table<double>(0, 0), {}).size(), 0);
}

TEST_P(DetourSearch, DoNotDependOnTheNumberOfThreads)
{
    const Table<double> weights = weightTable(randomDigraph(8, 300, 0.1, 0));
    const Table<double> several = GetParam()(weights, {});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE((GetParam()(weights, {}) == several).all());
}

TEST_P(DetourSearch, StopWhenCancelled)
{
    CancelToken token;
    double reached = 0;
    const Progress progress(token, [&](double fraction) {
        reached = fraction;
        if (fraction > 0.3)
            token.cancel();
    });
    try {
        GetParam()(weightTable(randomDigraph(8, 300, 0.1, 0)), progress);
        FAIL() << "did not stop";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
    EXPECT_LT(reached, 0.9);
}

/// A chain of nodes, cut at every second one, where each part is known.
TEST(LowerDetours, JoinKnownPartsAtJunctions)
{
    constexpr NodeIndex nodes = 201;
    Table<double> weights = Table<double>::Constant(nodes, nodes, unreachable);
    Table<double> known = weights;
    std::vector<NodeIndex> junctions;
    for (NodeIndex i = 0; i + 1 < nodes; ++i) {
        weights(i, i + 1) = 1;
        if (i + 2 < nodes)
            known(i, i + 2) = 2;
        if (i % 2 == 0)
            junctions.push_back(i);
    }
    Table<double> dense = known;
    lowerDetoursDensely(weights, junctions, dense);
    Table<double> sparse = known;
    lowerDetoursSparsely(weights, sparse);
    for (NodeIndex i = 0; i < nodes; ++i) {
        for (NodeIndex j = 0; j < nodes; ++j) {
            const double expected = j >= i + 2 ? j - i : unreachable;
            EXPECT_EQ(dense(i, j), expected) << i << " to " << j;
            EXPECT_EQ(sparse(i, j), expected) << i << " to " << j;
        }
    }
}
