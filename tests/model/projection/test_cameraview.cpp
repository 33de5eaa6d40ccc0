// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/projection/cameraview.h"
#include "tests/model/projection/photographs.h"
#include "tests/model/render/scenes.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A wall of 40 × 40 at z = 0, and a card of 8 × 8 before it; the camera stands 20 before the wall, where a
/// pixel is a tenth of the wall's unit.
class CardBeforeAWall : public ::testing::Test
{
protected:
    CardBeforeAWall()
    {
        const Vec3f a(-20, -20, 0);
        const Vec3f b(20, -20, 0);
        const Vec3f c(20, 20, 0);
        const Vec3f d(-20, 20, 0);
        scene.add(a, b, c);
        scene.add(a, c, d);
        const Vec3f lift(0, 0, 10);
        scene.add(a / 5 + lift, b / 5 + lift, c / 5 + lift);
        scene.add(a / 5 + lift, c / 5 + lift, d / 5 + lift);
        camera = pinholeOf(unitCamera(20), 400, 400);
    }

    std::optional<Sight> sightOf(const Vec3d& point, std::uint32_t triangle,
                                 const Vec3d& normal = Vec3d::UnitZ()) const
    {
        return CameraView(camera, scene.positions, scene.triangles)
            .sightOf({point, normal, TriangleIndex(triangle)});
    }
    std::optional<Sight> onWall(double x, double y) const { return sightOf({x, y, 0}, y < x ? 0 : 1); }

    Mesh scene;
    PinholeCamera camera;
};

} // namespace

TEST_F(CardBeforeAWall, HidesTheWallBehindIt)
{
    // Its shadow on the wall reaches to 8.
    for (const double x : {0.5, 4.0, 7.0, 7.9})
        EXPECT_FALSE(onWall(x, 0.1)) << x;
    for (const double x : {8.5, 9.0, 15.0}) {
        ASSERT_TRUE(onWall(x, 0.1)) << x;
        EXPECT_NEAR(onWall(x, 0.1)->pixel.x(), 199.5 + 10 * x, 1e-6);
        EXPECT_NEAR(onWall(x, 0.1)->pixel.y(), 199.5 - 1, 1e-6);
        EXPECT_NEAR(onWall(x, 0.1)->place.z(), 20, 1e-9);
    }
    EXPECT_TRUE(sightOf({1, 0, 10}, 2));
    EXPECT_DOUBLE_EQ(sightOf({1, 0, 10}, 2)->trust, 1);
}

TEST_F(CardBeforeAWall, KeepsAMarginAlongItsEdges)
{
    // Pixels at the edge show both; three further on the wall counts wholly. No step is larger than a slope
    // of a margin of three pixels, half again as steep in its middle, allows.
    double before = 0;
    for (double x = 7.5; x < 9; x += 0.01) {
        const auto sight = onWall(x, 0.3);
        const double trust = sight ? sight->trust : 0;
        EXPECT_NEAR(trust, before, 0.06) << x;
        EXPECT_GE(trust, before - 1e-9) << x;
        before = trust;
    }
    EXPECT_FALSE(onWall(8.05, 0.3));
    EXPECT_LT(onWall(8.3, 0.3)->trust, 0.9);
    EXPECT_DOUBLE_EQ(onWall(9, 0.3)->trust, 1);
    // The card itself has one, too: there is wall in its pixels.
    EXPECT_LT(sightOf({3.9, 0, 10}, 2)->trust, 0.5);
}

TEST_F(CardBeforeAWall, IsSeenLessAtAnAngle)
{
    const auto trust = [&](double cosine) {
        const auto sight = sightOf({1, 0, 10}, 2, Vec3d(std::sqrt(1 - cosine * cosine), 0, cosine));
        return sight ? sight->trust : 0;
    };
    EXPECT_EQ(trust(-0.5), 0);
    EXPECT_EQ(trust(0.15), 0); // seen a little from the side: the cosine is less
    EXPECT_GT(trust(0.3), 0);
    EXPECT_LT(trust(0.3), 1);
    EXPECT_EQ(trust(0.5), 1);
    const auto sight = sightOf({0, 0, 10}, 2, Vec3d(0.6, 0, 0.8));
    EXPECT_NEAR(sight->weight, std::pow(0.8, 4), 1e-12);
}

TEST_F(CardBeforeAWall, FadesAtTheBordersOfThePicture)
{
    double before = 1;
    for (double x = 19; x < 20.1; x += 0.01) {
        const auto sight = onWall(x, 0);
        const double trust = sight ? sight->trust : 0;
        EXPECT_LE(trust, before + 1e-9);
        EXPECT_NEAR(trust, before, 0.03);
        before = trust;
    }
    EXPECT_EQ(before, 0);
}

TEST_F(CardBeforeAWall, IsNotSeenFromBehindNorByCamerasThatLookAway)
{
    Camera behind = unitCamera(20);
    behind.eye.z() = -20;
    camera = pinholeOf(behind, 400, 400);
    EXPECT_FALSE(onWall(10, 0));
    EXPECT_FALSE(sightOf({10, 0, 0}, 0, -Vec3d::UnitZ())); // its triangle shows its back
    Camera away = unitCamera(20);
    away.target.z() = 40;
    camera = pinholeOf(away, 400, 400);
    EXPECT_FALSE(onWall(10, 0));
}

TEST_F(CardBeforeAWall, MayReachBehindTheCamera)
{
    // The camera stands between the card and the wall, and there is nothing before the wall any more.
    camera = pinholeOf(unitCamera(5), 400, 400);
    EXPECT_TRUE(onWall(0.5, 0.1));
    EXPECT_FALSE(sightOf({1, 0, 10}, 2));
    // In the wall itself, and with a floor that goes through the camera's place.
    camera.translation.setZero();
    EXPECT_FALSE(onWall(0, 0));
    scene.add({-9, -1, -9}, {9, -1, 9}, {9, -1, -9});
    camera = pinholeOf(unitCamera(5), 400, 400);
    EXPECT_TRUE(onWall(0.5, 0.1));
}

TEST_F(CardBeforeAWall, IsAsSeenThroughALens)
{
    // The picture ends before the wall does; where the lens draws things together it shows more than one of
    // this size would without it.
    camera.fx = camera.fy = 260;
    for (const double k1 : {-0.1, 0.2}) {
        camera.distortion = {k1, 0, 0.001, -0.001, 0};
        const CameraLens lens(camera);
        const CameraView view(camera, scene.positions, scene.triangles);
        int seen = 0;
        for (double x = -19.7; x < 20; x += 0.4) {
            for (double y = -19.7; y < 20; y += 0.4) {
                const auto pixel = lens.project(camera.inCamera({x, y, 0}));
                ASSERT_TRUE(pixel);
                const bool isInside = pixel->minCoeff() > 1 && pixel->maxCoeff() < 398;
                const double far = std::max(std::abs(x), std::abs(y));
                const auto sight = view.sightOf({{x, y, 0}, Vec3d::UnitZ(), TriangleIndex(y < x ? 0 : 1)});
                if (far < 7.9) {
                    EXPECT_FALSE(sight) << x << " " << y;
                }
                if (far > 8.4 && far < 19.5 && isInside) {
                    ASSERT_TRUE(sight) << x << " " << y;
                    EXPECT_LT((sight->pixel - *pixel).norm(), 1e-9);
                    ++seen;
                }
            }
        }
        EXPECT_GT(seen, 1000);
    }
}

TEST_F(CardBeforeAWall, IsNotSeenWhereNothingIsANumber)
{
    EXPECT_FALSE(sightOf({std::nan(""), 0, 0}, 0));
    EXPECT_FALSE(sightOf({10, 0, 0}, 0, Vec3d::Constant(std::nan(""))));
    EXPECT_FALSE(sightOf({10, 0, 0}, 0, Vec3d::Zero()));
}
