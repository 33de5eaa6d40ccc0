// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/precomputedtransitions.h"
#include "tests/model/parametric/spacefixture.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A take alone, against itself: all pairs of frames at 1 but some.
struct HandMade
{
    MotionSpace space;
    SimilarityTable table;
};

HandMade handMade(bool isCyclic)
{
    HandMade made;
    made.space = makeSpace(
        {.frames = 10, .vertices = 3, .places = {{}}, .dimension = 0, .bisections = 0, .isCyclic = isCyclic});
    made.table = {.sourceFrames = 10, .targetFrames = 10, .sourceNodes = 1, .targetNodes = 1};
    made.table.distances.assign(100, 0.9F);
    made.table.distances[made.table.pairOf(4, 9)] = 1;
    made.table.distances[made.table.pairOf(2, 7)] = 0.2F;
    made.table.distances[made.table.pairOf(3, 8)] = 0.25F; // no minimum: 2, 7 is beside it
    made.table.distances[made.table.pairOf(9, 0)] = 0.1F;
    made.table.distances[made.table.pairOf(0, 0)] = 0.15F; // beside it only in a cycle
    made.table.leasts = made.table.distances;
    made.table.greatest = 1;
    return made;
}

} // namespace

TEST(PrecomputedTransitions, AreTheBestMinimaSomeFramesApart)
{
    const HandMade open = handMade(false);
    const PrecomputedTransitions three(open.table, open.space, open.space, {.count = 3});
    ASSERT_EQ(three.transitions().size(), 3U);
    EXPECT_EQ(three.transitions()[0].leavingFrame, 9U);
    EXPECT_NEAR(three.transitions()[0].dissimilarity, 100, 1e-4); // of floats
    EXPECT_EQ(three.transitions()[1].leavingFrame, 0U);
    EXPECT_EQ(three.transitions()[2].leavingFrame, 2U);
    EXPECT_EQ(three.transitions()[2].arrivalFrame, 7U);
    const HandMade cycle = handMade(true);
    const PrecomputedTransitions two(cycle.table, cycle.space, cycle.space, {.count = 2});
    ASSERT_EQ(two.transitions().size(), 2U);
    EXPECT_EQ(two.transitions()[1].leavingFrame, 2U);
    const PrecomputedTransitions all(cycle.table, cycle.space, cycle.space, {.count = 100, .apart = 11});
    EXPECT_EQ(all.transitions().size(), 1U);
}

TEST(PrecomputedTransitions, CostWhatTheWayToThemLasts)
{
    const HandMade cycle = handMade(true);
    const PrecomputedTransitions one(cycle.table, cycle.space, cycle.space, {.count = 1}); // 9 → 0
    const std::optional<TransitionChoice> choice = one.choose({3.4, {}}, {2, 2, {}});
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->sourceFrames, 6);
    EXPECT_EQ(choice->targetFrames, 2);
    EXPECT_NEAR(choice->cost(), 100 + 5 * 8, 1e-4);
    EXPECT_EQ(one.choose({0, {}}, {9, 9, {}})->targetFrames, 9);
    EXPECT_EQ(one.choose({9, {}}, {9, 1, {}})->targetFrames, 0); // any of 9, 0, 1
    const HandMade open = handMade(false);
    const PrecomputedTransitions ends(open.table, open.space, open.space, {.count = 2}); // 9 → 0, 0 → 0
    EXPECT_EQ(ends.choose({1, {}}, {0, 0, {}})->sourceFrames, 8);
    const PrecomputedTransitions three(open.table, open.space, open.space, {.count = 3, .latencyWeight = 50});
    EXPECT_EQ(three.choose({1, {}}, {8, 8, {}})->leavingFrame, 2U);
    const MotionSpace target = open.space;
    SimilarityTable late = open.table;
    std::fill(late.distances.begin(), late.distances.end(), 1.0F);
    late.distances[late.pairOf(0, 9)] = 0;
    late.leasts = late.distances;
    EXPECT_FALSE(PrecomputedTransitions(late, open.space, target, {.count = 1}).choose({1, {}}, {9, 9, {}}));
}

TEST(PrecomputedTransitions, WaitUntilThePlaceIsThere)
{
    // The node at 3 is the better one; from 1 to 3 there are ten steps, and a cycle has seven frames.
    const MotionSpace source = makeSpace({.frames = 7, .vertices = 3, .bisections = 0});
    const MotionSpace target =
        makeSpace({.frames = 7, .vertices = 3, .places = {{}}, .dimension = 0, .bisections = 0});
    SimilarityTable table{.sourceFrames = 7, .targetFrames = 7, .sourceNodes = 2, .targetNodes = 1};
    table.distances.assign(98, 1);
    table.leasts.assign(49, 1);
    table.distances[table.pairOf(2, 0) * 2 + 1] = table.leasts[table.pairOf(2, 0)] = 0.5F;
    table.greatest = 1;
    const PrecomputedTransitions one(table, source, target, {.count = 1});
    EXPECT_EQ(one.choose({0, {3}}, {0, 0, {}})->sourceFrames, 2);
    EXPECT_EQ(one.choose({0, {2.6}}, {0, 0, {}})->sourceFrames, 2);
    EXPECT_EQ(one.choose({0, {2.5}}, {0, 0, {}})->sourceFrames, 9);
    EXPECT_EQ(one.choose({0, {1}}, {0, 0, {}})->sourceFrames, 16);
    EXPECT_EQ(one.choose({0, {1}}, {0, 0, {}})->leavingPlace, SpacePoint{3});
}

TEST(PrecomputedTransitions, AreNoBetterThanTheSearchWithinItsDepth)
{
    const MotionSpace source = makeSpace({.seed = 1, .frames = 20});
    const MotionSpace target = makeSpace({.seed = 2, .frames = 16});
    const auto table = std::make_shared<const SimilarityTable>(similarities(source, target));
    TransitionSearch search(table, source, target);
    const PrecomputedTransitions fixed(*table, source, target);
    const std::vector<TransitionRequest> requests = randomRequests(source, target, 50, 3);
    int compared = 0;
    for (const TransitionRequest& request : requests) {
        const std::optional<TransitionChoice> choice = fixed.choose(request.source, request.goal);
        ASSERT_TRUE(choice);
        if (choice->sourceFrames > 12 || choice->targetFrames > 12)
            continue;
        ++compared;
        // Nodes are among the places of the search; rounding of sums.
        EXPECT_LE(search.search(request.source, request.goal).front().cost(), choice->cost() + 1e-9);
    }
    EXPECT_GT(compared, 10);
}

TEST(RandomRequests, AreWithinTheSpacesAndTheSameForASeed)
{
    const MotionSpace plane = makeSpace(
        {.frames = 6, .vertices = 3, .places = {{0, 0}, {1, 0}, {0, 1}}, .dimension = 2, .bisections = 0});
    const MotionSpace line = makeSpace({.frames = 9, .vertices = 3});
    const std::vector<TransitionRequest> requests = randomRequests(plane, line, 50, 3);
    for (const TransitionRequest& request : requests) {
        EXPECT_LT(request.source.frame, 6);
        EXPECT_LE(request.source.place[0] + request.source.place[1], 1 + 1e-12);
        EXPECT_LT(request.goal.firstFrame, 9U);
        EXPECT_TRUE(request.goal.place[0] >= 1 && request.goal.place[0] <= 3);
    }
    EXPECT_EQ(randomRequests(plane, line, 50, 3)[49].goal.place, requests[49].goal.place);
    EXPECT_NE(randomRequests(plane, line, 50, 4)[49].goal.place, requests[49].goal.place);
}
