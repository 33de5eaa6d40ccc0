// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/random.h"
#include "model/transition/posedistance.h"
#include "model/variation/posereach.h"
#include "model/variation/rootpath.h"
#include "model/variation/samemovement.h"
#include "tests/model/variation/swayingtakes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::strideAt;
using test::swayingTake;

std::vector<RigidMotion> walked(int frames)
{
    std::vector<RigidMotion> placements;
    for (int f = 0; f < frames; ++f)
        placements.push_back(strideAt(f));
    return placements;
}

double headingApart(const RigidMotion& a, const RigidMotion& b)
{
    const Eigen::Quaterniond turn = a.rotation * b.rotation.conjugate();
    return std::abs(2 * std::atan2(turn.y(), turn.w()));
}

double sharpest(const std::vector<RigidMotion>& path)
{
    double most = 0;
    for (std::size_t f = 1; f + 1 < path.size(); ++f)
        most = std::max(most,
                        (path[f + 1].translation - 2 * path[f].translation + path[f - 1].translation).norm());
    return most;
}

Movement movementOf(const std::vector<MeshSequence>& sequences)
{
    std::vector<TrainingTake> takes;
    for (const MeshSequence& sequence : sequences)
        takes.push_back({sequence, std::nullopt});
    const MeshSequence& first = sequences.front();
    const BodyParts whole = cutIntoParts(*first.topology, first.frame(FrameIndex(0)).positions(), {}, {});
    return makeMovement(takes, 0, whole, {}, {.alignment = {.up = UpAxis::Y, .cycles = false}});
}

double swaying(int frame)
{
    return 0.2 * frame;
}

} // namespace

TEST(BoundedPath, OfATakesOwnDisplacementsIsItsPath)
{
    const std::vector<RigidMotion> guide = walked(50);
    const auto path = boundedPath(displacementsOf(guide), guide, {}, {.driftHalfLife = 0.25});
    for (std::size_t f = 0; f < path.size(); ++f)
        EXPECT_LT((path[f].translation - guide[f].translation).norm(), 1e-9);
}

TEST(BoundedPath, LeavesItsGuideNoFurtherThanTheRangeAndWithoutWobble)
{
    const std::vector<RigidMotion> guide = walked(60);
    std::vector<Displacement> displacements = displacementsOf(guide);
    Random random(4);
    for (Displacement& d : displacements) {
        d[0] += 0.01 + 0.02 * random.normal();
        d[2] += 0.02 * random.normal();
        d[4] += 0.05 + 0.05 * random.normal(); // 170 degrees over the take
    }
    const WayRange range{.heading = 0.1, .way = 0.2};
    const auto path = boundedPath(displacements, guide, range, {.driftHalfLife = 0.08});
    double heading = 0;
    double way = 0;
    for (std::size_t f = 0; f < path.size(); ++f) {
        heading = std::max(heading, headingApart(path[f], guide[f]));
        way = std::max(way, (path[f].translation - guide[f].translation).norm());
    }
    EXPECT_LE(heading, 0.11);
    EXPECT_GT(heading, 0.05);
    EXPECT_LE(way, 0.2 + 0.11 * 2.4); // what the turn leads aside comes on top
    EXPECT_LT(sharpest(path), 1.3 * sharpest(guide) + 0.002);
}

TEST(TempoPlayback, ChangesLengthsWhereSomethingStandsAlone)
{
    std::vector<double> playback;
    std::vector<bool> stands;
    for (int f = 0; f < 60; ++f) {
        playback.push_back(f);
        stands.push_back(f < 20 || f >= 40);
    }
    const TempoPlayback slow = inTempo(playback, stands, 0.09);
    const TempoPlayback quick = inTempo(playback, stands, -0.09);
    // The whole is a tenth longer or shorter, though a third of it is not.
    EXPECT_NEAR(static_cast<double>(slow.positions.size()), 1 + 59 * std::exp(0.09), 0.6);
    EXPECT_NEAR(static_cast<double>(quick.positions.size()), 1 + 59 * std::exp(-0.09), 0.6);
    // What stands changes by no more than a seventh.
    EXPECT_NEAR(static_cast<double>(inTempo(playback, stands, 0.5).positions.size()), 60 + 39 * 0.162, 1);
    for (const TempoPlayback* each : {&slow, &quick}) {
        EXPECT_EQ(each->positions.front(), 0);
        EXPECT_NEAR(each->positions.back(), 59, 1e-9);
        EXPECT_TRUE(std::ranges::is_sorted(each->positions));
        EXPECT_EQ(each->nearest.size(), each->positions.size());
        EXPECT_EQ(each->nearest.back(), 59u);
    }
    // In the middle of the flight it runs as before, but for what makes the frames whole ones.
    const auto middle = std::ranges::lower_bound(slow.positions, 30) - slow.positions.begin();
    EXPECT_NEAR(slow.positions[static_cast<std::size_t>(middle)] -
                    slow.positions[static_cast<std::size_t>(middle) - 1],
                1, 0.03);
    EXPECT_EQ(inTempo(playback, stands, 0).positions, playback);
}

TEST(SameMovement, IsToldByLabelsAndByHowFarTakesAreApart)
{
    const auto still = [](int) { return RigidMotion(); };
    std::vector<MeshSequence> takes{swayingTake("calm", 32, swaying, still, 1),
                                    swayingTake("alike", 32, swaying, still, 1.1),
                                    swayingTake("wild", 32, swaying, still, 3)};
    EXPECT_EQ(sameMovement(movementOf(takes), 0), (std::vector<std::size_t>{0, 1}));
    for (std::size_t t = 0; t < takes.size(); ++t)
        takes[t].labels = {{t == 1 ? "jog" : "walk", FrameRange::all(32)}};
    EXPECT_EQ(sameMovement(movementOf(takes), 0), (std::vector<std::size_t>{0, 2}));
}

TEST(PoseReaches, AreHowFarTakesOfAMovementAreFromEachOther)
{
    const auto still = [](int) { return RigidMotion(); };
    const std::vector<double> sizes{1, 1.1, 2, 2.4, 7};
    std::vector<MeshSequence> takes;
    for (const double size : sizes)
        takes.push_back(swayingTake("take", 32, swaying, still, size));
    for (std::size_t t = 0; t < takes.size(); ++t)
        takes[t].labels = {{t < 2 ? "calm" : t < 4 ? "lively" : "wild", FrameRange::all(32)}};
    const Movement movement = movementOf(takes);
    const std::vector<double> reaches = poseReaches(movement);
    ASSERT_EQ(reaches.size(), 5U);
    // Of each pair the farthest frame of the one from the nearest of the other, in the mean.
    const auto farthest = [&](std::size_t a, std::size_t b) {
        double most = 0;
        for (std::size_t f = 0; f < 32; ++f) {
            double least = 1e9;
            for (std::size_t g = 0; g < 32; ++g)
                least =
                    std::min(least, euclideanDistance(movement.take(a).pose(f), movement.take(b).pose(g)));
            most = std::max(most, least);
        }
        return most;
    };
    EXPECT_NEAR(reaches[0], (farthest(0, 1) + farthest(1, 0)) / 2, 1e-6);
    EXPECT_EQ(reaches[0], reaches[1]);
    EXPECT_NEAR(reaches[2], (farthest(2, 3) + farthest(3, 2)) / 2, 1e-6);
    EXPECT_GT(reaches[2], 1.5 * reaches[0]);
    // Alone it is guessed by how far it moves.
    EXPECT_NEAR(reaches[4], 0.45 * rangeOfMotion(movement.take(4)), 1e-9);
}

TEST(WayRange, IsThatOfTakesOfTheSameMovementOrAGuess)
{
    const auto ahead = [](double speed) {
        return [speed](int f) { return RigidMotion{Eigen::Quaterniond::Identity(), Vec3d(0, 0, speed * f)}; };
    };
    const std::vector<MeshSequence> takes{swayingTake("slow", 32, swaying, ahead(0.03)),
                                          swayingTake("quick", 32, swaying, ahead(0.04))};
    const WayRange range = wayRange(movementOf(takes), {.take = 0, .to = {}, .across = {}}, UpAxis::Y);
    EXPECT_NEAR(range.way, 0.31 / std::sqrt(2), 0.02);
    EXPECT_NEAR(range.heading, 0, 1e-3);
    EXPECT_NEAR(range.tempo, 0, 1e-9);
    const WayRange guess =
        wayRange(movementOf({takes.front()}), {.take = 0, .to = {}, .across = {}}, UpAxis::Y);
    // Its body sways beside the way.
    EXPECT_GT(guess.way, 0.05 * 0.93 * 0.99);
    EXPECT_LT(guess.way, 0.05 * 0.93 * 2);
    EXPECT_GT(guess.heading, 0.05);
    EXPECT_GT(guess.tempo, 0);
}

} // namespace quadrille
