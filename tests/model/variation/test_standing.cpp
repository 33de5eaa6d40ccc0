// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "model/variation/standing.h"
#include "tests/model/transition/posedistancetest.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr NodeIndex frames = 30;
constexpr NodeIndex step = 15; ///< the frame in which both feet stand

std::shared_ptr<const Topology> triangle()
{
    TopologyData data{.vertexCount = 3};
    data.triangles.push_back({VertexIndex(0), VertexIndex(1), VertexIndex(2)});
    return std::make_shared<Topology>(std::move(data));
}

/// Two feet and a body, y up. The body goes at an even speed, and the feet slide while they stand: the left
/// one until the step, the right one from then on. Metres a frame.
Clip slidingSteps(double left, double right)
{
    Clip clip{.topology = triangle(), .fps = 30, .positions = {}, .origins = {}};
    for (NodeIndex f = 0; f < frames; ++f) {
        const auto t = static_cast<double>(f);
        clip.positions.push_back(Vec3d(left * t, 0, 0.1).cast<float>());
        clip.positions.push_back(Vec3d(right * (t - step), 0, -0.1).cast<float>());
        clip.positions.push_back(Vec3d(0.03 * t, 1, 0).cast<float>());
        clip.origins.push_back({f, f, 0, false});
    }
    return clip;
}

/// The height of a flight.
double arc(NodeIndex f)
{
    return 0.1 * static_cast<double>(f) * (frames - f) / frames;
}

/// The capture that the clip's frames come from: feet on the ground. \param flight  frames in which neither
/// foot stands, before the step and after it.
CapturedStanding standing(NodeIndex flight = 0)
{
    std::vector<std::vector<Vec3f>> poses;
    for (NodeIndex f = 0; f < frames; ++f) {
        const bool flies = step - flight < f && f < step + flight;
        const auto height = static_cast<float>(flies ? arc(f) : 0);
        poses.push_back({Vec3f(0, height, 0), Vec3f(0, height, 0), Vec3f(0, height + 1, 0)});
    }
    CapturedStanding captured{.character = characterOf(sequenceOf(triangle(), poses)), .supports = {}};
    for (NodeIndex f = 0; f < frames; ++f) {
        Support& support = captured.supports.emplace_back();
        if (f <= step - flight)
            support.vertices.push_back(0);
        if (f >= step + flight)
            support.vertices.push_back(1);
    }
    return captured;
}

/// How far the body's way is from a straight one at an even speed, at most over three frames.
double sharpestTurn(const Clip& clip)
{
    double largest = 0;
    for (NodeIndex f = 1; f + 1 < frames; ++f)
        largest = std::max(
            largest,
            static_cast<double>((clip.frame(f + 1)[2] - 2 * clip.frame(f)[2] + clip.frame(f - 1)[2]).norm()));
    return largest;
}

TEST(Standing, FeetThatSlideEvenlyStandStill)
{
    Clip clip = slidingSteps(0.02, 0.02);
    const Vec3f left = clip.frame(0)[0];
    keepStanding(clip, standing(), UpAxis::Y);
    const Vec3f right = clip.frame(step)[1];
    for (NodeIndex f = 0; f < frames; ++f) {
        const Positions frame = clip.frame(f);
        EXPECT_LT((frame[f <= step ? 0 : 1] - (f <= step ? left : right)).norm(), 1e-6F) << f;
        EXPECT_NEAR(frame[2].x(), 0.01 * static_cast<double>(f), 1e-6) << f;
    }
}

TEST(Standing, TheWayHasNoKinkFromStepToStep)
{
    Clip clip = slidingSteps(0.03, -0.03);
    keepStanding(clip, standing(), UpAxis::Y);
    // Left foot held, then right foot: the body stands, then goes at twice its speed, all in a frame.
    constexpr double kink = 0.06;
    EXPECT_LT(sharpestTurn(clip), 0.15 * kink);
    // As far as both steps say.
    EXPECT_NEAR(clip.frame(frames - 1)[2].x(), 2 * 0.03 * (frames - 1 - step), 1e-6);
}

TEST(Standing, WhereNothingStandsTheWayStays)
{
    Clip clip = slidingSteps(0.03, -0.03);
    const std::vector<Vec3f> before = clip.positions;
    CapturedStanding nothing = standing();
    for (Support& support : nothing.supports)
        support.vertices.clear();
    keepStanding(clip, nothing, UpAxis::Y);
    EXPECT_EQ(clip.positions, before);
}

TEST(Standing, WhatStandsIsAsHighAsItWas)
{
    Clip clip = slidingSteps(0, 0);
    for (Vec3f& position : clip.positions)
        position.y() += 0.25F;
    keepStanding(clip, standing(), UpAxis::Y);
    for (NodeIndex f = 0; f < frames; ++f) {
        EXPECT_NEAR(clip.frame(f)[0].y(), 0, 1e-6) << f;
        EXPECT_NEAR(clip.frame(f)[2].y(), 1, 1e-6) << f;
    }
}

// Where no stance is known, what is lowest stays where it was, and nothing reaches deeper.
TEST(Standing, NothingSinksWhereNoStanceIsKnown)
{
    Clip clip = slidingSteps(0, 0);
    CapturedStanding nothing = standing();
    for (Support& support : nothing.supports)
        support.vertices.clear();
    for (NodeIndex f = 0; f < frames; ++f) {
        for (Vec3f& position : clip.frame(f))
            position.y() -= 0.14F;
    }
    clip.frame(12)[0].y() -= 0.05F; // a heel
    keepStanding(clip, nothing, UpAxis::Y);
    for (NodeIndex f = 0; f < frames; ++f) {
        for (const Vec3f& position : clip.frame(f))
            EXPECT_GT(position.y(), -0.004F) << f;
    }
    EXPECT_NEAR(clip.frame(0)[0].y(), 0, 1e-6);
}

// Before the first stance that is known, and after the last, frames are as high as those that they follow,
// whatever height the stances have.
TEST(Standing, EndsWithoutStancesAreAsHighAsTheyWere)
{
    // On a step of 20 cm at first, where no stance was found, then beside it.
    std::vector<std::vector<Vec3f>> poses;
    Clip clip = slidingSteps(0, 0);
    for (NodeIndex f = 0; f < frames; ++f) {
        const float height = f < step ? 0.2F : 0;
        poses.push_back({Vec3f(0, height, 0), Vec3f(0, height, 0), Vec3f(0, height + 1, 0)});
        for (Vec3f& position : clip.frame(f))
            position.y() += height + (f < step ? 0.09F : 0.02F);
    }
    CapturedStanding captured{.character = characterOf(sequenceOf(triangle(), poses)), .supports = {}};
    captured.supports.resize(frames);
    for (std::size_t f = step; f < frames; ++f)
        captured.supports[f].vertices = {1};
    keepStanding(clip, captured, UpAxis::Y);
    EXPECT_NEAR(clip.frame(3)[0].y(), 0.2, 1e-3);
    EXPECT_NEAR(clip.frame(frames - 3)[0].y(), 0, 1e-3);
}

// A flight that is too low at its start and too high at its end keeps its curve: what it is moved by changes
// evenly, as that of the frames around it does.
TEST(Standing, AFlightKeepsItsCurve)
{
    Clip clip = slidingSteps(0, 0);
    const auto error = [](NodeIndex f) { return 0.02 * static_cast<double>(f) - 0.2; };
    constexpr NodeIndex flight = 10;
    for (NodeIndex f = 0; f < frames; ++f) {
        const bool flies = step - flight < f && f < step + flight;
        for (Vec3f& position : clip.frame(f))
            position.y() += static_cast<float>(error(f) + (flies ? arc(f) : 0));
    }
    keepStanding(clip, standing(flight), UpAxis::Y);
    for (NodeIndex f = 0; f < frames; ++f) {
        const bool flies = step - flight < f && f < step + flight;
        EXPECT_NEAR(clip.frame(f)[2].y(), 1 + (flies ? arc(f) : 0), 1e-5) << f;
    }
}

} // namespace
