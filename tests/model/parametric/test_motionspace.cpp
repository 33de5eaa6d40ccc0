// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/parametric/hybridblend.h"
#include "model/parametric/references.h"
#include "tests/model/variation/swayingtakes.h"

#include <gtest/gtest.h>
#include <numbers>

namespace quadrille {
namespace {

using test::swayingTake;

/// Walks along an arc, with a lean of its own that goes with the phase.
RigidMotion onArc(double way, double turn, double phase)
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3d::UnitY()) *
                               Eigen::AngleAxisd(0.05 * std::sin(phase), Vec3d::UnitX())),
            {way * std::sin(turn / 2), 0.02 * std::sin(phase), way * std::cos(turn / 2)}};
}

/// A tube that sways with a period of so many frames, and goes on by so many metres a frame.
SpaceTakeSource cycling(const std::string& name, int frames, int period, double step, double size = 1,
                        double turn = 0)
{
    const auto phase = [=](int f) { return 2 * std::numbers::pi * f / period; };
    const auto place = [=](int f) { return onArc(step * f, turn * f, phase(f)); };
    return {
        .take = {.sequence = swayingTake(name, frames, phase, place, size), .range = {}, .coefficients = {}},
        .speed = 1,
        .place = {}};
}

MotionSpaceSettings settingsOf(double tolerance)
{
    MotionSpaceSettings settings;
    settings.tolerance = tolerance;
    return settings;
}

const SpaceParameter speedParameter{"speed", SpaceMeasure::Speed, {}};

MotionSpace twoSpeeds(double tolerance)
{
    const std::vector<SpaceTakeSource> takes{cycling("slow", 45, 20, 0.02),
                                             cycling("fast", 45, 16, 0.05, 1.6)};
    return makeMotionSpace("walk", takes, 0, {speedParameter}, {}, settingsOf(tolerance));
}

std::vector<Vec3f> captured(const SpaceTakeSource& take, std::int64_t frame)
{
    const Frame pose = take.take.sequence.frame(FrameIndex(frame));
    return {pose.positions().begin(), pose.positions().end()};
}

} // namespace

TEST(MotionSpace, PlaysATakeAsItWasCaptured)
{
    const SpaceTakeSource take = cycling("walk", 24, 100, 0.03, 1, 0.01);
    const MotionSpace space = makeMotionSpace("one", std::vector{take}, 0, {}, {}, {});
    EXPECT_FALSE(space.isCyclic);
    ASSERT_EQ(space.frameCount(), 24U);
    const Ground ground(space.up);
    const NodeWeights weights = space.weights.at({});
    std::vector<Vec3f> pose(space.vertexCount());
    // From where it was captured first, steps lead through all of it.
    GroundMotion place;
    for (std::size_t f = 0; f < 24; ++f) {
        blendedPose(space, static_cast<double>(f), weights, pose);
        const std::vector<Vec3f> truth = captured(take, static_cast<std::int64_t>(f));
        if (f == 0) {
            const Vec3d edge = (truth.back() - truth.front()).cast<double>();
            const Vec3d own = (pose.back() - pose.front()).cast<double>();
            const Vec2d from = ground.of(own);
            const Vec2d to = ground.of(edge);
            place.turn = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
            place.shift = ground.of(truth.front().cast<double>()) -
                          Eigen::Rotation2Dd(place.turn) * ground.of(pose.front().cast<double>());
        }
        for (std::size_t v = 0; v < pose.size(); ++v)
            EXPECT_LT((place(pose[v].cast<double>(), ground) - truth[v].cast<double>()).norm(), 2e-4) << f;
        place = place * blendedStep(space, f, weights);
        EXPECT_NEAR(blendedSeconds(space, f, weights), 0.04, 1e-9);
    }
}

TEST(MotionSpace, GoesThroughTheSeamOfACycleWithoutAJump)
{
    const MotionSpace space = twoSpeeds(0.005);
    ASSERT_TRUE(space.isCyclic);
    const auto frames = static_cast<double>(space.frameCount());
    std::vector<Vec3f> before(space.vertexCount());
    std::vector<Vec3f> after(space.vertexCount());
    for (const double value : {0.6, 0.9, 1.1}) {
        const NodeWeights weights = space.weights.at({value, 0, 0});
        blendedPose(space, frames - 1e-4, weights, before);
        blendedPose(space, 0, weights, after);
        for (std::size_t v = 0; v < before.size(); ++v)
            EXPECT_LT((before[v] - after[v]).norm(), 1e-4);
    }
}

/// As of a foot that lands a frame later than a cycle before.
TEST(MotionSpace, CarriesNothingAwayWhereSpeedsDifferForAFrameAtTheSeam)
{
    const SpaceTakeSource take = cycling("walk", 45, 20, 0.02);
    const MotionSpace steady = makeMotionSpace("steady", std::vector{take}, 0, {}, {}, {});
    ASSERT_TRUE(steady.isCyclic);
    const FrameRange cycle = steady.takes[0].warp.frames;
    const auto count = static_cast<std::int64_t>(steady.frameCount());
    ASSERT_LT(cycle.last.value + 2, 45);
    const std::size_t foot = 3;
    const float late = 0.04F;
    std::vector<Vec3f> positions;
    for (std::int64_t f = 0; f < 45; ++f) {
        const std::vector<Vec3f> pose = captured(take, f);
        positions.insert(positions.end(), pose.begin(), pose.end());
        if (f == cycle.last.value + 2)
            positions[positions.size() - pose.size() + foot].x() += late;
    }
    SpaceTakeSource other = take;
    other.take.sequence.source = std::make_shared<MemoryFrames>(
        std::move(positions), static_cast<std::uint32_t>(steady.vertexCount()));
    other.take.range = cycle;
    const MotionSpace space = makeMotionSpace("other", std::vector{other}, 0, {}, {}, {});
    ASSERT_EQ(space.takes[0].warp.frames, cycle);
    for (std::int64_t f = 0; f < count; ++f) {
        const auto frame = static_cast<std::size_t>(f);
        const float away = (space.takes[0].pose(frame)[foot] - steady.takes[0].pose(frame)[foot]).norm();
        // An eighth of the cycle on either side, two frames and a half; the cubic is at most 4/27 as high.
        EXPECT_LT(away,
                  f < count / 8 + 1 || f >= count - count / 8 ? late / 2 * 2.5F * 4 / 27 + 1e-4F : 1e-4F)
            << f;
    }
}

TEST(MotionSpace, PlacesTakesByTheirSpeedsAndMeetsThoseBetween)
{
    const MotionSpace space = twoSpeeds(0.005);
    const double slow = space.weights.nodes()[0].place[0];
    const double fast = space.weights.nodes()[1].place[0];
    EXPECT_NEAR(slow, 0.02 * 25, 0.02);
    EXPECT_NEAR(fast, 0.05 * 25, 0.05);
    for (double share = 0; share <= 1; share += 0.125) {
        const double wanted = slow + share * (fast - slow);
        const NodeWeights weights = space.weights.at(space.map.placeOf({wanted, 0, 0}));
        const BlendedMovement movement = blendedMovement(space, weights);
        EXPECT_NEAR(measured(speedParameter, movement.performed(space)), wanted,
                    space.map.worstResidual[0] + 0.02 * (fast - slow));
    }
}

TEST(MotionSpace, KeepsTheToleranceBetweenItsReferences)
{
    constexpr double tolerance = 0.004;
    const MotionSpace space = twoSpeeds(tolerance);
    const MotionSpace linear = twoSpeeds(1);
    EXPECT_TRUE(linear.references.empty());
    ASSERT_FALSE(space.references.empty());
    const NonLinearBlend nonLinear(space);
    double worstLinear = 0;
    for (double share = 0; share <= 1; share += 1.0 / 32) {
        const double slow = space.weights.nodes()[0].place[0];
        const SpacePoint place{slow + share * (space.weights.nodes()[1].place[0] - slow), 0, 0};
        EXPECT_LE(hybridError(space, space.weights.at(place), nonLinear).greatest, tolerance) << share;
        worstLinear =
            std::max(worstLinear, hybridError(linear, linear.weights.at(place), nonLinear).greatest);
    }
    EXPECT_GT(worstLinear, 2 * tolerance) << "nothing was to be corrected";
    for (std::size_t n = 0; n < space.references.size(); ++n) {
        const auto node = static_cast<int>(space.takes.size() + n);
        const NodeWeights there{.nodes = {node}, .weights = {1}, .count = 1};
        EXPECT_LE(hybridError(space, there, nonLinear).greatest, 0.21 * tolerance);
    }
}

TEST(MotionSpace, ComesOutTheSameAgain)
{
    const MotionSpace first = twoSpeeds(0.005);
    const MotionSpace second = twoSpeeds(0.005);
    ASSERT_EQ(first.references.size(), second.references.size());
    EXPECT_EQ(first.takes[1].poses, second.takes[1].poses);
    for (std::size_t r = 0; r < first.references.size(); ++r) {
        EXPECT_EQ(first.references[r].vertices, second.references[r].vertices);
        EXPECT_EQ(first.references[r].displacements, second.references[r].displacements);
    }
    EXPECT_EQ(first.map.coefficients, second.map.coefficients);
}

TEST(MotionSpace, PlaysTakesFasterThanTheyWereCaptured)
{
    SpaceTakeSource take = cycling("walk", 24, 100, 0.03);
    take.speed = 2;
    const MotionSpace space = makeMotionSpace("one", std::vector{take}, 0, {}, {}, {});
    EXPECT_NEAR(blendedSeconds(space, 3, space.weights.at({})), 0.02, 1e-9);
}

TEST(MotionSpace, SaysWhichTakeHasNoCycle)
{
    const auto place = [](int f) { return onArc(0.02 * f, 0, 0); };
    const SpaceTakeSource standing{.take = {.sequence = swayingTake(
                                                "bow", 45, [](int f) { return 0.03 * f; }, place),
                                            .range = {},
                                            .coefficients = {}},
                                   .speed = 1,
                                   .place = {}};
    const std::vector<SpaceTakeSource> takes{cycling("walk", 45, 20, 0.02), standing};
    try {
        makeMotionSpace("walk", takes, 0, {speedParameter}, {}, {});
        ADD_FAILURE() << "it was taken";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("bow"), std::string::npos) << error.what();
    }
}

TEST(MotionSpace, SaysWhatItsSettingsLack)
{
    const std::vector<SpaceTakeSource> takes{cycling("slow", 45, 20, 0.02), cycling("fast", 45, 16, 0.05)};
    EXPECT_THROW(makeMotionSpace("s", takes, 0, {}, {}, {}), Error);
    EXPECT_THROW(makeMotionSpace("s", std::span(takes).first(1), 0, {speedParameter}, {}, {}), Error);
    EXPECT_THROW(makeMotionSpace("s", takes, 0, {speedParameter}, {}, settingsOf(0)), Error);
    EXPECT_THROW(makeMotionSpace("s", takes, 0, {{"mood", SpaceMeasure::ByHand, {}}}, {}, {}), Error);
    std::vector<SpaceTakeSource> stopped = takes;
    stopped[1].speed = 0;
    EXPECT_THROW(makeMotionSpace("s", stopped, 0, {speedParameter}, {}, {}), Error);
}

TEST(MotionSpace, CanBeCancelled)
{
    CancelToken token;
    token.cancel();
    const std::vector<SpaceTakeSource> takes{cycling("slow", 45, 20, 0.02), cycling("fast", 45, 16, 0.05)};
    EXPECT_THROW(makeMotionSpace("s", takes, 0, {speedParameter}, {}, {}, Progress(token)), Error);
}

} // namespace quadrille
