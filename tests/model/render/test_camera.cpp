// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/camera.h"
#include "model/render/tiles.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace quadrille;

namespace {

/// Where a point is seen, as fractions of the picture from its upper left corner.
Vec2d seenAt(const Camera& camera, double aspect, const Vec3d& point)
{
    const Projection p(camera, static_cast<int>(1000 * aspect), 1000);
    const Vec3d offset = point - p.eye;
    const double depth = p.forward.dot(offset);
    EXPECT_GT(depth, camera.nearDistance);
    EXPECT_LT(depth, camera.farDistance);
    return {(p.centerX + p.focal * p.right.dot(offset) / depth) / (1000 * aspect),
            (p.centerY - p.focal * p.up.dot(offset) / depth) / 1000};
}

Bounds cornersSeen(const Camera& camera, double aspect, const Bounds& box)
{
    Bounds seen;
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3d corner((i & 1U) != 0 ? box.max.x() : box.min.x(),
                           (i & 2U) != 0 ? box.max.y() : box.min.y(),
                           (i & 4U) != 0 ? box.max.z() : box.min.z());
        const Vec2d at = seenAt(camera, aspect, corner);
        seen.add(Vec3d(at.x(), at.y(), 0));
    }
    return seen;
}

Bounds box(const Vec3d& min, const Vec3d& max)
{
    return {min, max};
}

} // namespace

TEST(Camera, SineAndCosineAgreeWithTheLibrary)
{
    for (int i = -2000; i <= 2000; ++i) {
        const double turns = i / 700.0;
        const auto [sine, cosine] = sineCosine(turns);
        EXPECT_NEAR(sine, std::sin(turns * 2 * std::numbers::pi), 4e-15) << turns;
        EXPECT_NEAR(cosine, std::cos(turns * 2 * std::numbers::pi), 4e-15) << turns;
    }
    EXPECT_EQ(sineCosine(0.25).sine, 1);
    EXPECT_EQ(sineCosine(0.5).cosine, -1);
}

TEST(Camera, FramesABoxTightlyAndCentred)
{
    const Bounds scene = box({-1, 0, -0.5}, {3, 1.8, 0.5});
    for (const double aspect : {0.5, 1.0, 2.0}) {
        for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
            const Framing framing{.up = up, .aspect = aspect, .margin = 0.05};
            const Bounds seen = cornersSeen(frameAll(scene, framing), aspect, scene);
            // One direction fills the picture but for the margin; the other is centred.
            EXPECT_NEAR(seen.center().x(), 0.5, 1e-3);
            EXPECT_NEAR(seen.center().y(), 0.5, 1e-3);
            EXPECT_NEAR(std::max(seen.size().x(), seen.size().y()), 0.9, 1e-9);
        }
    }
}

TEST(Camera, FramesASinglePoint)
{
    const Camera camera = frameAll(box({1, 2, 3}, {1, 2, 3}), {});
    EXPECT_TRUE(camera.eye.allFinite());
    EXPECT_GT((camera.eye - camera.target).norm(), 0);
    EXPECT_LT(camera.nearDistance, camera.farDistance);
}

TEST(Camera, TurntableSeesTheBoxFromEverySide)
{
    for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        const Bounds scene = box({-1, 0, -0.5}, {1.5, 2, 0.5});
        const Camera camera = frameTurntable(scene, {.up = up, .aspect = 1.5});
        for (int i = 0; i < 24; ++i) {
            const Bounds seen = cornersSeen(turned(camera, up, i / 24.0), 1.5, scene);
            EXPECT_GE(seen.min.minCoeff(), 0);
            EXPECT_LE(seen.max.x(), 1);
            EXPECT_LE(seen.max.y(), 1);
        }
    }
}

TEST(Camera, TurnsAboutTheVerticalThroughItsTarget)
{
    Camera camera;
    camera.eye = {1, 2, 5};
    camera.target = {1, 1, 1};
    const Camera quarter = turned(camera, UpAxis::Y, 0.25);
    EXPECT_TRUE(quarter.eye.isApprox(Vec3d(5, 2, 1), 1e-12));
    EXPECT_EQ(quarter.target, camera.target);
    EXPECT_TRUE(turned(quarter, UpAxis::Y, 0.75).eye.isApprox(camera.eye, 1e-12));
}

TEST(Camera, LooksStraightDownWithoutTumbling)
{
    Camera camera;
    camera.eye = {0, 5, 0};
    camera.target = {0, 0, 0};
    const Projection projection(camera, 100, 100);
    EXPECT_TRUE(projection.right.allFinite());
    EXPECT_NEAR(projection.right.norm(), 1, 1e-12);
    EXPECT_NEAR(projection.right.dot(projection.forward), 0, 1e-12);
}
