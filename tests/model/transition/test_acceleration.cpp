// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/geometry/procrustes.h"
#include "model/transition/acceleration.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitioncomparison.h"
#include "swayingtube.h"
#include "transitiontables.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double fps = 25;

CharacterFrames twoTubes()
{
    const auto topology = tubeTopology(9, 31);
    const std::vector<MeshSequence> sequences{swayingTube(topology, 9, 35, 0.05),
                                              swayingTube(topology, 9, 28, 0.08)};
    return CharacterFrames(sequences);
}

/// In double precision, from the frames themselves.
double plainDifference(const CharacterFrames& character, NodeIndex i, NodeIndex j)
{
    const auto accelerationOf = [&](NodeIndex node) {
        const int sequence = character.layout().sequenceOf(node);
        NodeIndex middle = node;
        if (node == character.layout().firstOf(sequence))
            ++middle;
        if (node == character.layout().lastOf(sequence))
            --middle;
        std::vector<Vec3d> result;
        for (std::uint32_t v = 0; v < character.vertexCount(); ++v) {
            const auto at = [&](NodeIndex n) {
                return Vec3d(character.frame(n).positions()[v].cast<double>());
            };
            result.emplace_back((at(middle - 1) - 2 * at(middle) + at(middle + 1)) * fps * fps);
        }
        return result;
    };
    const Eigen::Quaterniond turn =
        rigidProcrustes(character.frame(j).positions(), character.frame(i).positions()).rotation;
    const std::vector<Vec3d> a = accelerationOf(i);
    const std::vector<Vec3d> b = accelerationOf(j);
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        sum += (a[v] - turn * b[v]).norm();
    return sum / static_cast<double>(a.size());
}

} // namespace

TEST(Acceleration, OfAFallIsThatOfGravity)
{
    const auto topology = tubeTopology(3, 2);
    std::vector<Vec3f> positions;
    for (int f = 0; f < 6; ++f) {
        const double t = f / fps;
        for (int v = 0; v < 6; ++v)
            positions.emplace_back(static_cast<float>(v), static_cast<float>(2 * t - 9.81 / 2 * t * t), 0.0F);
    }
    const MeshSequence fall =
        makeSequence("fall", topology, std::make_shared<MemoryFrames>(std::move(positions), 6), fps);
    const CharacterFrames character(std::span(&fall, 1));
    for (NodeIndex node = 0; node < 6; ++node) {
        for (const Vec3f& a : vertexAccelerations(character, node, fps)) {
            // Positions are floats of 2⁻²⁴ m, multiplied by 625/s².
            EXPECT_NEAR(a.x(), 0, 1e-4);
            EXPECT_NEAR(a.y(), -9.81, 1e-3);
        }
    }
    const MeshSequence two = fall.cutTo({FrameIndex(0), FrameIndex(1)});
    for (const Vec3f& a : vertexAccelerations(CharacterFrames(std::span(&two, 1)), 1, fps))
        EXPECT_EQ(a, Vec3f::Zero());
}

TEST(Acceleration, DifferencesAgreeWithThePlainReference)
{
    const CharacterFrames character = twoTubes();
    const Table<float> differences = accelerationDifferences(character, fps);
    ASSERT_EQ(differences.rows(), 63);
    EXPECT_TRUE((differences == differences.transpose()).all());
    EXPECT_TRUE((differences.matrix().diagonal().array() == 0).all());
    const double largest = static_cast<double>(differences.maxCoeff());
    for (NodeIndex i = 0; i < 63; i += 2) {
        for (NodeIndex j = 1; j < 63; j += 5) {
            if (i == j)
                continue;
            // Second differences of float positions near 5 m lose 5e-7 m · 625/s².
            EXPECT_NEAR(differences(i, j), plainDifference(character, i, j), 1e-3 + 1e-5 * largest);
        }
    }
}

TEST(Acceleration, StopsWhenCancelledAndRefusesBadRates)
{
    const CharacterFrames character = twoTubes();
    CancelToken token;
    token.cancel();
    EXPECT_THROW(accelerationDifferences(character, fps, Progress(token)), Error);
    EXPECT_THROW(accelerationDifferences(character, 0), Error);
}

TEST(TransitionComparison, HasTheRowsOfTheFigure)
{
    const CharacterFrames character = twoTubes();
    const PoseDistances poses = poseDistances(character);
    const Table<float> accelerations = accelerationDifferences(character, fps);
    const TransitionSettings settings = windows(8, 16);
    const TransitionComparison comparison =
        compareTransitions(poses.distances, poses.layout, settings, accelerations);
    ASSERT_EQ(comparison.variants.size(), 9U);
    const TransitionVariant& linear = comparison.variants[0];
    EXPECT_EQ(linear.kind, TransitionKind::Linear);
    EXPECT_DOUBLE_EQ(linear.length.mean, 8);
    EXPECT_NEAR(linear.length.deviation, 0, 1e-9);

    // Row 7 by hand: varying lengths, slope 4.
    const TransitionVariant& varying = comparison.variants[7];
    EXPECT_EQ(varying.kind, TransitionKind::VaryingLengths);
    EXPECT_EQ(varying.slope, 4);
    const TransitionSettings slopeFour = windows(8, 16, 4);
    const TransitionTable table = transitionTable(poses.distances, poses.layout, slopeFour);
    const TransitionTable straight = linearTransitionTable(poses.distances, poses.layout, slopeFour);
    const WarpPaths paths(poses.distances, poses.layout, slopeFour);
    double surface = 0;
    double acceleration = 0;
    double largest = 0;
    double largestAcceleration = 0;
    std::int64_t pairs = 0;
    for (NodeIndex i = 0; i < 63; ++i) {
        for (NodeIndex j = 0; j < 63; ++j) {
            const std::optional<Transition> found = paths.find({.source = i, .destination = j});
            if (!found)
                continue;
            ++pairs;
            surface += static_cast<double>(table.cost(i, j));
            acceleration += accelerationCost(accelerations, *found);
            largest = std::max(largest, static_cast<double>(straight.cost(i, j)));
            largestAcceleration =
                std::max(largestAcceleration,
                         accelerationCost(accelerations, *paths.linear({.source = i, .destination = j})));
        }
    }
    EXPECT_EQ(comparison.pairs, pairs);
    EXPECT_DOUBLE_EQ(comparison.largestLinearCost, largest);
    EXPECT_DOUBLE_EQ(comparison.largestLinearAcceleration, largestAcceleration);
    EXPECT_NEAR(varying.surface.mean, surface / static_cast<double>(pairs) / largest, 1e-9);
    EXPECT_NEAR(varying.acceleration.mean, acceleration / static_cast<double>(pairs) / largestAcceleration,
                1e-9);

    // More freedom, lower sums.
    for (std::size_t v = 1; v < 9; ++v)
        EXPECT_LE(comparison.variants[v].surface.mean, linear.surface.mean);
    for (std::size_t v = 2; v < 5; ++v) {
        EXPECT_LE(comparison.variants[v].surface.mean, comparison.variants[v - 1].surface.mean);
        EXPECT_LE(comparison.variants[v + 4].surface.mean, comparison.variants[v].surface.mean);
    }
    const TransitionComparison without = compareTransitions(poses.distances, poses.layout, settings, {});
    EXPECT_DOUBLE_EQ(without.variants[7].surface.mean, varying.surface.mean);
    EXPECT_EQ(without.variants[7].acceleration.mean, 0);
}
