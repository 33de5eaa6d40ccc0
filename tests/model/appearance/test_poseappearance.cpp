// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/modeltextures.h"
#include "model/appearance/texturequality.h"
#include "tests/model/appearance/appearancefixture.h"
#include "tests/model/codeof.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr int armVertices = 30;

/// An arm that is bent in its middle.
std::vector<Vec3f> bentArm(double angle)
{
    std::vector<Vec3f> pose;
    for (int i = 0; i < armVertices; ++i) {
        const double along = 0.1 * (i - armVertices / 2);
        const Vec3d upper(along, 0.02 * (i % 3), 0.01 * (i % 2));
        const Vec3d bent = Eigen::AngleAxisd(angle, Vec3d::UnitZ()) * upper;
        pose.push_back((along < 0 ? upper : bent).cast<float>());
    }
    return pose;
}

std::vector<Vec3f> moved(std::vector<Vec3f> pose)
{
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3d(1, 2, -1).normalized()).toRotationMatrix();
    for (Vec3f& position : pose)
        position = (turn * position.cast<double>() + Vec3d(3, -1, 2)).cast<float>();
    return pose;
}

PosePlaces placesOf(const std::vector<std::vector<Vec3f>>& poses)
{
    return posePlaces(std::ssize(poses), static_cast<std::uint32_t>(poses.front().size()),
                      [&](std::int64_t i) { return Frame(poses[static_cast<std::size_t>(i)], nullptr); });
}

/// A model whose first coefficients follow an arm that bends: eight frames, 0 … 1.4 radians.
struct BendingLook
{
    BendingLook()
    {
        model = std::make_shared<const AppearanceModel>(modelOfWaves());
        std::vector<std::int64_t> rows;
        std::vector<std::vector<Vec3f>> poses;
        for (std::int64_t row = 0; row < std::ssize(model->frames); ++row) {
            rows.push_back(row);
            poses.push_back(moved(bentArm(angleOf(row))));
        }
        textures = coefficientRows(model->textures, rows);
        warps = coefficientRows(model->warps, rows);
        for (const std::int64_t row : rows)
            textures(row, 0) = 900 * std::sin(2 * angleOf(row));
        known.model = model;
        known.poses = std::make_shared<const PoseAppearance>(
            placesOf(poses), textures, warps, PoseScales{.textures = {0.4, 1e4}, .warps = {0.4, 10}});
    }
    static double angleOf(std::int64_t row) { return 0.2 * static_cast<double>(row); }

    std::shared_ptr<const AppearanceModel> model;
    Eigen::MatrixXd textures;
    Eigen::MatrixXd warps;
    FrameAppearances known;
};

ModelTextures texturesKnowing(FrameAppearances known)
{
    return ModelTextures([known = std::move(known)] { return std::optional(known); });
}

std::shared_ptr<const FrameSource> posesAt(const std::vector<double>& angles)
{
    std::vector<Vec3f> all;
    for (const double angle : angles) {
        const auto pose = bentArm(angle);
        all.insert(all.end(), pose.begin(), pose.end());
    }
    return std::make_shared<const MemoryFrames>(std::move(all), armVertices);
}

} // namespace

TEST(PoseAppearance, SeesPosesWhereverTheyStand)
{
    const PosePlaces places = placesOf({bentArm(0), bentArm(0.5), moved(bentArm(0.5)), moved(bentArm(1))});
    EXPECT_EQ(places.count(), 4);
    const Eigen::MatrixXd squared = squaredDistances(places);
    EXPECT_LT(squared(1, 2), 1e-9);
    EXPECT_GT(squared(0, 1), 1e-3);
    EXPECT_GT(squared(0, 3), 2 * squared(0, 1));
    EXPECT_EQ(squared, squared.transpose());
    EXPECT_LT((squaredDistances(places, moved(bentArm(0.5))) - squared.col(1)).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(PoseAppearance, ComparesPosesByMeanSquaresOfVerticesByHand)
{
    std::vector<Vec3f> small;
    std::vector<Vec3f> large;
    for (const float side : {-1.0F, 1.0F}) {
        for (const Vec3f& axis : {Vec3f(1, 0, 0), Vec3f(0, 2, 0), Vec3f(0, 0, 3)}) {
            small.emplace_back(side * axis);
            large.emplace_back(1.5F * side * axis);
        }
    }
    // No rigid motion lays them nearer: all are half as far again from the middle, and 1² + 2² + 3² = 14.
    const PosePlaces places = placesOf({small, large});
    EXPECT_NEAR(squaredDistances(places)(0, 1), 0.25 * 14 / 3, 1e-5);
    EXPECT_NEAR(squaredDistances(places, moved(large))[0], 0.25 * 14 / 3, 1e-5);
}

TEST(PoseAppearance, TakesTheCoefficientsOfTheSamplesThatAreNamed)
{
    const AppearanceModel model = modelOfWaves();
    const Eigen::MatrixXd rows = coefficientRows(model.textures, std::vector<std::int64_t>{5, 2});
    ASSERT_EQ(rows.rows(), 2);
    ASSERT_EQ(rows.cols(), model.textures.count);
    for (Eigen::Index c = 0; c < rows.cols(); ++c) {
        const auto component = static_cast<std::size_t>(c);
        const auto count = static_cast<std::size_t>(rows.cols());
        EXPECT_EQ(rows(0, c), model.textures.coefficients[5 * count + component]);
        EXPECT_EQ(rows(1, c), model.textures.coefficients[2 * count + component]);
    }
}

TEST(PoseAppearance, ComparesSomeVerticesOfManyEvenlySpread)
{
    const std::vector<Vec3f> many(9001, Vec3f::UnitX());
    const PosePlaces places = placesOf({many});
    ASSERT_EQ(places.vertices.size(), 1000U);
    EXPECT_EQ(places.vertices.front(), 0U);
    EXPECT_GT(places.vertices.back(), 8980U);
    EXPECT_TRUE(std::ranges::is_sorted(places.vertices, std::less_equal<>()));
    EXPECT_EQ(placesOf({bentArm(0)}).vertices.size(), static_cast<std::size_t>(armVertices));
}

TEST(PoseAppearance, HasCoefficientsOfPosesBetweenThoseThatWereCaptured)
{
    const BendingLook look;
    for (double angle = 0.1; angle < 1.4; angle += 0.1)
        EXPECT_NEAR(look.known.poses->at(bentArm(angle)).textures[0], 900 * std::sin(2 * angle), 20) << angle;
    // Nothing is known of poses that are unlike all others.
    std::vector<Vec3f> strange = bentArm(0);
    for (std::size_t i = 0; i < strange.size(); i += 2)
        strange[i] *= 20;
    EXPECT_NEAR(look.known.poses->at(strange).textures[0], look.textures.col(0).mean(), 0.1);
    EXPECT_TRUE(look.known.poses->fits(armVertices));
    EXPECT_FALSE(look.known.poses->fits(armVertices - 1));
}

TEST(PoseAppearance, RegressesTexturesAndWarpsByTheirOwnScales)
{
    const BendingLook look;
    const PosePlaces places = placesOf({bentArm(0), bentArm(0.7), bentArm(1.4)});
    const RegressionScale trusted{.length = 0.1, .trust = 1e6};
    const Eigen::MatrixXd textures = look.textures.topRows(3);
    const Eigen::MatrixXd warps = look.warps.topRows(3);
    const double ofTexture = textures(2, 0);
    const double ofWarp = warps(2, 0);
    const double tolerance = 1e-3 * std::max(textures.cwiseAbs().maxCoeff(), warps.cwiseAbs().maxCoeff());
    const AppearanceCoefficients first =
        PoseAppearance(places, textures, warps, {.textures = trusted, .warps = {}}).at(bentArm(1.4));
    EXPECT_NEAR(first.textures[0], ofTexture, tolerance);
    EXPECT_NEAR(first.warps[0], warps.col(0).mean(), 1e-3);
    const AppearanceCoefficients second =
        PoseAppearance(places, textures, warps, {.textures = {}, .warps = trusted}).at(bentArm(1.4));
    EXPECT_NEAR(second.textures[0], textures.col(0).mean(), tolerance);
    EXPECT_NEAR(second.warps[0], ofWarp, 1e-3);
    EXPECT_GT(std::abs(ofWarp - warps.col(0).mean()), 0.01) << "else they were the same";
}

TEST(PoseAppearance, ChangesTexturesAsPosesDoWhereThoseOfTheNearestFrameJump)
{
    const BendingLook look;
    const ModelTextures textures = texturesKnowing(look.known);
    std::vector<double> angles;
    for (int i = 0; i <= 40; ++i)
        angles.push_back(0.6 + 0.01 * i);
    const auto poses = posesAt(angles);
    const AppearanceDecoder decoder(look.model);
    double largest = 0;
    double largestOfNearest = 0;
    std::shared_ptr<const Image> before;
    std::int64_t nearestBefore = 3;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const auto now = textures.ofPose(poses, FrameIndex(i), 1, {}).load();
        const auto nearest = static_cast<std::int64_t>(std::lround(angles[i] / 0.2));
        const auto difference = [&](const Image& first, const Image& second) {
            return textureQuality(first, second, look.model->texels).meanSquaredError;
        };
        const auto captured = [&](std::int64_t row) {
            const Eigen::VectorXf ofTextures = look.textures.row(row).cast<float>();
            const Eigen::VectorXf ofWarps = look.warps.row(row).cast<float>();
            return decoder.decode({{ofTextures.begin(), ofTextures.end()}, {ofWarps.begin(), ofWarps.end()}});
        };
        if (before) {
            largest = std::max(largest, difference(*before, *now));
            largestOfNearest =
                std::max(largestOfNearest, difference(captured(nearestBefore), captured(nearest)));
            EXPECT_NE(*before, *now) << "each pose has a texture of its own";
        }
        before = now;
        nearestBefore = nearest;
    }
    EXPECT_LT(largest, 0.05 * largestOfNearest);
}

TEST(PoseAppearance, MixesTexturesOfPosesWithCapturedOnes)
{
    const BendingLook look;
    const ModelTextures textures = texturesKnowing(look.known);
    const auto poses = posesAt({0.3, 0.9});
    const Image whole = *textures.ofPose(poses, FrameIndex(1), 1, {}).load();
    const Texture captured{.embedded = std::make_shared<const Image>(whole.width, whole.height)};
    EXPECT_EQ(*textures.ofPose(poses, FrameIndex(1), 0.25, captured).load(),
              mixedTexture(*captured.embedded, whole, 0.25));
    EXPECT_EQ(*textures.ofPose(poses, FrameIndex(1), 0.25, {}).load(), whole);
    const Texture other{.embedded = std::make_shared<const Image>(3, 3)};
    EXPECT_EQ(*textures.ofPose(poses, FrameIndex(1), 0.25, other).load(), whole);
    EXPECT_NE(*textures.ofPose(poses, FrameIndex(0), 1, {}).load(), whole);
}

TEST(PoseAppearance, KnowsNothingWithoutPosesAndOfOtherMeshes)
{
    const BendingLook look;
    const auto poses = posesAt({0.3});
    FrameAppearances without = look.known;
    without.poses = nullptr;
    EXPECT_TRUE(texturesKnowing(without).ofPose(poses, FrameIndex(0), 1, {}).isEmpty());
    const auto fewer =
        std::make_shared<const MemoryFrames>(std::vector<Vec3f>(armVertices - 1), armVertices - 1);
    EXPECT_TRUE(texturesKnowing(look.known).ofPose(fewer, FrameIndex(0), 1, {}).isEmpty());
    const ModelTextures none([] { return std::optional<FrameAppearances>(); });
    EXPECT_TRUE(none.ofPose(poses, FrameIndex(0), 1, {}).isEmpty());
}

TEST(PoseAppearance, OfOneFrameIsThatFrames)
{
    const BendingLook look;
    const PoseAppearance one(placesOf({bentArm(0.2)}), look.textures.topRows(1), look.warps.topRows(1), {});
    EXPECT_EQ(one.at(bentArm(1)).textures[0], static_cast<float>(look.textures(0, 0)));
}

TEST(PoseAppearance, CanBeCancelledWhilePosesAreRead)
{
    CancelToken token;
    int read = 0;
    const auto pose = bentArm(0);
    EXPECT_EQ(codeOf([&] {
                  posePlaces(
                      5, armVertices,
                      [&](std::int64_t) {
                          if (++read == 2)
                              token.cancel();
                          return Frame(pose, nullptr);
                      },
                      Progress(token));
              }),
              ErrorCode::Cancelled);
    EXPECT_EQ(read, 2);
}
