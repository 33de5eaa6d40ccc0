// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/soles.h"
#include "model/synthesis/clips/stances.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/clips/supports.h"

#include <array>
#include <gtest/gtest.h>

using namespace quadrille;

namespace {

constexpr std::uint32_t left = 1;
constexpr std::uint32_t right = 2;

/// Frames 0 … 9 stand on the left foot, 10 … 19 on the right one, 20 … 29 fly.
Stances takesOnOneFootEach()
{
    Stances stances{.feet = {{"left", {}}, {"right", {}}}, .height = 2};
    stances.standing.assign(30, 0);
    std::fill_n(stances.standing.begin(), 10, left);
    std::fill_n(stances.standing.begin() + 10, 10, right);
    return stances;
}

/// Of whose poses nothing is asked.
Clip clipOfOrigins(const std::vector<FrameProvenance>& origins, double fps)
{
    return {.topology = {}, .fps = fps, .positions = {}, .origins = origins};
}

} // namespace

TEST(Stances, FlightsAreLongerThanAMissedContact)
{
    // Two takes; the second begins in the air, and each has a frame whose contact was missed.
    Stances stances{.feet = {{"left", {}}}, .height = 2};
    stances.standing = {1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 1};
    const std::array<std::int64_t, 2> counts{8, 5};
    const FrameLayout layout(counts);
    EXPECT_EQ(framesInAir(stances, layout, 25),
              (std::vector<bool>{false, false, false, true, true, false, false, false, true, true, false,
                                 false, false}));
    EXPECT_EQ(framesInAir(stances, layout, 100), std::vector<bool>(13, false));
    stances.standing.assign(13, 0);
    EXPECT_TRUE(framesInAir(stances, layout, 25).empty());
}

TEST(Stances, AreThoseOfTheFrameThatCountsMore)
{
    const std::vector<FrameProvenance> blend{{3, 3}, {4, 12, 0.2}, {5, 13, 0.49}, {6, 14, 0.5}, {15, 15}};
    EXPECT_EQ(stancesOf(clipOfOrigins(blend, 25), takesOnOneFootEach()),
              (std::vector<std::uint32_t>{left, left, left, right, right}));
    std::vector<FrameProvenance> mirrored = blend;
    for (FrameProvenance& origin : mirrored)
        origin.mirrored = true;
    EXPECT_EQ(stancesOf(clipOfOrigins(mirrored, 25), takesOnOneFootEach()),
              (std::vector<std::uint32_t>{right, right, right, left, left}));
}

TEST(Stances, GoOnThroughABlendThatLeavesTheGroundForAMoment)
{
    // The source flies in the second half of its window, the destination stands from the middle on.
    const std::vector<FrameProvenance> blend{{0, 0},       {1, 2, 0.1},  {21, 3, 0.3}, {22, 4, 0.4},
                                             {23, 5, 0.6}, {24, 6, 0.8}, {7, 7}};
    EXPECT_EQ(stancesOf(clipOfOrigins(blend, 25), takesOnOneFootEach()), std::vector<std::uint32_t>(7, left));
    // For longer than a fifth of a second it is a step of its own.
    EXPECT_EQ(stancesOf(clipOfOrigins(blend, 5), takesOnOneFootEach()),
              (std::vector<std::uint32_t>{left, left, 0, 0, left, left, left}));
    // What was captured stays as it was.
    const std::vector<FrameProvenance> captured{{9, 9}, {20, 20}, {0, 0}};
    EXPECT_EQ(stancesOf(clipOfOrigins(captured, 25), takesOnOneFootEach()),
              (std::vector<std::uint32_t>{left, 0, left}));
}

TEST(Soles, OfAFootThatRollsDoNotSlip)
{
    const Ground ground(UpAxis::Z);
    // A foot of three vertices, 30 cm long: flat, then on its toe, then shifted as a whole.
    const std::array<std::uint32_t, 3> foot{0, 1, 2};
    const std::vector<Vec3f> flat{{0, 0, 0}, {0.15F, 0, 0}, {0.3F, 0, 0}};
    const std::vector<Vec3f> onToe{{0.06F, 0, 0.2F}, {0.17F, 0, 0.1F}, {0.3F, 0, 0}};
    std::vector<Vec3f> shifted = flat;
    for (Vec3f& position : shifted)
        position += Vec3f(0, 0.05F, 0);
    EXPECT_NEAR(soleSlip(flat, onToe, foot, 1.8, ground), 0, 1e-6);
    EXPECT_NEAR(soleSlip(flat, shifted, foot, 1.8, ground), 0.05, 1e-6);
}

TEST(StepCosts, CountFeetThatDifferAndMovementsThatDo)
{
    // Two takes of three frames each, z up: the second one is the first, a quarter turn on and half as fast.
    const std::array<std::int64_t, 2> counts{3, 3};
    const FrameLayout layout(counts);
    Table<float> turns = Table<float>::Zero(6, 6);
    turns.block(0, 3, 3, 3) = static_cast<float>(-std::numbers::pi / 2); // lays the column on the row
    turns.block(3, 0, 3, 3) = static_cast<float>(std::numbers::pi / 2);
    RootPoses roots{.up = UpAxis::Z, .turns = SharedTable<float>(turns)};
    roots.stances = {.feet = {{"left", {}}, {"right", {}}}, .height = 2};
    roots.stances.standing = {left, left | right, right, right, right, 0};
    for (int f = 0; f < 3; ++f)
        roots.centres.emplace_back(0.2 * f, 0, 1);
    for (int f = 0; f < 3; ++f)
        roots.centres.emplace_back(0, 0.1 * f, 1);
    for (const Vec3d& centre : roots.centres) {
        roots.stances.places.push_back(centre); // the left foot goes along, the right one stays
        roots.stances.places.emplace_back(0, 0, 0);
    }
    const StepCosts parts = stepCosts(roots, layout, 10);
    EXPECT_FLOAT_EQ(parts.contacts(0, 1), 0.5F);
    EXPECT_FLOAT_EQ(parts.contacts(0, 2), 1);
    EXPECT_FLOAT_EQ(parts.contacts(2, 3), 0);
    EXPECT_FLOAT_EQ(parts.contacts(1, 5), 1);
    // 2 m/s against 1 m/s is half a height a second, for the centre and on average for one of two feet.
    EXPECT_NEAR(parts.velocity(1, 4), 0.5 + 0.25, 1e-6);
    EXPECT_NEAR(parts.velocity(0, 1), 0, 1e-6);
    EXPECT_TRUE((parts.velocity.matrix() - parts.velocity.matrix().transpose()).isZero(1e-6F));
    EXPECT_TRUE(parts.contacts.matrix().diagonal().isZero());
    const Table<float> distances = Table<float>::Constant(6, 6, 0.1F);
    const Table<float> steps = weightedSteps(distances, parts, {.contacts = 0.2, .velocity = 0.4});
    EXPECT_NEAR(steps(0, 2), 0.1 + 0.2, 1e-6);
    EXPECT_NEAR(steps(1, 4), 0.1 + 0.2 * 0.5 + 0.4 * 0.75, 1e-6);
    EXPECT_TRUE((weightedSteps(distances, parts, {}) == distances).all());
    Table<float> inPlace = distances;
    addStepCosts(inPlace, StepDifferences(roots, layout, 10), {.contacts = 0.2, .velocity = 0.4});
    EXPECT_TRUE((inPlace == steps).all());
}

TEST(StepCosts, AreNothingWhereNobodyKnowsOfFeet)
{
    const std::array<std::int64_t, 1> counts{2};
    const RootPoses roots{.up = UpAxis::Y,
                          .centres = {{0, 0, 0}, {1, 0, 0}},
                          .turns = SharedTable<float>(Table<float>::Zero(2, 2))};
    const StepCosts parts = stepCosts(roots, FrameLayout(counts), 25);
    EXPECT_TRUE((parts.contacts == 0).all() && (parts.velocity == 0).all());
    Table<float> steps = Table<float>::Constant(2, 2, 0.5F);
    addStepCosts(steps, StepDifferences(roots, FrameLayout(counts), 25), {.contacts = 1, .velocity = 1});
    EXPECT_TRUE((steps == 0.5F).all());
}

TEST(Supports, AreThinnedAlikeInAllFrames)
{
    std::vector<Support> supports(2);
    for (std::uint32_t v = 0; v < 100; ++v) {
        supports[0].vertices.push_back(v);
        supports[0].places.emplace_back(v, 0);
    }
    supports[1].vertices = {1, 3};
    supports[1].places = {{1, 5}, {3, 5}};
    thinSupports(supports, 10);
    EXPECT_EQ(supports[0].vertices, (std::vector<std::uint32_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}));
    EXPECT_EQ(supports[0].places[3], Vec2d(30, 0));
    EXPECT_EQ(supports[1].vertices, (std::vector<std::uint32_t>{1, 3})); // none of them would be left
    thinSupports(supports, 10);
    EXPECT_EQ(supports[0].vertices.size(), 10U);
}
