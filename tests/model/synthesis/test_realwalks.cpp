// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Walks through real takes: what an animator would ask for.
#include "model/synthesis/walks/findwalk.h"
#include "tests/model/synthesis/realcharacter.h"

#include <gtest/gtest.h>

using namespace quadrille;
using quadrille::test::RealCharacter;
using quadrille::test::realCharacter;

namespace {

class RealWalks : public ::testing::Test
{
protected:
    void SetUp() override
    {
        if (!m_character)
            GTEST_SKIP() << "no real takes";
        m_warps.emplace(m_character->distances, m_character->layout, m_character->settings);
    }

    void followAnSCurveAndRunOnTheWay() const;
    void areFoundAgainAndNoneIsWorseForMoreTime() const;
    void keepTheTimesOfKeys() const;
    void performActionsInOrder() const;
    void combineAPathWithAKeyAndAnAction() const;
    /// A path that is run between two places, metres from its beginning.
    WalkConstraints runningThrough(const std::vector<Vec2d>& points, double from, double to) const;
    WalkSolution find(const WalkConstraints& constraints, const SearchSettings& settings) const
    {
        const auto transition = [this](const FramePair& frames) {
            return *m_warps->of(m_character->table, frames);
        };
        return findWalk({.graph = m_character->essential.graph,
                         .costs = m_character->costs,
                         .alpha = RealCharacter::alpha,
                         .motion = {.roots = &m_character->roots, .transition = transition}},
                        constraints, settings);
    }

    const RealCharacter* m_character = realCharacter();
    std::optional<WarpPaths> m_warps;
};

WalkConstraints RealWalks::runningThrough(const std::vector<Vec2d>& points, double from, double to) const
{
    const Ground ground(UpAxis::Y);
    std::vector<Vec3d> through;
    for (const Vec2d& point : points)
        through.push_back(ground.at(point, 0));
    return {.path = PathConstraint{
                .points = sampleCurve(through, 0.02),
                .spans = {{.from = from, .to = to, .demanded = m_character->framesOf("run")}}}};
}

void RealWalks::followAnSCurveAndRunOnTheWay() const
{
    const WalkSolution solution =
        find(runningThrough({{0, 0}, {3, 1.5}, {6, 0}, {9, -1.5}, {12, 0}}, 5, 8), {.budget = 10'000});
    EXPECT_LT(solution.meanDeviation, 0.15);
    EXPECT_LT(solution.greatestDeviation, 0.3);
    EXPECT_GT(solution.frameCount, 240);
}

void RealWalks::areFoundAgainAndNoneIsWorseForMoreTime() const
{
    const WalkConstraints constraints = runningThrough({{0, 0}, {1.5, 0.75}, {3, 0}}, 1, 2.5);
    const WalkSolution solution = find(constraints, {.budget = 10'000});
    EXPECT_FALSE(solution.optimal) << "more time would change nothing";
    EXPECT_EQ(solution, find(constraints, {.budget = 10'000}));
    EXPECT_LE(find(constraints, {.budget = 30'000}).totalCost, solution.totalCost);
}

void RealWalks::keepTheTimesOfKeys() const
{
    const auto key = [this](const char* take, NodeIndex frame, double time) {
        return PoseKey{m_character->takes.at(take).first + frame, time};
    };
    const WalkConstraints constraints{.keys = {key("walk_1", 20, 0), key("kick_1", 30, 120),
                                               key("dance_1", 40, 260), key("sit_1", 25, 400)}};
    const WalkSolution pairs = find(constraints, {.budget = 10'000'000});
    EXPECT_TRUE(pairs.optimal);
    for (const KeyTime& time : pairs.keys)
        EXPECT_NEAR(static_cast<double>(time.obtained), time.wanted, 15);
    const WalkSolution all = find(constraints, {.budget = 10'000'000, .globalKeys = true});
    EXPECT_TRUE(all.optimal);
    EXPECT_LE(all.totalCost, pairs.totalCost + 1e-9);
}

void RealWalks::performActionsInOrder() const
{
    const WalkConstraints constraints{.actions = {{.frames = m_character->framesOf("walk"), .duration = 90},
                                                  {.frames = m_character->framesOf("kick")},
                                                  {.frames = m_character->framesOf("jump"), .repetitions = 2},
                                                  {.frames = m_character->framesOf("sit")}}};
    const WalkSolution solution = find(constraints, {.budget = 1'000'000});
    EXPECT_TRUE(solution.optimal);
    ASSERT_EQ(solution.actions.size(), 4U);
    for (std::size_t a = 1; a < solution.actions.size(); ++a)
        EXPECT_GT(solution.actions[a].first, solution.actions[a - 1].last);
    EXPECT_NEAR(static_cast<double>(solution.actions[0].count()), 90, 5);
}

void RealWalks::combineAPathWithAKeyAndAnAction() const
{
    const Ground ground(UpAxis::Y);
    const WalkConstraints constraints{
        .keys = {{m_character->takes.at("reach_high").first + 28, 120, 60}},
        .path = PathConstraint{.points = sampleCurve(
                                   {ground.at({0, 0}, 0), ground.at({4, 1}, 0), ground.at({8, 0}, 0)}, 0.02)},
        .actions = {{.frames = m_character->framesOf("kick")}}};
    const WalkSolution solution = find(constraints, {.budget = 40'000});
    EXPECT_LT(solution.meanDeviation, 0.3);
    ASSERT_EQ(solution.keys.size(), 1U);
    EXPECT_NEAR(static_cast<double>(solution.keys[0].obtained), 120, 60);
    EXPECT_GE(solution.actions[0].count(), 29) << "half of the shorter kick";
}

} // namespace

// One test, because the transitions of all takes are computed once for each program that runs.
TEST_F(RealWalks, MeetWhatAnAnimatorAsksFor)
{
    followAnSCurveAndRunOnTheWay();
    areFoundAgainAndNoneIsWorseForMoreTime();
    keepTheTimesOfKeys();
    performActionsInOrder();
    combineAPathWithAKeyAndAnAction();
}
