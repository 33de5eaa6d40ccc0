// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/clipplan.h"
#include "model/synthesis/walks/findwalk.h"
#include "tests/model/synthesis/walkworld.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;
using quadrille::test::WalkWorld;

namespace {

PathConstraint longCurve()
{
    return {.points = sampleCurve({{0, 0, 1}, {1.5, 0.2, 1}, {3, 0, 1}}, 0.02)};
}

/// Of all transitions of a walk, each with six captured frames before and behind where there are any: the sum
/// of the squares of how much the speed over the ground changes within six frames, body heights a second.
double plainUnevenness(const WalkWorld& world, const Walk& walk, double fps)
{
    constexpr NodeIndex ahead = 6;
    const FrameLayout& layout = world.costs.layout();
    double sum = 0;
    for (std::size_t i = 0; i < walk.transitionCount(); ++i) {
        const auto [from, to] = walk.transition(i);
        const Walk around{{{std::max(from - ahead, layout.firstOf(layout.sequenceOf(from))), from},
                           {to, std::min(to + ahead, layout.lastOf(layout.sequenceOf(to)))}}};
        const Transition transition = world.transition({from, to});
        const ClipPlan plan = planClip(world.roots, around, std::span(&transition, 1));
        std::vector<double> speeds;
        for (std::size_t f = 1; f < plan.frames.size(); ++f)
            speeds.push_back((plan.frames[f].centre - plan.frames[f - 1].centre).head<2>().norm() * fps /
                             world.roots.stances.height);
        for (std::size_t f = ahead; f < speeds.size(); ++f)
            sum += std::pow(speeds[f] - speeds[f - ahead], 2);
    }
    return sum;
}

} // namespace

TEST(WalkPace, KeepsItsPaceWhereThatIsAsked)
{
    const WalkWorld world({.seed = 4, .counts = {40, 40, 40}, .missing = 0.3, .shortest = 4});
    WalkMaterial material = world.material();
    material.paces = pacesOf(world.roots, world.costs.layout(), 30);
    const PathConstraint path = longCurve();
    const auto changesOf = [&](double weight) {
        const Walk walk = findWalk(material, {.path = path}, {.budget = 20'000, .paceWeight = weight}).walk;
        double changes = 0;
        for (std::size_t t = 0; t < walk.transitionCount(); ++t) {
            const FramePair pair = walk.transition(t);
            changes += std::abs(material.paces[static_cast<std::size_t>(pair.source)] -
                                material.paces[static_cast<std::size_t>(pair.destination)]);
        }
        return changes;
    };
    EXPECT_LT(changesOf(1000), 0.6 * changesOf(0));
}

TEST(WalkPace, FramesThatAreNoLocomotionWeighAsFarAsTheyShow)
{
    const WalkWorld world({.seed = 4, .counts = {40, 40, 40}, .missing = 0.3, .shortest = 4});
    const FrameLayout& layout = world.costs.layout();
    WalkMaterial material = world.material();
    material.locomotion.assign(static_cast<std::size_t>(layout.frameCount()), true);
    const PathConstraint path = longCurve();
    const auto solve = [&](double weight) {
        return findWalk(material, {.path = path},
                        {.budget = 20'000, .prefersLocomotion = true, .strayWeight = weight});
    };
    const int stray = layout.sequenceOf(solve(0).walk.spans.front().first);
    std::fill_n(material.locomotion.begin() + layout.firstOf(stray), layout.countOf(stray), false);
    const auto strayIn = [&](const Walk& walk) {
        std::vector<Transition> transitions;
        for (std::size_t i = 0; i < walk.transitionCount(); ++i)
            transitions.push_back(world.transition(walk.transition(i)));
        const ClipPlan plan = planClip(world.roots, walk, transitions);
        double sum = 0;
        for (std::size_t f = 0; f + 1 < plan.frames.size(); ++f) {
            const FrameProvenance& origin = plan.frames[f].origin;
            sum += (1 - origin.lambda) * (layout.sequenceOf(origin.source) == stray ? 1 : 0) +
                   origin.lambda * (layout.sequenceOf(origin.destination) == stray ? 1 : 0);
        }
        return sum;
    };
    const WalkSolution free = solve(0.1);
    const double shown = strayIn(free.walk);
    ASSERT_GT(shown, 3) << "or the next shows nothing";
    const WalkGraph graph(world.graph, world.costs, WalkWorld::alpha, {});
    double weights = 0;
    for (std::size_t i = 0; i < free.walk.transitionCount(); ++i)
        weights += graph.move(graph.transition(free.walk.transition(i))).weight;
    EXPECT_NEAR(free.cost.edges, weights + 0.1 * WalkWorld::alpha * shown, 1e-9);
    EXPECT_LT(strayIn(solve(1000).walk), 0.2 * shown);
}

TEST(WalkPace, KeepsAnEvenPaceInTransitionsWhereThatIsAsked)
{
    constexpr double fps = 30;
    WalkWorld world({.seed = 4, .counts = {40, 40, 40}, .missing = 0.3, .shortest = 4});
    world.roots.stances.height = 1.8;
    WalkMaterial material = world.material();
    material.motion.fps = fps;
    const PathConstraint path = longCurve();
    const auto solve = [&](double weight) {
        return findWalk(material, {.path = path}, {.budget = 20'000, .unevenWeight = weight});
    };
    const WalkSolution free = solve(0);
    const WalkSolution even = solve(1000);
    EXPECT_LT(plainUnevenness(world, even.walk, fps), 0.6 * plainUnevenness(world, free.walk, fps));
    const WalkGraph graph(world.graph, world.costs, WalkWorld::alpha, {});
    double weights = 0;
    for (std::size_t i = 0; i < even.walk.transitionCount(); ++i)
        weights += graph.move(graph.transition(even.walk.transition(i))).weight;
    for (const WalkSpan& span : even.walk.spans)
        weights += WalkWorld::alpha * (span.frameCount() - 1);
    const double charged = 1000 * WalkWorld::alpha * plainUnevenness(world, even.walk, fps);
    EXPECT_GT(charged, 0);
    // Single precision of the steps of transitions.
    EXPECT_NEAR(even.cost.edges, weights + charged, 1e-3 * charged);
}
