// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/onlinetransition.h"
#include "tests/model/parametric/countallocations.h"
#include "tests/model/parametric/plaintransitions.h"
#include "tests/model/parametric/spacefixture.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A space whose poses nobody looks at.
MotionSpace placesOnly(int dimension, int bisections, bool isCyclic, std::size_t frames)
{
    RandomSpace made{.frames = frames, .vertices = 3, .isCyclic = isCyclic};
    const std::vector<std::vector<SpacePoint>> places{
        {{}},
        {{1}, {2}, {4}},
        {{0, 0}, {1, 0}, {0, 2}, {1, 2}, {0.5, 3}},
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.4, 0.4, 1}}};
    made.places = places[static_cast<std::size_t>(dimension)];
    made.dimension = dimension;
    made.bisections = dimension > 0 ? bisections : 0;
    return makeSpace(made);
}

/// Numbers that have nothing to do with each other; a few values only where there are to be ties.
std::shared_ptr<SimilarityTable> randomTable(const MotionSpace& source, const MotionSpace& target,
                                             std::uint64_t seed, int values = 1 << 20)
{
    Random random(seed);
    auto table =
        std::make_shared<SimilarityTable>(SimilarityTable{.sourceFrames = source.frameCount(),
                                                          .targetFrames = target.frameCount(),
                                                          .sourceNodes = source.weights.nodes().size(),
                                                          .targetNodes = target.weights.nodes().size()});
    table->leasts.resize(table->sourceFrames * table->targetFrames);
    table->distances.resize(table->leasts.size() * table->sourceNodes * table->targetNodes);
    for (float& distance : table->distances)
        distance = static_cast<float>(std::floor(random.between(0, values))) / static_cast<float>(values);
    for (std::size_t s = 0; s < table->sourceFrames; ++s)
        for (std::size_t t = 0; t < table->targetFrames; ++t)
            table->leasts[table->pairOf(s, t)] = std::ranges::min(table->block(s, t));
    table->greatest = std::ranges::max(table->distances);
    return table;
}

SpacePoint randomPlace(Random& random, int dimension)
{
    SpacePoint place{};
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
        place[d] = random.between(-0.5, 4.5); // also outside
    return place;
}

/// Some random searches against trying everything; the very same choices, to the last bit.
void expectExhaustive(int sourceDimension, int targetDimension, bool isCyclic,
                      const TransitionSearchSettings& settings, int values = 1 << 20)
{
    const MotionSpace source = placesOnly(sourceDimension, 1, isCyclic, 9);
    const MotionSpace target = placesOnly(targetDimension, 2, isCyclic, 7);
    const auto table = randomTable(source, target, 5, values);
    TransitionSearch search(table, source, target, settings);
    Random random(7);
    for (int round = 0; round < 12; ++round) {
        const SpaceState state{random.between(0, 9), randomPlace(random, sourceDimension)};
        TransitionGoal goal{.firstFrame = random.next() % 7, .place = randomPlace(random, targetDimension)};
        goal.lastFrame = round % 2 == 0 ? goal.firstFrame
                         : isCyclic     ? random.next() % 7
                                        : goal.firstFrame + random.next() % (7 - goal.firstFrame);
        const std::span<const TransitionChoice> found = search.search(state, goal);
        const std::vector<TransitionChoice> plain =
            plainTransitions(*table, source, target, state, goal, settings);
        ASSERT_EQ(found.size(), plain.size()) << round;
        for (std::size_t c = 0; c < plain.size(); ++c) {
            EXPECT_EQ(found[c].sourceFrames, plain[c].sourceFrames) << round << ' ' << c;
            EXPECT_EQ(found[c].targetFrames, plain[c].targetFrames) << round << ' ' << c;
            EXPECT_EQ(found[c].dissimilarity, plain[c].dissimilarity) << round << ' ' << c;
            EXPECT_EQ(found[c].endFrame, plain[c].endFrame) << round << ' ' << c;
            EXPECT_EQ(found[c].leavingFrame, plain[c].leavingFrame) << round << ' ' << c;
            EXPECT_EQ(found[c].arrivalFrame, plain[c].arrivalFrame) << round << ' ' << c;
            EXPECT_EQ(found[c].leavingPlace, plain[c].leavingPlace) << round << ' ' << c;
            EXPECT_EQ(found[c].arrivalPlace, plain[c].arrivalPlace) << round << ' ' << c;
        }
    }
}

} // namespace

TEST(TransitionPlaces, AreTheNodesAndAGridWithinTheSpace)
{
    const MotionSpace line = placesOnly(1, 1, true, 3);
    const TransitionPlaces places = transitionPlaces(line.weights, 10);
    EXPECT_EQ(places.places.size(), 5U + 11 - 2); // both ends are nodes
    EXPECT_DOUBLE_EQ(places.step[0], 0.3);
    EXPECT_EQ(framesBetween(places, {1}, {1}), 0);
    EXPECT_EQ(framesBetween(places, {1}, {1.3}), 1);
    EXPECT_EQ(framesBetween(places, {1.3}, {1}), 1);
    EXPECT_EQ(framesBetween(places, {1}, {1.31}), 2);
    EXPECT_EQ(framesBetween(places, {1}, {1.3}, 0.25), 4);
    EXPECT_EQ(framesBetween(places, {1}, {1.3}, 0.3), 4);

    const TransitionPlaces plane = transitionPlaces(placesOnly(2, 0, true, 3).weights, 6);
    EXPECT_DOUBLE_EQ(plane.step[1], 0.5);
    EXPECT_EQ(framesBetween(plane, {0, 0}, {0.5, 0.6}), 3); // the slower axis counts
    for (std::size_t a = 0; a < plane.places.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_NE(plane.places[a], plane.places[b]);
}

TEST(TransitionPlaces, OfATakeAloneAreItsOwn)
{
    const TransitionPlaces places = transitionPlaces(placesOnly(0, 0, true, 3).weights, 10);
    ASSERT_EQ(places.places.size(), 1U);
    EXPECT_EQ(framesBetween(places, {}, {}), 0);
}

TEST(TransitionSearch, FindsWhatTryingEverythingFinds)
{
    expectExhaustive(1, 1, true, {.depth = 5});
    expectExhaustive(1, 1, false, {.depth = 5});
    expectExhaustive(1, 1, true, {.depth = 12, .choices = 1}); // around the cycle, and again
    expectExhaustive(1, 1, true, {.depth = 4, .latencyWeight = 100, .choices = 3});
    expectExhaustive(1, 1, true, {.depth = 2, .choices = 100}); // there are no more than 9
    expectExhaustive(1, 1, true, {.depth = 7, .stepsAFrame = 0.3});
}

TEST(TransitionSearch, FindsWhatTryingEverythingFindsInThePlane)
{
    expectExhaustive(2, 2, true, {.depth = 4, .steps = 5});
    expectExhaustive(2, 1, false, {.depth = 4});
    expectExhaustive(0, 2, true, {.depth = 4, .choices = 1});
}

TEST(TransitionSearch, FindsWhatTryingEverythingFindsInSpace)
{
    expectExhaustive(3, 3, true, {.depth = 2, .steps = 3});
    expectExhaustive(3, 1, false, {.depth = 3, .steps = 4, .choices = 1});
    expectExhaustive(3, 0, true, {.depth = 3, .steps = 5});
}

TEST(TransitionSearch, TakesTheFirstOfThoseThatCostTheSame)
{
    expectExhaustive(1, 1, true, {.depth = 5}, 3);
    expectExhaustive(2, 1, false, {.depth = 3, .steps = 4}, 2);
    expectExhaustive(1, 1, true, {.depth = 4, .latencyWeight = 0.001}, 1); // all are 0
    expectExhaustive(0, 0, true, {.depth = 5, .latencyWeight = 250}, 4);   // l against m
}

TEST(TransitionSearch, GoesOverAtOnceWithoutATrellis)
{
    const MotionSpace space = placesOnly(1, 1, true, 5);
    TransitionSearch search(randomTable(space, space, 3), space, space, {.depth = 0});
    const std::span<const TransitionChoice> found = search.search({4.6, {1.1}}, {2, 2, {9}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].leavingFrame, 0U); // 4.6 is nearest to the first frame of the next round
    EXPECT_EQ(found[0].arrivalFrame, 2U);
    EXPECT_EQ(found[0].leavingPlace, SpacePoint{1.1});
    EXPECT_EQ(found[0].arrivalPlace, SpacePoint{4}); // outside counts as the nearest place
    EXPECT_EQ(found[0].latencyCost, 0);
}

TEST(TransitionSearch, WeighsALikenessAgainstTheWayToIt)
{
    // One take each, six frames; only frame 3 of the source is like frame 1 of the target.
    const MotionSpace space = placesOnly(0, 0, false, 6);
    const auto table = randomTable(space, space, 1);
    std::fill(table->distances.begin(), table->distances.end(), 1.0F);
    table->distances[table->pairOf(3, 1)] = 0.5F;
    table->leasts = table->distances;
    table->greatest = 1;
    TransitionSearch search(table, space, space, {.latencyWeight = 5});
    const TransitionChoice found = search.search({1, {}}, {3, 3, {}}).front();
    EXPECT_EQ(found.sourceFrames, 2);
    EXPECT_EQ(found.targetFrames, 2);
    EXPECT_DOUBLE_EQ(found.cost(), 500 + 20);
    TransitionSearch hasty(table, space, space, {.latencyWeight = 126});
    EXPECT_EQ(hasty.search({1, {}}, {3, 3, {}}).front().cost(), 1000);
    // Of several end frames the one that is there at once.
    const TransitionChoice early = search.search({1, {}}, {0, 5, {}}).front();
    EXPECT_EQ(early.sourceFrames, 2);
    EXPECT_EQ(early.targetFrames, 0);
    EXPECT_EQ(early.endFrame, 1U);
    // There is no way back in a space without a cycle.
    EXPECT_EQ(search.search({4, {}}, {3, 3, {}}).front().cost(), 1000);
}

TEST(TransitionSearch, AllocatesNothing)
{
    for (const int dimension : {1, 2}) {
        const MotionSpace source = placesOnly(dimension, 2, true, 20);
        const MotionSpace target = placesOnly(1, 2, true, 20);
        TransitionSearch search(randomTable(source, target, 3), source, target, {.steps = 5});
        Random random(1);
        const std::size_t before = allocationCount();
        for (int round = 0; round < 10; ++round)
            search.search({random.between(0, 20), randomPlace(random, dimension)},
                          {0, random.next() % 20, randomPlace(random, 1)});
        EXPECT_EQ(allocationCount(), before);
    }
}

TEST(TransitionSearch, FindsTheSameAgain)
{
    const MotionSpace space = placesOnly(2, 2, true, 8);
    TransitionSearch search(randomTable(space, space, 3), space, space);
    const auto found = [&](double frame) {
        const std::span<const TransitionChoice> choices =
            search.search({frame, {0.3, 0.4}}, {1, 3, {0.9, 0}});
        return std::vector(choices.begin(), choices.end());
    };
    const std::vector<TransitionChoice> first = found(2);
    EXPECT_NE(found(5), first);
    EXPECT_EQ(found(2), first);
}
