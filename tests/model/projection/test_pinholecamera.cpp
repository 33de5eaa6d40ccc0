// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/projection/pinholecamera.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

using namespace quadrille;
using ::testing::HasSubstr;

namespace {

PinholeCamera plainCamera()
{
    return {.name = "plain", .width = 100, .height = 80, .fx = 100, .fy = 200, .cx = 50, .cy = 40};
}

double distanceTo(const std::optional<Vec2d>& found, const Vec2d& wanted)
{
    return found ? (*found - wanted).norm() : std::numeric_limits<double>::infinity();
}

} // namespace

TEST(PinholeCamera, ShowsPointsWhereTheyWereSolvedByHand)
{
    PinholeCamera camera = plainCamera();
    EXPECT_LT(distanceTo(CameraLens(camera).project({1, 2, 4}), {75, 140}), 1e-12);
    EXPECT_LT(distanceTo(CameraLens(camera).project({0, 0, 7}), {50, 40}), 1e-12);
    // It looks along the world's x, with z upwards.
    camera.rotation << 0, -1, 0, 0, 0, -1, 1, 0, 0;
    camera.translation = {0, 1, 2};
    EXPECT_FALSE(faultOf(camera));
    EXPECT_TRUE(camera.inCamera({2, 3, 5}).isApprox(Vec3d(-3, -4, 4)));
    EXPECT_LT(distanceTo(CameraLens(camera).project(camera.inCamera({2, 3, 5})), {-25, -160}), 1e-12);
    EXPECT_TRUE(camera.inCamera(camera.centre()).isZero(1e-12));
    EXPECT_TRUE(camera.centre().isApprox(Vec3d(-2, 0, 1)));
}

TEST(PinholeCamera, DistortsAsOpenCvDoes)
{
    PinholeCamera camera = plainCamera();
    camera.fx = camera.fy = 1;
    camera.cx = camera.cy = 0;
    // At (0.5, 0): r² = 0.25, so 0.5 · (1 + 0.025), then p2 · (0.25 + 0.5) and p1 · 0.25.
    camera.distortion = {0.1, 0, 0, 0, 0};
    EXPECT_LT(distanceTo(CameraLens(camera).pixelOf({0.5, 0}), {0.5125, 0}), 1e-12);
    camera.distortion = {0, 0.2, 0, 0, 0};
    EXPECT_LT(distanceTo(CameraLens(camera).pixelOf({0, 0.5}), {0, 0.50625}), 1e-12);
    camera.distortion = {0, 0, 0, 0, 0.4};
    EXPECT_LT(distanceTo(CameraLens(camera).pixelOf({0.5, 0}), {0.503125, 0}), 1e-12);
    camera.distortion = {0, 0, 0.01, 0.02, 0};
    EXPECT_LT(distanceTo(CameraLens(camera).pixelOf({0.5, 0}), {0.515, 0.0025}), 1e-12);
    EXPECT_LT(distanceTo(CameraLens(camera).pixelOf({0, 0.5}), {0.005, 0.5075}), 1e-12);
    EXPECT_LT(distanceTo(CameraLens(camera).pixelOf({0.5, 0.5}), {0.5 + 0.005 + 0.02, 0.5 + 0.01 + 0.01}),
              1e-12);
}

TEST(PinholeCamera, FindsWhatAPixelShows)
{
    PinholeCamera camera = plainCamera();
    camera.distortion = {-0.25, 0.08, 0.002, -0.003, 0.01};
    const CameraLens lens(camera);
    for (double x = -0.6; x <= 0.6; x += 0.1)
        for (double y = -0.6; y <= 0.6; y += 0.1)
            EXPECT_LT(distanceTo(lens.idealOf(*lens.pixelOf({x, y})), {x, y}), 1e-8) << x << " " << y;
}

TEST(PinholeCamera, ShowsNothingBehindItNorBeyondTheFoldOfItsLens)
{
    PinholeCamera camera = plainCamera();
    EXPECT_FALSE(CameraLens(camera).project({0, 0, 0}));
    EXPECT_FALSE(CameraLens(camera).project({1, 2, -4}));
    EXPECT_FALSE(CameraLens(camera).pixelOf({std::nan(""), 0}));
    EXPECT_TRUE(std::isinf(CameraLens(camera).limit()));
    camera.distortion = {-0.5, 0, 0, 0, 0}; // r − r³ / 2 grows to r² = 2/3
    const CameraLens lens(camera);
    EXPECT_NEAR(lens.limit(), std::sqrt(2.0 / 3), 1e-6);
    EXPECT_TRUE(lens.pixelOf({0.8, 0}));
    EXPECT_FALSE(lens.pixelOf({0.83, 0}));
    EXPECT_FALSE(lens.pixelOf({1.3, 0})); // shown at 0.2 else, where 0.21 is
    EXPECT_FALSE(lens.idealOf({50 + 100, 40}));
}

TEST(PinholeCamera, SaysWhatIsWrongWithIt)
{
    const auto fault = [](auto change) {
        PinholeCamera camera = plainCamera();
        change(camera);
        const auto found = faultOf(camera);
        return found ? found->reason : std::string();
    };
    using C = PinholeCamera;
    EXPECT_EQ(fault([](C&) {}), "");
    EXPECT_THAT(fault([](C& c) { c.width = 0; }), HasSubstr("0 × 80 pixels"));
    EXPECT_THAT(fault([](C& c) { c.fy = 0; }), HasSubstr("focal lengths"));
    EXPECT_THAT(fault([](C& c) { c.cx = std::nan(""); }), HasSubstr("finite"));
    EXPECT_THAT(fault([](C& c) { c.distortion[4] = INFINITY; }), HasSubstr("finite"));
    EXPECT_THAT(fault([](C& c) { c.rotation(0, 0) = 1.1; }), HasSubstr("length one"));
    EXPECT_THAT(fault([](C& c) { c.rotation(2, 2) = -1; }), HasSubstr("mirrors"));
    EXPECT_EQ(fault([](C& c) { c.rotation(0, 1) = 1e-4; }), ""); // written with few digits
}
