// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/standing.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace quadrille;

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

std::vector<Support> standing()
{
    std::vector<Support> supports;
    for (NodeIndex f = 0; f < frames; ++f) {
        Support& support = supports.emplace_back();
        if (f <= step)
            support.vertices.push_back(0);
        if (f >= step)
            support.vertices.push_back(1);
    }
    return supports;
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
    keepStanding(clip, std::vector<Support>(static_cast<std::size_t>(frames)), UpAxis::Y);
    EXPECT_EQ(clip.positions, before);
}

} // namespace
