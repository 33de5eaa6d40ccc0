// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/similarity.h"
#include "tests/model/codeof.h"
#include "tests/model/parametric/plainsimilarity.h"
#include "tests/model/parametric/spacefixture.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

void expectAsPlain(const MotionSpace& source, const MotionSpace& target, double velocityWeight)
{
    const SimilarityTable table = similarities(source, target, {.velocityWeight = velocityWeight});
    const std::vector<float> plain = plainSimilarities(source, target, velocityWeight);
    ASSERT_EQ(table.distances.size(), plain.size());
    EXPECT_NEAR(table.greatest, std::ranges::max(plain), 1e-6F * table.greatest);
    const std::size_t block = table.sourceNodes * table.targetNodes;
    for (std::size_t pair = 0; pair < table.leasts.size(); ++pair) {
        const auto from = plain.begin() + static_cast<std::ptrdiff_t>(pair * block);
        EXPECT_NEAR(table.leasts[pair], *std::min_element(from, from + static_cast<std::ptrdiff_t>(block)),
                    1e-6F * table.greatest);
    }
    // As documented.
    for (std::size_t i = 0; i < plain.size(); ++i)
        ASSERT_NEAR(table.distances[i], plain[i], 1e-6F * table.greatest) << i;
}

/// Two vertices that stand 1 above each other, in two frames of a cycle.
MotionSpace standingPair(const Vec2d& shift, double turn, double seconds)
{
    MotionSpace space;
    space.topology = stripOf(3);
    space.isCyclic = true;
    SpaceTake take;
    for (int f = 0; f < 2; ++f) {
        take.poses.insert(take.poses.end(), {Vec3f(0, 0, 1), Vec3f(0, 1, 1), Vec3f(0, 2, 1)});
        take.steps.push_back({turn, shift});
        take.seconds.push_back(seconds);
    }
    space.takes.push_back(take);
    space.weights = WeightSpace(std::vector<SpacePoint>{{}}, 0);
    return space;
}

} // namespace

TEST(Similarities, AreThoseOfPlainLoops)
{
    const MotionSpace source = makeSpace({.seed = 1, .frames = 9, .bisections = 2});
    const MotionSpace target = makeSpace({.seed = 2, .frames = 17, .places = {{1}, {2}, {4}}});
    expectAsPlain(source, target, 1);
    expectAsPlain(source, target, 0.3);
}

TEST(Similarities, AreThoseOfPlainLoopsWithoutACycle)
{
    const MotionSpace source = makeSpace({.seed = 3, .isCyclic = false});
    const MotionSpace target = makeSpace({.seed = 4, .frames = 1, .isCyclic = false});
    expectAsPlain(source, target, 1);
    expectAsPlain(target, source, 1);
}

TEST(Similarities, AreThoseOfPlainLoopsInThePlaneAndInSpace)
{
    const MotionSpace plane =
        makeSpace({.seed = 5, .places = {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, .dimension = 2, .bisections = 2});
    const MotionSpace space = makeSpace({.seed = 6,
                                         .vertices = 100, // more coordinates than the kernel takes at a time
                                         .places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                         .dimension = 3,
                                         .bisections = 1});
    const MotionSpace alone = makeSpace({.seed = 7, .vertices = 100, .places = {{}}, .dimension = 0});
    expectAsPlain(plane, plane, 1);
    expectAsPlain(space, alone, 1);
}

TEST(Similarities, CountTheWayOverTheGroundForAFrameOfTime)
{
    // Ground axes are z and x where y is up: 0.1 along z a step of half a frame is 0.2 a frame, of each
    // vertex; √3 · 0.2 / 3.
    const SimilarityTable table =
        similarities(standingPair({0, 0}, 0, 0.04), standingPair({0.1, 0}, 0, 0.02), {.velocityWeight = 2});
    EXPECT_NEAR(table.distances[0], 2 * std::sqrt(3.0) * 0.2 / 3, 1e-7);
}

TEST(Similarities, SeeHowTheBodyTurns)
{
    // Vertices are 1 from the origin: a turn by φ takes them 2·sin(φ/2) on.
    const SimilarityTable table =
        similarities(standingPair({0, 0}, 0, 0.04), standingPair({0, 0}, 0.2, 0.04));
    EXPECT_NEAR(table.distances[0], std::sqrt(3.0) * 2 * std::sin(0.1) / 3, 1e-7);
}

TEST(Similarities, OfASpaceWithItselfAreNoneOnTheDiagonal)
{
    const MotionSpace space = makeSpace({});
    const SimilarityTable table = similarities(space, space);
    for (std::size_t f = 0; f < table.sourceFrames; ++f) {
        for (std::size_t n = 0; n < table.sourceNodes; ++n)
            EXPECT_LT(table.block(f, f)[n * table.targetNodes + n], 1e-6F * table.greatest);
        for (std::size_t g = 0; g < f; ++g)
            EXPECT_NEAR(table.block(f, g)[1], table.block(g, f)[table.targetNodes], 1e-6F * table.greatest);
    }
}

TEST(Similarities, AreTheSameForAnyNumberOfThreads)
{
    const MotionSpace source = makeSpace({.seed = 1, .frames = 60});
    const MotionSpace target = makeSpace({.seed = 2, .frames = 50});
    SimilarityTable one;
    SimilarityTable several;
    tbb::task_arena(1).execute([&] { one = similarities(source, target); });
    tbb::task_arena(4).execute([&] { several = similarities(source, target); });
    EXPECT_EQ(one, several);
}

TEST(Similarities, OfPosesThatAreAllTheSameAreNone)
{
    const MotionSpace pair = standingPair({0, 0}, 0, 0.04);
    const SimilarityTable table = similarities(pair, pair);
    EXPECT_EQ(table.greatest, 0);
    EXPECT_EQ(dissimilarity(table, 0, pair.weights.at({}), 1, pair.weights.at({})), 0);
}

TEST(Similarities, StopWhenTheyAreCancelled)
{
    const MotionSpace space = makeSpace({});
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { similarities(space, space, {}, Progress(token)); }), ErrorCode::Cancelled);
}

TEST(Similarities, RefuseANegativeWeight)
{
    const MotionSpace space = makeSpace({});
    EXPECT_EQ(codeOf([&] { similarities(space, space, {.velocityWeight = -1}); }), ErrorCode::BadArgument);
}

TEST(Dissimilarity, IsBilinear)
{
    SimilarityTable table{.sourceFrames = 1, .targetFrames = 2, .sourceNodes = 2, .targetNodes = 2};
    table.distances = {9, 9, 9, 9, 1, 2, 4, 10};
    table.leasts = {9, 1};
    table.greatest = 10;
    const NodeWeights source{.nodes = {1, 0}, .weights = {0.25, 0.75}, .count = 2};
    const NodeWeights target{.nodes = {0, 1}, .weights = {0.5, 0.5}, .count = 2};
    // ¾·½·1 + ¾·½·2 + ¼·½·4 + ¼·½·10 = 2.875, of at most 10
    EXPECT_DOUBLE_EQ(dissimilarity(table, 0, source, 1, target), 287.5);
    EXPECT_DOUBLE_EQ(dissimilarity(table, 0, {.nodes = {1}, .weights = {1}, .count = 1}, 1,
                                   {.nodes = {1}, .weights = {1}, .count = 1}),
                     1000);
}
