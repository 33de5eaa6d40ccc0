// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/synthesis/walkworld.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::WalkWorld;

constexpr double weight = 200;

/// Three takes; in the middle of the second one the figure jumps.
struct JumpWorld
{
    explicit JumpWorld(std::uint32_t seed)
        : world({.seed = seed, .counts = {24, 24, 24}, .missing = 0.5, .shortest = 4})
        , material(world.material())
    {
        material.inAir.assign(72, false);
        std::fill(material.inAir.begin() + takeOff, material.inAir.begin() + landing, true);
    }

    static constexpr NodeIndex takeOff = 33;
    static constexpr NodeIndex landing = 40;
    static constexpr NodeIndex top = 36;
    WalkWorld world;
    WalkMaterial material;

    bool isInAir(NodeIndex node) const { return material.inAir[static_cast<std::size_t>(node)]; }
    /// Transitions from the ground into flight or out of it.
    int broken(const Walk& walk) const
    {
        int count = 0;
        for (std::size_t i = 0; i < walk.transitionCount(); ++i) {
            const FramePair pair = walk.transition(i);
            count += isInAir(pair.source) != isInAir(pair.destination);
        }
        return count;
    }
};

TEST(Flight, AKeyAtTheTopOfAJumpIsReachedByItsTakeOff)
{
    int without = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const JumpWorld jump(seed);
        const WalkConstraints constraints{
            .keys = {{.frame = 3, .time = 0}, {.frame = JumpWorld::top, .time = 30}}};
        without += jump.broken(findWalk(jump.material, constraints, {}).walk);
        const WalkSolution solution = findWalk(jump.material, constraints, {.flightWeight = weight});
        EXPECT_EQ(jump.broken(solution.walk), 0) << seed;
        EXPECT_EQ(solution.walk.spans.back().last, JumpWorld::top);
        EXPECT_LE(solution.walk.spans.back().first, JumpWorld::takeOff) << seed;
    }
    EXPECT_GT(without, 0) << "or this shows nothing";
}

TEST(Flight, NoWalkBeginsInTheAirBeforeAKey)
{
    int without = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const JumpWorld jump(seed);
        const WalkConstraints constraints{
            .keys = {{.frame = JumpWorld::landing + 3, .time = 6}, {.frame = 60, .time = 30}}};
        without += jump.isInAir(findWalk(jump.material, constraints, {}).walk.spans.front().first);
        const Walk walk = findWalk(jump.material, constraints, {.flightWeight = weight}).walk;
        EXPECT_FALSE(jump.isInAir(walk.spans.front().first)) << seed;
    }
    EXPECT_GT(without, 0) << "or this shows nothing";
}

TEST(Flight, WhatIsAskedForMayBeginInTheAir)
{
    const JumpWorld jump(4);
    const WalkConstraints constraints{
        .keys = {{.frame = JumpWorld::top, .time = 0}, {.frame = 60, .time = 30}}};
    const Walk walk = findWalk(jump.material, constraints, {.flightWeight = weight}).walk;
    EXPECT_EQ(walk.spans.front().first, JumpWorld::top);
    EXPECT_EQ(jump.broken(walk), 0) << "it lands before it goes on";
}

} // namespace
} // namespace quadrille
