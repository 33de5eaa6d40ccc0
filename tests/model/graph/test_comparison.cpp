// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/comparison.h"
#include "tests/model/graph/randomtransitions.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

const RandomTransitions takes{.seed = 21, .counts = {40, 30, 25}, .missing = 0.1, .shortest = 4};

void expectMeansOverCommonPairs(const GraphComparison& comparison, const Table<double>& essential,
                                const Table<double>& motion)
{
    double ofEssential = 0;
    double ofMotion = 0;
    std::int64_t pairs = 0;
    for (Eigen::Index i = 0; i < motion.rows(); ++i) {
        for (Eigen::Index j = 0; j < motion.cols(); ++j) {
            if (i == j || essential(i, j) == unreachable || motion(i, j) == unreachable)
                continue;
            ofEssential += essential(i, j);
            ofMotion += motion(i, j);
            ++pairs;
        }
    }
    ASSERT_GT(pairs, 0);
    const auto count = static_cast<double>(pairs);
    EXPECT_EQ(comparison.commonPairs, pairs);
    EXPECT_NEAR(comparison.essentialMeanOverCommonPairs, ofEssential / count, 1e-12); // another order
    EXPECT_NEAR(comparison.motionMeanOverCommonPairs, ofMotion / count, 1e-12);
}

} // namespace

TEST(CompareGraphs, TellsWhatEachGraphIs)
{
    const TransitionCosts costs = makeTransitions(takes);
    const auto minima = costMinima(costs);
    const GraphComparison comparison = compareGraphs(costs, minima, 0.05);
    const Digraph essential = essentialGraph(costs, 0.05).graph;
    const Digraph motion = motionGraph(costs, minima, 0.05);
    EXPECT_EQ(comparison.essential.edges, static_cast<std::int64_t>(essential.edges().size()));
    EXPECT_EQ(comparison.motion.edges, static_cast<std::int64_t>(motion.edges().size()));
    const PathCostSummary expected = summarizePathCosts(plainPathCosts(weightTable(motion)));
    EXPECT_NEAR(comparison.motion.pathCosts.mean, expected.mean, 1e-12); // sums in another order
    EXPECT_NEAR(comparison.motion.pathCosts.standardDeviation, expected.standardDeviation, 1e-12);
    EXPECT_LE(comparison.essential.pathCosts.mean, comparison.motion.pathCosts.mean);
}

TEST(CompareGraphs, BringsBothToOneDensity)
{
    const TransitionCosts costs = makeTransitions(takes);
    const auto minima = costMinima(costs);
    bool essentialLost = false;
    bool motionLost = false;
    for (const double alpha : {0.001, 0.5}) {
        const GraphComparison comparison = compareGraphs(costs, minima, alpha);
        EXPECT_EQ(comparison.essentialAtEqualDensity.edges, comparison.motionAtEqualDensity.edges);
        EXPECT_EQ(comparison.essentialAtEqualDensity.edges,
                  std::min(comparison.essential.edges, comparison.motion.edges));
        const Digraph essential = thinned(essentialGraph(costs, alpha).graph, comparison.motion.edges);
        const Digraph motion = thinned(motionGraph(costs, minima, alpha), comparison.essential.edges);
        expectMeansOverCommonPairs(comparison, plainPathCosts(weightTable(essential)),
                                   plainPathCosts(weightTable(motion)));
        essentialLost |= comparison.essentialAtEqualDensity.edges < comparison.essential.edges;
        motionLost |= comparison.motionAtEqualDensity.edges < comparison.motion.edges;
    }
    EXPECT_TRUE(essentialLost);
    EXPECT_TRUE(motionLost);
}

TEST(SweepAlpha, ComparesAtEveryAlphaOfFigure9)
{
    const TransitionCosts costs = makeTransitions(takes);
    const auto rows = sweepAlpha(costs, costMinima(costs));
    ASSERT_EQ(rows.size(), 6U);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        EXPECT_EQ(rows[row].alpha, figure9Alphas[row]);
        EXPECT_EQ(rows[row].motion.edges, rows[0].motion.edges) << "the minima do not depend on alpha";
        if (row > 0) {
            EXPECT_GT(rows[row].essential.pathCosts.mean, rows[row - 1].essential.pathCosts.mean);
        }
    }
}

TEST(SweepAlpha, ReportsProgressAndStops)
{
    const TransitionCosts costs = makeTransitions(takes);
    const auto minima = costMinima(costs);
    CancelToken token;
    std::vector<double> fractions;
    sweepAlpha(costs, minima, figure9Alphas,
               Progress(token, [&](double fraction) { fractions.push_back(fraction); }));
    EXPECT_GT(fractions.size(), 12U);
    EXPECT_EQ(fractions.back(), 1);
    token.cancel();
    EXPECT_THROW(sweepAlpha(costs, minima, figure9Alphas, Progress(token)), Error);
}

TEST(SweepAlpha, RefusesAnAlphaBelowZero)
{
    const TransitionCosts costs = makeTransitions(takes);
    EXPECT_THROW(sweepAlpha(costs, costMinima(costs), std::array{0.1, -0.1}), Error);
}
