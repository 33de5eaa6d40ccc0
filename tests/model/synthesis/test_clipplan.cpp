// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "tests/model/synthesis/cliptest.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

const TubeTakes& planTakes()
{
    static const TubeTakes only(threeTakes());
    return only;
}

std::vector<FrameProvenance> originsOf(const ClipPlan& plan)
{
    std::vector<FrameProvenance> origins;
    for (const PlannedFrame& frame : plan.frames)
        origins.push_back(frame.origin);
    return origins;
}

std::string messageOf(const Walk& walk)
{
    try {
        planTakes().plan(walk);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(ClipPlan, ShowsTheEndsOfATransitionOnce)
{
    const Walk walk{{{3, 5}, {27, 28}}};
    const std::vector<Transition> transitions{advancingTogether(5, 27, 4)};
    const ClipPlan plan = planClip(planTakes().roots, walk, transitions);
    const std::vector<FrameProvenance> expected{{3, 3},           {4, 4},   {5, 5},  {6, 25, 1.0 / 3},
                                                {7, 26, 2.0 / 3}, {27, 27}, {28, 28}};
    EXPECT_EQ(originsOf(plan), expected);
    ASSERT_EQ(plan.junctions.size(), 1U);
    EXPECT_EQ(plan.junctions[0].frames, (FramePair{5, 27}));
    EXPECT_EQ(plan.junctions[0].first, 2);
    EXPECT_EQ(plan.junctions[0].last, 5);
    EXPECT_TRUE(plan.junctions[0].contains(4));
    EXPECT_FALSE(plan.junctions[0].contains(6));
    EXPECT_EQ(plan.spanStarts, (std::vector<std::int64_t>{0, 5}));
}

TEST(ClipPlan, SpansOfOneFrameJoinTransitions)
{
    const Walk walk{{{0, 0}, {27, 27}, {44, 44}}};
    const ClipPlan plan = planClip(planTakes().roots, walk,
                                   std::vector{advancingTogether(0, 27, 4), advancingTogether(27, 44, 3)});
    const std::vector<FrameProvenance> expected{{0, 0},   {1, 25, 1.0 / 3}, {2, 26, 2.0 / 3},
                                                {27, 27}, {28, 43, 0.5},    {44, 44}};
    EXPECT_EQ(originsOf(plan), expected);
    EXPECT_EQ(plan.junctions[0].last, plan.junctions[1].first);
    EXPECT_EQ(plan.spanStarts, (std::vector<std::int64_t>{0, 3, 5}));
}

TEST(ClipPlan, TransitionsOfOneFrameShowThePoseThatTheyLeave)
{
    const Walk walk{{{2, 3}, {27, 28}, {44, 44}}};
    const ClipPlan plan = planClip(planTakes().roots, walk,
                                   std::vector{advancingTogether(3, 27, 1), advancingTogether(28, 44, 1)});
    EXPECT_EQ(originsOf(plan), (std::vector<FrameProvenance>{{2, 2}, {3, 3}, {28, 28}}));
    EXPECT_EQ(plan.spanStarts, (std::vector<std::int64_t>{0, 1, 2}));
    EXPECT_EQ(plan.junctions[0].first, plan.junctions[0].last);
    // The next frame goes on from the pose that is not shown.
    const Ground ground(UpAxis::Z);
    const auto groundOf = [&](NodeIndex node) {
        return ground.of(planTakes().roots.centres[static_cast<std::size_t>(node)]);
    };
    EXPECT_TRUE(plan.frames[2].placeSource(groundOf(27)).isApprox(groundOf(3), 1e-9));
    EXPECT_NEAR(plan.frames[2].placeSource.turn, static_cast<double>(planTakes().roots.turns(3, 27)), 1e-9);
}

TEST(ClipPlan, LastsAsLongAsItsParts)
{
    const Walk walk{{{2, 5}, {30, 33}, {50, 50}, {12, 19}}};
    const ClipPlan plan = planTakes().plan(walk);
    std::int64_t expected = 4 + 4 + 1 + 8;
    for (std::size_t t = 0; t < 3; ++t)
        expected += planTakes().paths.get(walk.transition(t)).length() - 2;
    EXPECT_EQ(plan.frameCount(), expected);
    for (std::size_t t = 0; t < 3; ++t) {
        const ClipPlan::Junction& junction = plan.junctions[t];
        const auto originAt = [&](std::int64_t frame) {
            return plan.frames[static_cast<std::size_t>(frame)].origin;
        };
        EXPECT_EQ(junction.last - junction.first + 1, planTakes().paths.get(walk.transition(t)).length());
        EXPECT_EQ(originAt(junction.first), (FrameProvenance{walk.spans[t].last, walk.spans[t].last}));
        EXPECT_EQ(originAt(junction.last),
                  (FrameProvenance{walk.spans[t + 1].first, walk.spans[t + 1].first}));
        EXPECT_EQ(junction.last, plan.spanStarts[t + 1]);
        EXPECT_EQ(junction.cost, planTakes().paths.get(walk.transition(t)).cost);
    }
}

TEST(ClipPlan, BlendsOfAFrameWithItselfAreCaptured)
{
    Transition transition = advancingTogether(5, 8, 4);
    transition.path = {{5, 5}, {6, 6}, {7, 7}, {8, 8}};
    const ClipPlan plan = planClip(planTakes().roots, {{{5, 5}, {8, 8}}}, std::vector{transition});
    EXPECT_EQ(originsOf(plan), (std::vector<FrameProvenance>{{5, 5}, {6, 6}, {7, 7}, {8, 8}}));
}

TEST(ClipPlan, RefusesWhatCannotBePlayed)
{
    EXPECT_NE(messageOf({}).find("no frames"), std::string::npos);
    EXPECT_NE(messageOf({{{5, 25}}}).find("frames 5 to 25"), std::string::npos);
    EXPECT_NE(messageOf({{{5, 4}}}).find("not frames of one sequence"), std::string::npos);
    EXPECT_NE(messageOf({{{0, 3}, {58, 60}}}).find("Span 2"), std::string::npos);
    EXPECT_NE(messageOf({{{-1, 3}}}).find("from 0 to 59"), std::string::npos);
    EXPECT_NE(messageOf({{{0, 18}, {30, 33}}}).find("no transition from frame 18 to frame 30"),
              std::string::npos);
    EXPECT_NE(messageOf({{{0, 8}, {8, 9}}}).find("two different frames"), std::string::npos);
}

TEST(CentreTrajectories, AreThoseOfTheThreeAlignments)
{
    const Transition transition = planTakes().paths.get({4, 33});
    const CentreTrajectories trajectories = centreTrajectories(planTakes().roots, transition, 0.5);
    const auto expectSame = [&](const std::vector<Vec3d>& points, BlendAlignment alignment) {
        const TransitionMotion motion =
            transitionMotion(planTakes().roots, transition, {.alignment = alignment, .constantWeight = 0.5});
        ASSERT_EQ(points.size(), motion.steps.size());
        for (std::size_t t = 0; t < points.size(); ++t)
            EXPECT_EQ(points[t], motion.steps[t].centre);
    };
    expectSame(trajectories.everyStep, BlendAlignment::EveryStep);
    expectSame(trajectories.midWindow, BlendAlignment::MidWindow);
    expectSame(trajectories.none, BlendAlignment::None);
    EXPECT_NE(trajectories.everyStep.back(), trajectories.none.back());
}
