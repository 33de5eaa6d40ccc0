// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "livefixture.h"
#include "model/core/error.h"
#include "model/parametric/hybridblend.h"
#include "tests/model/parametric/countallocations.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::jumping;
using test::swingingFps;
using test::swingingGraph;
using test::turning;
using test::walking;

std::vector<Vec3f> poseOf(LivePlayer& player)
{
    std::vector<Vec3f> pose(player.graph().vertexCount());
    player.pose(pose);
    return pose;
}

double greatestStep(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b)
{
    float greatest = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        greatest = std::max(greatest, (a[v] - b[v]).norm());
    return static_cast<double>(greatest);
}

/// Ten minutes of whims: a space, its parameters and how much of a hurry, for a while each.
std::vector<LiveInput> whims(std::size_t ticks, std::uint64_t seed)
{
    Random random(seed);
    std::vector<LiveInput> inputs;
    while (inputs.size() < ticks) {
        const auto space = static_cast<std::size_t>(random.between(0, 3));
        const double value = space == turning ? random.between(-70, 70) : random.between(0.3, 2.2);
        const LiveInput input{.space = space, .parameters = {value}, .isResponsive = random.unit() < 0.5};
        const auto length = static_cast<std::size_t>(random.between(1, 150));
        inputs.insert(inputs.end(), length, input);
    }
    inputs.resize(ticks);
    return inputs;
}

} // namespace

TEST(LivePlayer, PlaysATakeAlongAsItWasCaptured)
{
    const auto graph = swingingGraph();
    LivePlayer player(graph, {.ticksPerFrame = 1}, {.space = walking, .parameters = {2}});
    const MotionSpace& space = *graph->spaces[walking];
    for (std::size_t f = 0; f < 50; ++f) {
        const std::vector<Vec3f> pose = poseOf(player);
        std::vector<Vec3f> expected(space.vertexCount());
        blendedPose(space, static_cast<double>(f % space.frameCount()),
                    {.nodes = {1}, .weights = {1}, .count = 1}, expected);
        const Vec3f way(0, 0, static_cast<float>(2 / swingingFps * static_cast<double>(f)));
        for (std::size_t v = 0; v < pose.size(); ++v)
            ASSERT_LT((pose[v] - expected[v] - way).norm(), 1e-5F) << f;
        player.tick({.space = walking, .parameters = {2}});
    }
    EXPECT_EQ(player.state().decisions, 0);
    EXPECT_EQ(player.provenance().take, 1U);
}

TEST(LivePlayer, LeavesASpaceThatEndsWhereItBeganThere)
{
    LivePlayer player(swingingGraph(), {}, {.space = jumping, .parameters = {1}});
    bool hasLeft = false;
    for (int t = 0; t < 120; ++t) {
        player.tick({.space = jumping, .parameters = {1}});
        hasLeft = hasLeft || player.state().track.space == walking;
    }
    EXPECT_TRUE(hasLeft);
}

TEST(LivePlayer, GoesAsFarInATickWhateverTheirRate)
{
    const auto graph = swingingGraph();
    std::vector<Vec2d> ends;
    for (const int perFrame : {1, 2, 3, 5}) {
        LivePlayer player(graph, {.ticksPerFrame = perFrame}, {.space = turning, .parameters = {40}});
        for (int t = 0; t < 60 * perFrame; ++t)
            player.tick({.space = turning, .parameters = {40}});
        ends.push_back(player.root().shift);
        EXPECT_NEAR(player.root().turn, 80 * std::numbers::pi / 180, 1e-9);
    }
    for (const Vec2d& end : ends)
        EXPECT_LT((end - ends.front()).norm(), 1e-9);
}

TEST(LivePlayer, GoesToWantedParametersNoFasterThanItMay)
{
    const auto graph = swingingGraph();
    constexpr double range = 1.5;
    constexpr double across = 0.5;
    LivePlayer player(graph, {.ticksPerFrame = 2, .secondsAcross = across},
                      {.space = walking, .parameters = {0.5}});
    const double dt = player.tickSeconds();
    double place = player.state().track.place[0];
    double pace = 0;
    // There, half of the way back, and there again: never faster, never changing pace at once, never beyond.
    int arrived = 0;
    for (int t = 1; t <= 120; ++t) {
        const double wanted = t <= 60 || t > 70 ? 2 : 0.5;
        player.tick({.space = walking, .parameters = {wanted}});
        const double next = player.state().track.place[0];
        EXPECT_LE(std::abs(next - place) / dt, range / across * (1 + 1e-9)) << t;
        EXPECT_LE(std::abs((next - place) / dt - pace), range / across / (across / 4) * dt * (1 + 1e-6)) << t;
        EXPECT_GE(next, 0.5);
        EXPECT_LE(next, 2);
        pace = (next - place) / dt;
        place = next;
        if (arrived == 0 && next == 2)
            arrived = t;
    }
    EXPECT_GT(arrived * dt, across);
    EXPECT_LT(arrived * dt, 1.5 * across);
    EXPECT_EQ(place, 2);
    EXPECT_EQ(player.state().pace[0], 0);
    // Beyond its limits it goes nowhere.
    player.tick({.space = walking, .parameters = {9}});
    EXPECT_EQ(player.state().track.place[0], 2);
}

TEST(LivePlayer, MovesPlacesNoFasterInTransitionsThanWhenTheyAreSteered)
{
    const auto graph = swingingGraph();
    const LiveSettings settings{.secondsAcross = 0.8};
    LivePlayer player(graph, settings, {.space = walking, .parameters = {1}});
    Random random(3);
    LiveInput input{.space = walking, .parameters = {1}};
    const double tick = 1 / (graph->fps * settings.ticksPerFrame);
    std::int64_t ticksOnWays = 0;
    for (int t = 0; t < 3000; ++t) {
        if (t % 60 == 0) {
            input.space = input.space == walking ? turning : walking;
            input.parameters = {input.space == walking ? random.between(0.5, 2) : random.between(-60, 60)};
        }
        const LiveTrack before = player.state().track;
        player.tick(input);
        const LiveTrack& after = player.state().track;
        if (after.space != before.space)
            continue;
        ticksOnWays += player.state().way != LiveState::Way::Free ? 1 : 0;
        const auto [least, greatest] = graph->spaces[after.space]->weights.range();
        EXPECT_LE(std::abs(after.place[0] - before.place[0]),
                  1.01 * (greatest[0] - least[0]) / settings.secondsAcross * tick)
            << t;
    }
    EXPECT_GT(ticksOnWays, 100);
}

TEST(LivePlayer, MakesTheTransitionThatTheSearchFinds)
{
    const auto graph = swingingGraph();
    LivePlayer player(graph, {.ticksPerFrame = 2}, {.space = walking, .parameters = {1}});
    for (int t = 0; t < 7; ++t)
        player.tick({.space = walking, .parameters = {1}});
    const LiveState before = player.state();
    player.tick({.space = turning, .parameters = {30}});
    ASSERT_EQ(player.state().decisions, 1);
    const LiveDecision decision = player.decision();
    EXPECT_EQ(decision.tick, 8);
    EXPECT_EQ(decision.source, walking);
    EXPECT_EQ(decision.target, turning);
    TransitionSearch search(graph->tables[walking][turning], *graph->spaces[walking], *graph->spaces[turning],
                            {.stepsAFrame = 10 / (test::swingingFps * 1.5)});
    const auto found = search.search({before.track.phase, before.track.place}, decision.goal);
    ASSERT_EQ(decision.count, found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(decision.choices[i], found[i]);
    // It leaves at the frame that was chosen, and arrives at the one that was.
    const TransitionChoice& choice = decision.choices[0];
    LiveTrack last = player.state().track;
    int ticks = 0;
    while (player.state().track.space == walking) {
        last = player.state().track;
        player.tick({.space = turning, .parameters = {30}});
        ASSERT_LT(++ticks, 60);
    }
    EXPECT_LE(std::abs(last.phase - static_cast<double>(choice.leavingFrame)), 0.51);
    EXPECT_NEAR(player.state().track.phase, static_cast<double>(choice.arrivalFrame), 0.51);
    for (int t = 0; t < 60; ++t)
        player.tick({.space = turning, .parameters = {30}});
    EXPECT_NEAR(player.state().track.place[0], 30, 1e-9);
    EXPECT_EQ(player.state().decisions, 1);
}

TEST(LivePlayer, ForgetsATransitionThatIsNotWantedAnyMore)
{
    const auto graph = swingingGraph();
    LivePlayer player(graph, {.search = {.latencyWeight = 1e-3}}, {.space = walking, .parameters = {1}});
    player.tick({.space = turning, .parameters = {30}});
    ASSERT_EQ(player.state().way, LiveState::Way::Leaving);
    player.tick({.space = walking, .parameters = {1}});
    EXPECT_EQ(player.state().way, LiveState::Way::Free);
    for (int t = 0; t < 200; ++t)
        player.tick({.space = walking, .parameters = {1}});
    EXPECT_EQ(player.state().track.space, walking);
}

TEST(LivePlayer, JumpsOnceAndGoesBack)
{
    const auto graph = swingingGraph();
    LivePlayer player(graph, {}, {.space = walking, .parameters = {1.7}});
    std::vector<std::size_t> spaces{walking};
    double highest = 0;
    player.tick({.space = walking, .parameters = {1.7}});
    for (int t = 0; t < 90; ++t) {
        player.tick({.space = t < 50 ? jumping : walking, .parameters = {1.7}});
        highest = std::max(highest, static_cast<double>(poseOf(player)[0].y()));
        if (spaces.back() != player.state().track.space)
            spaces.push_back(player.state().track.space);
    }
    for (int t = 0; t < 120; ++t) {
        player.tick({.space = walking, .parameters = {1.7}});
        if (spaces.back() != player.state().track.space)
            spaces.push_back(player.state().track.space);
    }
    EXPECT_EQ(spaces, (std::vector<std::size_t>{walking, jumping, walking}));
    EXPECT_GT(highest, static_cast<double>(poseOf(player)[0].y()) + 0.25);
    EXPECT_NEAR(player.state().track.place[0], 1.7, 1e-9);
}

TEST(LivePlayer, AllocatesNothing)
{
    const auto graph = swingingGraph();
    LivePlayer player(graph, {}, {.space = walking, .parameters = {1}});
    std::vector<Vec3f> pose(graph->vertexCount());
    const std::vector<LiveInput> inputs = whims(3000, 1);
    const std::size_t before = test::allocationCount();
    for (const LiveInput& input : inputs) {
        player.tick(input);
        player.pose(pose);
        player.provenance();
        player.look();
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_GT(player.state().decisions, 20);
}

TEST(LivePlayer, StaysWithoutAJumpThroughTenMinutesOfWhims)
{
    const auto graph = swingingGraph();
    // By so much a vertex moves in a frame of the captures, over the ground.
    double captured = 0;
    for (const auto& space : graph->spaces) {
        for (std::size_t node = 0; node < 2; ++node) {
            const BlendedMovement movement =
                blendedMovement(*space, {.nodes = {static_cast<int>(node)}, .weights = {1}, .count = 1});
            const std::size_t vertices = space->vertexCount();
            for (std::size_t f = 0; f + 1 < space->frameCount(); ++f) {
                for (std::size_t v = 0; v < vertices; ++v) {
                    const Vec3d next = movement.steps[f](
                        movement.poses[(f + 1) * vertices + v].cast<double>(), Ground(space->up));
                    captured =
                        std::max(captured, (next - movement.poses[f * vertices + v].cast<double>()).norm());
                }
            }
        }
    }
    LivePlayer player(graph, {}, {.space = walking, .parameters = {1}});
    std::vector<Vec3f> before = poseOf(player);
    std::vector<Vec3f> earlier = before;
    GroundMotion root = player.root();
    double greatest = 0;
    double kink = 0; // change of velocity, a tick
    for (const LiveInput& input : whims(36'000, 7)) {
        player.tick(input);
        const std::vector<Vec3f> pose = poseOf(player);
        for (std::size_t v = 0; v < pose.size(); ++v) {
            ASSERT_TRUE(pose[v].allFinite());
            if (player.state().tick > 1)
                kink = std::max(kink, static_cast<double>((pose[v] - 2 * before[v] + earlier[v]).norm()));
        }
        greatest = std::max(greatest, greatestStep(before, pose));
        ASSERT_LT((player.root().shift - root.shift).norm(), captured) << player.state().tick;
        earlier = before;
        before = pose;
        root = player.root();
    }
    EXPECT_GT(player.state().decisions, 300);
    // A tick is half a frame. Surfaces differ by less than half a metre, and the weight of a fade grows by
    // 0.11 a tick at most. At worst a jump that is left at its end comes to rest at once.
    EXPECT_LT(greatest, captured / 2 + 0.11 * 0.5);
    EXPECT_LT(kink, captured / 2);
}

TEST(LivePlayer, PlaysTheSameAgainAndAnyTickAgain)
{
    const auto graph = swingingGraph();
    const LiveStart start{.space = walking, .parameters = {1}, .frame = 3, .root = {1, Vec2d(2, 3)}};
    const std::vector<LiveInput> inputs = whims(2000, 3);
    LivePlayer first(graph, {}, start);
    std::vector<LiveState> states;
    std::vector<std::vector<Vec3f>> poses;
    for (const LiveInput& input : inputs) {
        first.tick(input);
        states.push_back(first.state());
        poses.push_back(poseOf(first));
    }
    LivePlayer second(graph, {}, start);
    std::size_t tick = 0;
    for (const LiveInput& input : inputs) {
        second.tick(input);
        ASSERT_EQ(second.state(), states[tick]);
        ASSERT_EQ(poseOf(second), poses[tick++]);
    }
    // From the middle of everything, backwards.
    for (std::size_t t = states.size() - 1; t > 0; t = t > 37 ? t - 37 : 0) {
        second.restore(states[t - 1]);
        ASSERT_EQ(poseOf(second), poses[t - 1]);
        second.tick(inputs[t]);
        ASSERT_EQ(second.state(), states[t]);
        ASSERT_EQ(poseOf(second), poses[t]);
    }
}

TEST(LivePlayer, PerformsARecordingTickByTick)
{
    const auto graph = swingingGraph();
    LivePlayer live(graph, {}, {.space = walking, .parameters = {1}});
    const std::vector<LiveInput> inputs = whims(301, 4);
    std::vector<LiveState> states{live.state()};
    for (const LiveInput& input : inputs) {
        live.tick(input);
        states.push_back(live.state());
    }
    LivePlayer player(graph, {}, {.space = walking, .parameters = {1}});
    std::vector<LiveState> performed;
    perform(player, inputs, [&](const LivePlayer& each) { performed.push_back(each.state()); });
    EXPECT_EQ(performed, states);
}

TEST(LivePlayer, CountsLatencyFromTheWish)
{
    const auto graph = swingingGraph();
    LivePlayer player(graph, {}, {.space = walking, .parameters = {1}});
    player.tick({.space = turning});
    while (player.state().track.space != turning)
        player.tick({.space = turning});
    // While the one fades, nothing else is looked for.
    const std::int64_t wish = player.state().tick + 1;
    while (player.state().decisions < 2)
        player.tick({.space = walking, .parameters = {1}});
    const LiveDecision& decision = player.decision();
    EXPECT_EQ(decision.wished, wish);
    EXPECT_GT(decision.tick, wish + 10);
    EXPECT_EQ(decision.latencyFrames(2), static_cast<double>(decision.tick - wish) / 2 +
                                             decision.choices[0].sourceFrames +
                                             decision.choices[0].targetFrames);
}

TEST(LivePlayer, RefusesSettingsThatMakeNoSense)
{
    const auto graph = swingingGraph();
    for (const LiveSettings& settings : {LiveSettings{.ticksPerFrame = 0},
                                         LiveSettings{.responsiveWeight = 0}, LiveSettings{.fadeSeconds = 0},
                                         LiveSettings{.secondsAcross = -1}, LiveSettings{.earliestLeave = 2}})
        EXPECT_THROW(LivePlayer(graph, settings, {}), Error);
    EXPECT_THROW(makeLiveGraph({}, 30), Error);
    EXPECT_THROW(makeLiveGraph(graph->spaces, 0), Error);
}

} // namespace quadrille
