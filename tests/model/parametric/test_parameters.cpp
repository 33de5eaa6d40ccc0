// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/parametric/parameters.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace quadrille {
namespace {

/// A column of three vertices, 0, 1 and 2 m high, that is lifted.
struct Column
{
    std::vector<Vec3f> poses;
    std::vector<GroundMotion> steps;
    std::vector<double> seconds;

    void add(float lifted, const GroundMotion& step, double duration)
    {
        for (int v = 0; v < 3; ++v)
            poses.emplace_back(0, lifted + static_cast<float>(v), 0);
        steps.push_back(step);
        seconds.push_back(duration);
    }
    double measure(SpaceMeasure what, bool isCyclic, VertexIndex vertex = VertexIndex(0)) const
    {
        return measured({"it", what, vertex}, {poses, 3, steps, seconds, isCyclic, UpAxis::Y});
    }
};

} // namespace

TEST(SpaceParameters, MeasureSpeedAndTurning)
{
    Column walk;
    for (int f = 0; f < 10; ++f)
        walk.add(0, {0.1, {0.05, 0}}, 0.04);
    // Steps are chords of the circle.
    EXPECT_NEAR(walk.measure(SpaceMeasure::Speed, true), 1.25 * 0.05 / std::sin(0.05), 1e-9);
    EXPECT_NEAR(walk.measure(SpaceMeasure::Turning, true), 2.5 * 180 / std::numbers::pi, 1e-9);
    // What comes after the last frame of what is no cycle is not known.
    walk.seconds.back() = 100;
    EXPECT_NEAR(walk.measure(SpaceMeasure::Speed, false), 1.25 * 0.05 / std::sin(0.05), 1e-9);
}

TEST(SpaceParameters, DoNotCountHowABodySways)
{
    Column walk;
    for (int f = 0; f < 10; ++f)
        walk.add(0, {0, {0.05, f % 2 == 0 ? 0.03 : -0.03}}, 0.04);
    EXPECT_NEAR(walk.measure(SpaceMeasure::Speed, true), 1.25, 1e-12);
}

TEST(SpaceParameters, MeasureJumps)
{
    Column jump;
    for (const float lifted : {0.0F, 0.0F, 0.2F, 0.35F, 0.1F, 0.0F, 0.0F})
        jump.add(lifted, {0, {0, 0.3}}, 0.04);
    EXPECT_NEAR(jump.measure(SpaceMeasure::JumpHeight, false), 0.35, 1e-6);
    // From the second frame, from which it leaves, to the sixth.
    EXPECT_NEAR(jump.measure(SpaceMeasure::JumpLength, false), 4 * 0.3, 1e-12);
}

TEST(SpaceParameters, MeasureWhereAVertexReaches)
{
    Column reach;
    for (int f = 0; f < 3; ++f)
        reach.add(0, {}, 0.04);
    reach.poses[5] = {0.4F, 2.5F, 0.9F}; // the uppermost vertex in the second frame
    const Vec3d centre(0.4 / 3, 3.5 / 3, 0.3);
    EXPECT_NEAR(reach.measure(SpaceMeasure::Height, false, VertexIndex(2)), 2.5, 1e-6);
    EXPECT_NEAR(reach.measure(SpaceMeasure::Forward, false, VertexIndex(2)), 0.9 - centre.z(), 1e-6);
    EXPECT_NEAR(reach.measure(SpaceMeasure::Side, false, VertexIndex(2)), 0.4 - centre.x(), 1e-6);
}

TEST(ParameterMap, InvertsWhatBlendsMeasure)
{
    const WeightSpace space(std::vector<SpacePoint>{{1, 0, 0}, {4, 0, 0}}, 1);
    // Blends are slower than their place says.
    const auto speed = [](const SpacePoint& place) {
        const double u = (place[0] - 1) / 3;
        return SpacePoint{1 + 3 * (0.8 * u + 0.2 * u * u), 0, 0};
    };
    const ParameterMap map = fitParameterMap(space, {{"speed", SpaceMeasure::Speed, {}}}, speed);
    EXPECT_NEAR(map.least[0], 1, 1e-12);
    EXPECT_NEAR(map.greatest[0], 4, 1e-12);
    EXPECT_LT(map.worstResidual[0], 0.01);
    EXPECT_LE(map.meanResidual[0], map.worstResidual[0]);
    for (double wanted = 1; wanted <= 4; wanted += 0.25)
        EXPECT_NEAR(speed(space.placeOf(space.at(map.placeOf({wanted, 0, 0}))))[0], wanted, 0.01);
    EXPECT_EQ(map.placeOf({9, 0, 0}), map.placeOf({4, 0, 0})) << "limits are kept";
}

TEST(ParameterMap, InvertsTwoParametersThatMix)
{
    const WeightSpace space(std::vector<SpacePoint>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 2);
    const auto measure = [](const SpacePoint& p) {
        return SpacePoint{p[0] + 0.1 * p[1] * p[0], p[1] - 0.1 * p[0] * (1 - p[0]), 0};
    };
    const ParameterMap map = fitParameterMap(
        space, {{"speed", SpaceMeasure::Speed, {}}, {"turning", SpaceMeasure::Turning, {}}}, measure);
    EXPECT_LT(map.worstResidual[0], 0.03);
    EXPECT_LT(map.worstResidual[1], 0.03);
}

TEST(ParameterMap, SaysWhichParameterCannotBeSteeredBy)
{
    const WeightSpace space(std::vector<SpacePoint>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2);
    const auto measure = [](const SpacePoint& p) { return SpacePoint{p[0], std::abs(p[1] - 0.5), 0}; };
    try {
        fitParameterMap(space, {{"speed", SpaceMeasure::Speed, {}}, {"wobble", SpaceMeasure::Turning, {}}},
                        measure);
        ADD_FAILURE() << "it was taken";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("wobble"), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find("“speed”"), std::string::npos) << error.what();
    }
}

} // namespace quadrille
