// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/synthesis/walks/findwalk.h"
#include "model/synthesis/walks/walkrepair.h"
#include "tests/model/codeof.h"
#include "tests/model/synthesis/walkworld.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace quadrille;
using quadrille::test::WalkWorld;

namespace {

/// Transitions of a walk that another one does not have.
std::vector<std::size_t> missing(const Walk& walk, const Walk& other)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < walk.transitionCount(); ++i) {
        bool isThere = false;
        for (std::size_t j = 0; j < other.transitionCount(); ++j)
            isThere = isThere || other.transition(j) == walk.transition(i);
        if (!isThere)
            places.push_back(i);
    }
    return places;
}

int timesUsed(const Walk& walk, const FramePair& pair)
{
    int times = 0;
    for (std::size_t i = 0; i < walk.transitionCount(); ++i)
        times += walk.transition(i) == pair ? 1 : 0;
    return times;
}

/// A world of four takes, and walks through them that are long enough for some transitions.
class WalkRepairs : public testing::TestWithParam<unsigned>
{
protected:
    WalkWorld m_world{{.seed = GetParam(), .counts = {40, 35, 45, 30}, .missing = 0.9, .shortest = 3}};

    const SearchSettings settings{.budget = 20'000, .leftOutWeight = 5};

    WalkConstraints actions() const
    {
        WalkConstraints asked;
        for (const int sequence : {0, 2, 1, 3, 0}) {
            FrameSet frames = m_world.sequence(sequence);
            frames.spans.front().first += 4;
            frames.spans.front().last -= 4;
            asked.actions.push_back({.frames = frames, .leastShare = 0.4});
        }
        return asked;
    }

    WalkConstraints path() const
    {
        WalkConstraints asked;
        asked.path = PathConstraint{.points = {{0, 0, 0}, {2, 0, 0}, {4, 1, 0}}};
        return asked;
    }

    WalkSolution find(const WalkConstraints& asked) const
    {
        return findWalk(m_world.material(), asked, settings);
    }
};

TEST_P(WalkRepairs, LockingKeepsTheWalkAndSeeksNothing)
{
    for (WalkConstraints asked : {actions(), path()}) {
        const WalkSolution before = find(asked);
        ASSERT_GT(before.walk.transitionCount(), 1);
        asked.junctions.walk = before.walk;
        asked.junctions.required = {before.walk.transition(0), before.walk.transition(1)};
        const WalkSolution after = find(asked);
        EXPECT_EQ(after.walk, before.walk);
        EXPECT_NEAR(after.totalCost, before.totalCost, 1e-9 * before.totalCost);
        EXPECT_EQ(after.actions, before.actions);
        EXPECT_EQ(after.expansions, 0);
    }
}

TEST_P(WalkRepairs, BanningChangesTheTransitionAndOneNextToIt)
{
    for (WalkConstraints asked : {actions(), path()}) {
        const WalkSolution before = find(asked);
        asked.junctions.walk = before.walk;
        for (std::size_t i = 0; i < before.walk.transitionCount(); ++i) {
            asked.junctions.banned = {before.walk.transition(i)};
            if (timesUsed(before.walk, before.walk.transition(i)) > 1)
                continue;
            const auto after = repairedWalk(m_world.material(), asked, settings);
            ASSERT_TRUE(after) << i;
            EXPECT_EQ(timesUsed(after->walk, before.walk.transition(i)), 0);
            auto changed = missing(before.walk, after->walk);
            // A path that ends sooner leaves the last ones out.
            while (asked.path && changed.size() > 1 && changed.back() > i)
                changed.pop_back();
            ASSERT_LE(changed.size(), 2)
                << i << ": " << testing::PrintToString(changed) << " of " << before.walk.transitionCount()
                << ", now " << after->walk.transitionCount() << (asked.path ? " path" : "");
            for (const std::size_t place : changed)
                EXPECT_LE(std::max(place, i) - std::min(place, i), 1);
        }
    }
}

TEST_P(WalkRepairs, NoExchangeMakesAWalkThatWasFoundCheaper)
{
    WalkConstraints asked = path();
    const SearchSettings hasty{.budget = 300};
    const WalkSolution before = findWalk(m_world.material(), asked, hasty);
    asked.junctions.walk = before.walk;
    for (std::size_t i = 0; i < before.walk.transitionCount(); ++i) {
        // One that is used twice is exchanged twice, for which none was looked.
        if (timesUsed(before.walk, before.walk.transition(i)) > 1)
            continue;
        asked.junctions.banned = {before.walk.transition(i)};
        const auto other = repairedWalk(m_world.material(), asked, hasty);
        EXPECT_GE(other ? other->totalCost : unreachable, before.totalCost * (1 - 2e-6));
    }
}

TEST_P(WalkRepairs, WhatABanBroughtCanBeChosen)
{
    WalkConstraints asked = actions();
    const WalkSolution before = find(asked);
    asked.junctions.walk = before.walk;
    for (std::size_t i = 0; i < before.walk.transitionCount(); ++i) {
        asked.junctions = {.banned = {before.walk.transition(i)}, .walk = before.walk};
        const auto banned = repairedWalk(m_world.material(), asked, settings);
        ASSERT_TRUE(banned);
        const auto brought = missing(banned->walk, before.walk);
        const FrameLayout& layout = m_world.costs.layout();
        const FramePair chosen = banned->walk.transition(brought.front());
        const FramePair now = before.walk.transition(i);
        if (brought.size() != 1 || layout.sequenceOf(chosen.source) != layout.sequenceOf(now.source) ||
            layout.sequenceOf(chosen.destination) != layout.sequenceOf(now.destination))
            continue; // by way of another take
        asked.junctions = {.required = {chosen}, .walk = before.walk};
        const auto after = repairedWalk(m_world.material(), asked, settings);
        ASSERT_TRUE(after);
        EXPECT_EQ(timesUsed(after->walk, chosen), 1);
    }
}

/// The plain reference: every single exchange of the transition, tried by a walk that is required whole.
TEST_P(WalkRepairs, NoSingleExchangeIsCheaper)
{
    WalkConstraints asked = actions();
    const WalkSolution before = find(asked);
    const std::size_t place = 0;
    const FramePair now = before.walk.transition(place);
    asked.junctions.walk = before.walk;
    asked.junctions.banned = {now};
    const auto after = repairedWalk(m_world.material(), asked, settings);
    ASSERT_TRUE(after);
    const FrameLayout& layout = m_world.costs.layout();
    int tried = 0;
    for (const Edge& edge : m_world.graph.edges()) {
        const bool isLike = layout.sequenceOf(edge.from) == layout.sequenceOf(now.source) &&
                            layout.sequenceOf(edge.to) == layout.sequenceOf(now.destination);
        Walk walk = before.walk;
        walk.spans[place].last = edge.from;
        walk.spans[place + 1].first = edge.to;
        if (edge.kind != EdgeKind::Transition || !isLike || FramePair{edge.from, edge.to} == now ||
            walk.spans[place].frameCount() < 1 || walk.spans[place + 1].frameCount() < 1)
            continue;
        WalkConstraints whole = actions();
        whole.junctions.walk = walk;
        if (const auto solved = repairedWalk(m_world.material(), whole, settings)) {
            ++tried;
            EXPECT_LE(after->totalCost, solved->totalCost + 1e-9);
        }
    }
    EXPECT_GT(tried, 0);
}

TEST_P(WalkRepairs, IsSoughtAnewWhereTheWalkDoesNotMeetWhatIsAsked)
{
    WalkConstraints asked = actions();
    const WalkSolution before = find(asked);
    asked.actions.erase(asked.actions.begin());
    asked.actions.push_back({.frames = m_world.sequence(2), .leastShare = 0.9});
    WalkConstraints kept = asked;
    kept.junctions.walk = before.walk;
    EXPECT_FALSE(repairedWalk(m_world.material(), kept, settings));
    EXPECT_EQ(find(kept).walk, find(asked).walk);
}

TEST_P(WalkRepairs, WalksWithFramesAroundThemAreCutToWhatIsAsked)
{
    WalkConstraints asked = actions();
    const WalkSolution before = find(asked);
    Walk longer = before.walk;
    const FrameLayout& layout = m_world.costs.layout();
    longer.spans.front().first = layout.firstOf(layout.sequenceOf(longer.spans.front().first));
    longer.spans.back().last = layout.lastOf(layout.sequenceOf(longer.spans.back().last));
    asked.junctions.walk = longer;
    EXPECT_EQ(find(asked).walk, before.walk);
}

TEST_P(WalkRepairs, StopsWhenCancelled)
{
    WalkConstraints asked = actions();
    asked.junctions.walk = find(asked).walk;
    asked.junctions.banned = {asked.junctions.walk.transition(0)};
    CancelToken token;
    token.cancel();
    EXPECT_EQ(test::codeOf([&] { repairedWalk(m_world.material(), asked, settings, Progress(token)); }),
              ErrorCode::Cancelled);
}

TEST_P(WalkRepairs, FramesThatDoNotExistAreRefused)
{
    WalkConstraints asked = actions();
    asked.junctions.walk.spans = {{0, 1000}};
    EXPECT_EQ(test::codeOf([&] { find(asked); }), ErrorCode::BadArgument);
}

INSTANTIATE_TEST_SUITE_P(Worlds, WalkRepairs, testing::Values(1, 2, 3, 5));

} // namespace
