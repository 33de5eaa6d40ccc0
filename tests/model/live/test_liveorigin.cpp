// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/liveorigin.h"
#include "tests/model/live/livefixture.h"

#include <gtest/gtest.h>
#include <map>

using namespace quadrille;
using namespace quadrille::test;

namespace {

using Looks = std::map<std::pair<std::size_t, std::size_t>, double>;

/// How much of what is seen is of each take.
Looks looksOf(const LiveLook& look)
{
    Looks looks;
    looks[{look.first.space, look.first.take}] += 1 - look.weight;
    looks[{look.second.space, look.second.take}] += look.weight;
    return looks;
}

double greatestChange(const Looks& before, const Looks& after)
{
    double greatest = 0;
    for (const auto& [take, weight] : after) {
        const auto found = before.find(take);
        greatest = std::max(greatest, std::abs(weight - (found == before.end() ? 0 : found->second)));
    }
    return greatest;
}

} // namespace

TEST(LiveOrigin, FadesByTheSharesOfTakes)
{
    const auto graph = swingingGraph();
    LiveState state;
    state.track = {.space = walking, .phase = 3.2, .place = {0.875}};
    const LiveLook within = lookOf(*graph, state);
    EXPECT_EQ(within.first.take, 0U);
    EXPECT_EQ(within.first.frame, 3U);
    EXPECT_NEAR(within.first.share, 0.75, 1e-12);
    EXPECT_EQ(within.second.take, 1U);
    EXPECT_NEAR(within.weight, 0.25, 1e-12);
    EXPECT_EQ(provenanceOf(*graph, state), within.first);

    EXPECT_EQ(within.second.frame, 3U);
}

TEST(LiveOrigin, FadesFromTakeToTakeWhileSpacesChange)
{
    const auto graph = swingingGraph();
    LiveState state;
    state.left = {.space = walking, .phase = 3, .place = {0.875}};
    state.track = {.space = turning, .phase = 7, .place = {36}}; // a fifth of the first, the rest the second
    const auto at = [&](double fade) {
        state.fade = fade;
        return lookOf(*graph, state);
    };
    // The old space's second take goes first, over a sixth of the time.
    EXPECT_EQ(at(0).second.take, 1U);
    EXPECT_NEAR(at(0).weight, 0.25, 1e-12);
    EXPECT_NEAR(at(1.0 / 12).weight, 0.125, 1e-12);
    // Then one take of each space.
    EXPECT_EQ(at(0.3).first.space, walking);
    EXPECT_EQ(at(0.3).first.take, 0U);
    EXPECT_EQ(at(0.3).second.space, turning);
    EXPECT_EQ(at(0.3).second.take, 1U);
    EXPECT_NEAR(at(0.5).weight, 0.5, 1e-12);
    EXPECT_NEAR(at(0.5).first.share, 0.4, 1e-12);
    EXPECT_EQ(at(0.7).first.space, turning);
    EXPECT_NEAR(at(0.3).weight, at(0.7).weight, 1e-12);
    // The new space's second take comes last.
    EXPECT_EQ(at(11.0 / 12).first.take, 1U);
    EXPECT_EQ(at(11.0 / 12).second.take, 0U);
    EXPECT_NEAR(at(11.0 / 12).weight, 0.1, 1e-12);
    EXPECT_NEAR(at(1).weight, 0.2, 1e-12);
}

TEST(LiveOrigin, IsOneFrameWhereOneTakeHasAll)
{
    const auto graph = swingingGraph();
    LiveState state;
    state.track = {.space = walking, .place = {2}};
    const LiveLook look = lookOf(*graph, state);
    EXPECT_EQ(look.first.take, 1U);
    EXPECT_EQ(look.second, look.first);
    EXPECT_EQ(look.weight, 0);
}

TEST(LiveOrigin, LooksDoNotJumpThroughTransitionsAndSteering)
{
    const auto graph = swingingGraph();
    LivePlayer player(graph, {}, {.space = walking, .parameters = {1}});
    Random random(3);
    Looks before = looksOf(player.look());
    double greatest = 0;
    int nearestJumps = 0;
    LiveProvenance nearest = player.provenance();
    for (int wish = 0; wish < 60; ++wish) {
        const auto space = static_cast<std::size_t>(random.between(0, 3));
        const double value = space == turning ? random.between(-60, 60) : random.between(0.5, 2);
        for (int t = 0; t < 90; ++t) {
            player.tick({.space = space, .parameters = {value}});
            const LiveLook look = player.look();
            EXPECT_LE(look.weight, 0.5 + 1e-12);
            const Looks after = looksOf(look);
            greatest = std::max(greatest, greatestChange(before, after));
            before = after;
            const LiveProvenance now = player.provenance();
            nearestJumps += now.space != nearest.space || now.take != nearest.take ? 1 : 0;
            nearest = now;
        }
    }
    // A half of what is seen may go within a sixth of the fade.
    EXPECT_LT(greatest, 3.01 * player.tickSeconds() / player.settings().fadeSeconds);
    EXPECT_GT(nearestJumps, 60);
}
