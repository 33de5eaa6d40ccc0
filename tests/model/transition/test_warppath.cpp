// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transition/besttransitions.h"
#include "model/transition/warppath.h"
#include "plainwarppath.h"
#include "transitiontables.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <utility>

using namespace quadrille;

namespace {

void expectValidPath(const Transition& transition, int slope)
{
    ASSERT_FALSE(transition.path.empty());
    const auto [i, j] = transition.frames;
    EXPECT_EQ(transition.path.front(),
              (FramePair{.source = i, .destination = j - transition.destinationWindow + 1}));
    EXPECT_EQ(transition.path.back(),
              (FramePair{.source = i + transition.sourceWindow - 1, .destination = j}));
    int inARow = 0;
    FramePair stepBefore;
    for (std::size_t k = 1; k < transition.path.size(); ++k) {
        const FramePair step{.source = transition.path[k].source - transition.path[k - 1].source,
                             .destination =
                                 transition.path[k].destination - transition.path[k - 1].destination};
        ASSERT_TRUE(step.source == 0 || step.source == 1);
        ASSERT_TRUE(step.destination == 0 || step.destination == 1);
        ASSERT_GT(step.source + step.destination, 0);
        inARow = step == stepBefore ? inARow + 1 : 1;
        stepBefore = step;
        ASSERT_TRUE(step.source + step.destination == 2 || inARow <= slope);
    }
}

bool isBefore(const FramePair& one, const FramePair& other)
{
    return std::pair(one.source, one.destination) < std::pair(other.source, other.destination);
}

double costOf(const Transition& transition, const Table<float>& distances, TransitionCost cost)
{
    double sum = 0;
    for (const FramePair cell : transition.path)
        sum += static_cast<double>(distances(cell.source, cell.destination));
    return cost == TransitionCost::Sum ? sum : sum / transition.length();
}

} // namespace

TEST(WarpPaths, AreThoseOfTheTable)
{
    const FrameLayout layout(std::vector<std::int64_t>{26, 3, 21});
    for (const int slope : {2, 3, 4, 5}) {
        for (const TransitionCost cost : {TransitionCost::Sum, TransitionCost::Mean}) {
            for (const Table<float>& distances :
                 {randomDistances(50, 1), randomDistances(50, 2, 3), walkingDistances(50, 3, 11)}) {
                const TransitionSettings settings = windows(4, 13, slope, cost);
                const TransitionTable table = transitionTable(distances, layout, settings);
                const WarpPaths paths(distances, layout, settings);
                for (NodeIndex i = 0; i < 50; i += 2) {
                    for (NodeIndex j = 0; j < 50; ++j) {
                        const std::optional<Transition> found = paths.find({.source = i, .destination = j});
                        ASSERT_EQ(found.has_value(), table.length(i, j) > 0);
                        const std::optional<Transition> again =
                            paths.of(table, {.source = i, .destination = j});
                        ASSERT_EQ(again.has_value(), found.has_value());
                        if (!found)
                            continue;
                        ASSERT_EQ(found->cost, table.cost(i, j));
                        ASSERT_EQ(found->length(), table.length(i, j));
                        ASSERT_EQ(found->sourceWindow, table.sourceWindow(i, j));
                        ASSERT_EQ(found->destinationWindow, table.destinationWindow(i, j));
                        expectValidPath(*found, slope);
                        ASSERT_FLOAT_EQ(static_cast<float>(costOf(*found, distances, cost)), found->cost);
                        ASSERT_EQ(again->cost, found->cost);
                        ASSERT_EQ(again->path, found->path);
                    }
                }
            }
        }
    }
}

TEST(WarpPaths, AreThoseOfEachStateByItself)
{
    const FrameLayout layout(std::vector<std::int64_t>{60});
    for (const int slope : {2, 3, 5}) {
        for (const int levels : {2, 4, 1 << 20}) { // many ties, some, none
            const Table<float> distances = randomDistances(60, 7, levels);
            const WarpPaths paths(distances, layout, windows(3, 30, slope));
            for (const auto& [rows, columns] :
                 {std::pair{1, 1}, {1, 4}, {3, 9}, {9, 3}, {17, 25}, {30, 30}}) {
                const auto found = paths.between({.source = 2, .destination = 55}, rows, columns);
                const auto plain = plainWarpPath(distances.block(2, 56 - columns, rows, columns), slope);
                ASSERT_EQ(found.has_value(), !plain.empty()) << slope << ' ' << rows << ' ' << columns;
                if (!found)
                    continue;
                ASSERT_EQ(found->path.size(), plain.size());
                for (std::size_t k = 0; k < plain.size(); ++k)
                    EXPECT_EQ(found->path[k], (FramePair{.source = 2 + plain[k].first,
                                                         .destination = 56 - columns + plain[k].second}));
            }
        }
    }
}

TEST(WarpPaths, GoThroughTheCheapCells)
{
    // The destination does in six frames what the source does in four.
    Table<float> distances = Table<float>::Constant(10, 10, 1);
    const std::vector<FramePair> cheap{{0, 4}, {1, 5}, {1, 6}, {2, 7}, {2, 8}, {3, 9}};
    for (const FramePair cell : cheap)
        distances(cell.source, cell.destination) = 0.125F;
    const FrameLayout layout(std::vector<std::int64_t>{4, 6});
    const Transition found = WarpPaths(distances, layout, windows(4, 6)).get({.source = 0, .destination = 9});
    EXPECT_EQ(found.path, cheap);
    EXPECT_EQ(found.cost, 0.75F);
    EXPECT_EQ(found.sourceWindow, 4);
    EXPECT_EQ(found.destinationWindow, 6);
}

TEST(WarpPaths, LastAsLongAsTheirWindowsWhereTheyShould)
{
    // Four frames against six make five: the six cells without one in the middle.
    Table<float> distances = Table<float>::Constant(10, 10, 1);
    for (const FramePair cell : std::vector<FramePair>{{0, 4}, {1, 5}, {1, 6}, {2, 7}, {2, 8}, {3, 9}})
        distances(cell.source, cell.destination) = 0.125F;
    TransitionSettings settings = windows(4, 6);
    settings.length = TransitionLength::Windows;
    const FrameLayout layout(std::vector<std::int64_t>{4, 6});
    const Transition found = WarpPaths(distances, layout, settings).get({.source = 0, .destination = 9});
    EXPECT_EQ(found.path, (std::vector<FramePair>{{0, 4}, {1, 5}, {2, 7}, {2, 8}, {3, 9}}));
    EXPECT_EQ(found.cost, 0.75F) << "of all cells";
}

TEST(WarpPaths, CostTheSameHoweverLongTheyLast)
{
    const FrameLayout layout(std::vector<std::int64_t>{26, 3, 21});
    const Table<float> distances = randomDistances(50, 1);
    for (const TransitionCost cost : {TransitionCost::Sum, TransitionCost::Mean}) {
        TransitionSettings settings = windows(1, 13, 3, cost);
        const TransitionTable cells = transitionTable(distances, layout, settings);
        const WarpPaths whole(distances, layout, settings);
        settings.length = TransitionLength::Windows;
        const TransitionTable table = transitionTable(distances, layout, settings);
        const WarpPaths paths(distances, layout, settings);
        EXPECT_TRUE(table.cost == cells.cost);
        EXPECT_TRUE(table.windows == cells.windows);
        EXPECT_TRUE((*table.length <= *cells.length).all());
        for (NodeIndex i = 0; i < 50; i += 3) {
            for (NodeIndex j = 0; j < 50; ++j) {
                const std::optional<Transition> found = paths.of(table, {.source = i, .destination = j});
                ASSERT_EQ(found.has_value(), table.length(i, j) > 0);
                if (!found)
                    continue;
                const Transition from = whole.get(found->frames);
                ASSERT_EQ(found->length(), table.length(i, j));
                ASSERT_EQ(found->length(), (from.sourceWindow + from.destinationWindow + 1) / 2);
                ASSERT_EQ(found->path.front(), from.path.front());
                ASSERT_EQ(found->path.back(), from.path.back());
                ASSERT_TRUE(std::ranges::includes(from.path, found->path, isBefore));
            }
        }
    }
}

TEST(WarpPaths, RefuseTheImpossible)
{
    const Table<float> distances = randomDistances(20, 1);
    const FrameLayout layout(std::vector<std::int64_t>{12, 8});
    const WarpPaths paths(distances, layout, windows(4, 8, 2));
    const auto codeOf = [&](FramePair frames) {
        try {
            paths.get(frames);
        } catch (const Error& error) {
            return error.code();
        }
        return ErrorCode::Unexpected;
    };
    EXPECT_EQ(codeOf({.source = 9, .destination = 18}), ErrorCode::NoTransition);
    EXPECT_EQ(codeOf({.source = 2, .destination = 14}), ErrorCode::NoTransition);
    EXPECT_EQ(codeOf({.source = 2, .destination = 2}), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf({.source = -1, .destination = 14}), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf({.source = 3, .destination = 20}), ErrorCode::BadArgument);
    try {
        paths.get({.source = 9, .destination = 18});
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("from frame 9 to frame 18: it needs 4 frames"),
                  std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("have 3 and 7"), std::string::npos) << error.what();
    }
    EXPECT_FALSE(paths.find({.source = 9, .destination = 18}));
    // Two source frames cannot last for eight with two steps in a row.
    EXPECT_FALSE(paths.between({.source = 0, .destination = 19}, 2, 8));
    EXPECT_TRUE(paths.between({.source = 0, .destination = 19}, 2, 6));
}

TEST(WarpPaths, OfLinearTransitionsAreDiagonals)
{
    const Table<float> distances = randomDistances(30, 4);
    const FrameLayout layout(std::vector<std::int64_t>{15, 15});
    for (const TransitionCost cost : {TransitionCost::Sum, TransitionCost::Mean}) {
        const TransitionSettings settings = windows(5, 9, 3, cost);
        const TransitionTable table = linearTransitionTable(distances, layout, settings);
        const WarpPaths paths(distances, layout, settings);
        for (NodeIndex i = 0; i < 30; ++i) {
            for (NodeIndex j = 0; j < 30; ++j) {
                const std::optional<Transition> found = paths.linear({.source = i, .destination = j});
                ASSERT_EQ(found.has_value(), table.length(i, j) > 0);
                if (!found)
                    continue;
                expectValidPath(*found, 1);
                EXPECT_EQ(found->length(), 5);
                EXPECT_EQ(found->cost, table.cost(i, j));
            }
        }
    }
}

TEST(WarpPathTransitions, AreMinimaThatLieApart)
{
    const Table<float> distances = walkingDistances(160, 3);
    const FrameLayout layout(std::vector<std::int64_t>{80, 80});
    const TransitionTable table = transitionTable(distances, layout, {});
    const AlternativesRequest request{
        .sourceSequence = 0, .destinationSequence = 1, .count = 6, .spacing = 9};
    const std::vector<FramePair> best = bestTransitions(table, layout, request);
    ASSERT_GE(best.size(), 3U);
    ASSERT_LE(best.size(), 6U);
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    const float least = table.cost->block(0, 80, 80, 80).minCoeff(&row, &column);
    EXPECT_EQ(table.cost(best[0].source, best[0].destination), least);
    for (std::size_t a = 0; a < best.size(); ++a) {
        EXPECT_LT(best[a].source, 80);
        EXPECT_GE(best[a].destination, 80);
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_LE(table.cost(best[b].source, best[b].destination),
                      table.cost(best[a].source, best[a].destination));
            EXPECT_TRUE(std::abs(best[a].source - best[b].source) >= 9 ||
                        std::abs(best[a].destination - best[b].destination) >= 9);
        }
    }
}

TEST(WarpPathTransitions, AreFoundByHand)
{
    Table<float> costs = Table<float>::Constant(10, 10, 9);
    const auto table = [&costs] {
        return TransitionTable{.cost = SharedTable<float>(costs),
                               .length =
                                   SharedTable<std::uint16_t>(Table<std::uint16_t>::Constant(10, 10, 2)),
                               .windows = {}};
    };
    costs(1, 6) = 3;
    costs(4, 9) = 1;
    costs(3, 7) = 2; // no neighbour of (4, 9), but near
    costs(0, 5) = 8; // beside (1, 6): no minimum
    const FrameLayout layout(std::vector<std::int64_t>{5, 5});
    AlternativesRequest request{.sourceSequence = 0, .destinationSequence = 1, .count = 2, .spacing = 3};
    EXPECT_EQ(bestTransitions(table(), layout, request), (std::vector<FramePair>{{4, 9}, {1, 6}}));
    request.spacing = 2;
    request.count = 3;
    EXPECT_EQ(bestTransitions(table(), layout, request), (std::vector<FramePair>{{4, 9}, {3, 7}, {1, 6}}));
    // Inside one sequence, playing on from 1 to 2 is as fast as a transition of two frames.
    costs(1, 2) = 0;
    costs(3, 1) = 5;
    request = {.sourceSequence = 0, .destinationSequence = 0, .count = 1, .spacing = 3};
    EXPECT_EQ(bestTransitions(table(), layout, request), (std::vector<FramePair>{{3, 1}}));
    request.destinationSequence = 2;
    EXPECT_THROW(bestTransitions(table(), layout, request), Error);
}

TEST(WarpPathTransitions, AreNoneWhereNothingFits)
{
    const FrameLayout layout(std::vector<std::int64_t>{12, 4});
    const TransitionTable table = transitionTable(randomDistances(16, 1), layout, windows(5, 8));
    EXPECT_TRUE(bestTransitions(table, layout, {.sourceSequence = 0, .destinationSequence = 1}).empty());
    EXPECT_FALSE(bestTransitions(table, layout, {.sourceSequence = 0, .destinationSequence = 0}).empty());
}
