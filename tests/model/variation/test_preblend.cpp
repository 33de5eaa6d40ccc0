// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/poseinterpolation.h"
#include "model/variation/alignment.h"
#include "model/variation/playback.h"
#include "model/variation/preblend.h"
#include "tests/model/codeof.h"
#include "tests/model/largestdistance.h"
#include "tests/model/variation/swayingtakes.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::strideAt;
using test::swayingTake;

/// Two takes of different length that face different ways; the second goes faster.
Alignment twoTakes(const std::vector<VertexIndex>& anchor = {})
{
    const auto reach = [](double t) { return 2.5 * std::sin(std::numbers::pi * t); };
    const auto behind = [](int f) {
        const RigidMotion place = strideAt(2 * f);
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.5, Vec3d::UnitY()));
        return RigidMotion{turn * place.rotation, turn * place.translation + Vec3d(0, 0.1, 3)};
    };
    const std::vector<TrainingTake> takes = {
        {swayingTake(
             "a", 20, [&](int f) { return reach(f / 19.0); }, strideAt),
         {}},
        {swayingTake(
             "b", 30, [&](int f) { return reach(f / 29.0); }, behind, 1.3),
         {}}};
    return alignTakes(takes, 0, {.anchor = anchor});
}

TEST(PreBlend, AtItsEndsIsTheTakes)
{
    const Alignment alignment = twoTakes();
    const auto system = std::make_shared<PoissonSystem>(test::swayingTopology());
    for (const double weight : {0.0, 1e-9, 1 - 1e-9, 1.0}) {
        const AlignedTake blend =
            blendedTake(system, alignment.takes[0], alignment.takes[1], weight, "blend");
        const AlignedTake& take = alignment.takes[weight < 0.5 ? 0 : 1];
        EXPECT_EQ(blend.name, "blend");
        EXPECT_EQ(blend.warp.frames.count(), take.warp.frames.count());
        EXPECT_LT(test::largestDistance(blend.poses, take.poses), 2e-5);
        for (std::size_t f = 0; f < take.placements.size(); ++f) {
            EXPECT_LT((blend.placements[f].translation - take.placements[f].translation).norm(), 1e-6);
            EXPECT_LT(blend.placements[f].rotation.angularDistance(take.placements[f].rotation), 1e-6);
        }
        for (std::size_t k = 0; k < take.warp.playback.size(); ++k)
            EXPECT_NEAR(blend.warp.playback[k], take.warp.playback[k], 1e-5);
    }
}

TEST(PreBlend, InterpolatesPosesNonLinearlyFrameByFrame)
{
    const Alignment alignment = twoTakes();
    const auto system = std::make_shared<PoissonSystem>(test::swayingTopology());
    const AlignedTake blend = blendedTake(system, alignment.takes[0], alignment.takes[1], 0.3, "blend");
    EXPECT_EQ(blend.warp.frames.count(), 23);
    for (const std::size_t f : {0U, 7U, 19U}) {
        std::vector<Vec3f> expected = interpolatePoses(test::swayingTopology(), alignment.takes[0].pose(f),
                                                       alignment.takes[1].pose(f), 0.3);
        const RigidMotion onto = rigidProcrustes(expected, alignment.templatePose);
        for (Vec3f& p : expected)
            p = onto(p.cast<double>()).cast<float>();
        EXPECT_LT(test::largestDistance(blend.pose(f), expected), 1e-6);
    }
}

TEST(PreBlend, OfFourTakesIsThatOfTwoWhereTheOthersHaveNoShare)
{
    const Alignment alignment = twoTakes();
    const auto system = std::make_shared<PoissonSystem>(test::swayingTopology());
    const AlignedTake& a = alignment.takes[0];
    const AlignedTake& b = alignment.takes[1];
    const std::vector<TakeShare> edge{{&b, 0}, {&a, 0.75}, {&a, 0}, {&b, 0.25}};
    const AlignedTake blend = blendedTake(system, edge, "edge");
    const AlignedTake pair = blendedTake(system, a, b, 0.25, "edge");
    EXPECT_EQ(blend.poses, pair.poses);
    EXPECT_EQ(blend.warp, pair.warp);
    for (std::size_t f = 0; f < pair.placements.size(); ++f)
        EXPECT_EQ(blend.placements[f].translation, pair.placements[f].translation);
}

TEST(PreBlend, OfFourTakesThatAreTwoIsTheBlendOfThem)
{
    const Alignment alignment = twoTakes();
    const auto system = std::make_shared<PoissonSystem>(test::swayingTopology());
    const AlignedTake& a = alignment.takes[0];
    const AlignedTake& b = alignment.takes[1];
    // Both pairs are the same, so where between them does not matter.
    const std::vector<TakeShare> four{{&a, 0.28}, {&b, 0.12}, {&a, 0.42}, {&b, 0.18}};
    const AlignedTake blend = blendedTake(system, four, "four");
    const AlignedTake pair = blendedTake(system, a, b, 0.3, "two");
    EXPECT_LT(test::largestDistance(blend.poses, pair.poses), 1e-4);
    for (std::size_t f = 0; f < pair.placements.size(); ++f) {
        EXPECT_LT((blend.placements[f].translation - pair.placements[f].translation).norm(), 1e-9);
        EXPECT_LT(blend.placements[f].rotation.angularDistance(pair.placements[f].rotation), 1e-9);
    }
}

TEST(PreBlend, RefusesSharesThatAreNoBlend)
{
    const Alignment alignment = twoTakes();
    const auto system = std::make_shared<PoissonSystem>(test::swayingTopology());
    const AlignedTake& a = alignment.takes[0];
    const AlignedTake& b = alignment.takes[1];
    for (const auto& [first, second] :
         std::vector<std::pair<double, double>>{{0.5, 0.6}, {0, 0}, {1.5, -0.5}})
        EXPECT_EQ(test::codeOf([&, x = first, y = second] {
                      blendedTake(system, std::array{TakeShare{&a, x}, TakeShare{&b, y}}, "x");
                  }),
                  ErrorCode::BadArgument);
}

TEST(PreBlend, LiesOnTheTemplateByItsAnchor)
{
    std::vector<VertexIndex> anchor;
    for (unsigned v = 0; v < 24; ++v)
        anchor.emplace_back(v);
    const Alignment alignment = twoTakes(anchor);
    const auto system = std::make_shared<PoissonSystem>(test::swayingTopology());
    const AlignedTake blend = blendedTake(system, alignment.takes[0], alignment.takes[1], 0.5, "blend");
    for (std::size_t f = 0; f < blend.placements.size(); ++f) {
        const RigidMotion rest = alignment.takes[0].laidOnto->onto(blend.pose(f));
        EXPECT_LT(rest.translation.norm(), 1e-5);
        EXPECT_LT(rest.rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-4);
    }
}

TEST(PreBlend, GoesAheadBetweenItsTakesAndKeepsUpright)
{
    const Alignment alignment = twoTakes();
    const AlignedTake& a = alignment.takes[0];
    const AlignedTake& b = alignment.takes[1];
    const std::vector<RigidMotion> half =
        blendedPlacements(std::array{TakeShare{&a, 0.5}, TakeShare{&b, 0.5}}, UpAxis::Y);
    const auto way = [](const std::vector<RigidMotion>& placements) {
        double length = 0;
        for (std::size_t f = 1; f < placements.size(); ++f) {
            Vec3d step = placements[f].translation - placements[f - 1].translation;
            step.y() = 0;
            length += step.norm();
        }
        return length;
    };
    // Steps that point apart, seen from the body, are a little shorter on average.
    EXPECT_NEAR(way(half), (way(a.placements) + way(b.placements)) / 2, 0.05 * way(half));
    for (std::size_t f = 0; f < half.size(); ++f) {
        EXPECT_NEAR(half[f].translation.y(),
                    (a.placements[f].translation.y() + b.placements[f].translation.y()) / 2, 1e-9);
        const Vec3d up =
            upSeenFrom(a.placements[f], Vec3d::UnitY()) + upSeenFrom(b.placements[f], Vec3d::UnitY());
        EXPECT_LT((upSeenFrom(half[f], Vec3d::UnitY()) - up.normalized()).norm(), 1e-6);
    }
}

TEST(PreBlend, RefusesBadWeightsAndOtherMeshesAndCanBeCancelled)
{
    const Alignment alignment = twoTakes();
    const auto system = std::make_shared<PoissonSystem>(test::swayingTopology());
    const auto blend = [&](const std::shared_ptr<const PoissonSystem>& of, double weight,
                           const Progress& progress = {}) {
        return test::codeOf(
            [&] { blendedTake(of, alignment.takes[0], alignment.takes[1], weight, "x", {}, progress); });
    };
    EXPECT_EQ(blend(system, -0.1), ErrorCode::BadArgument);
    EXPECT_EQ(blend(system, 1.1), ErrorCode::BadArgument);
    EXPECT_EQ(blend(system, std::nan("")), ErrorCode::BadArgument);
    EXPECT_EQ(blend(std::make_shared<PoissonSystem>(test::tubeTopology(5, 4)), 0.5),
              ErrorCode::VertexCountMismatch);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(blend(system, 0.5, Progress(token)), ErrorCode::Cancelled);
}

} // namespace
} // namespace quadrille
