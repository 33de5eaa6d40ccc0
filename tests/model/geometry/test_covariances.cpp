// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/geometry/covariances.h"
#include "model/geometry/procrustes.h"

#include <gtest/gtest.h>
#include <random>

using namespace quadrille;

namespace {

/// A long body far from the origin, each pose a little different from the one before.
std::vector<std::vector<Vec3f>> poses(std::size_t count, std::size_t vertices)
{
    std::mt19937 engine(11);
    std::normal_distribution<float> normal;
    std::vector<std::vector<Vec3f>> result(1);
    for (std::size_t v = 0; v < vertices; ++v)
        result[0].push_back(
            Vec3f(20 + 0.1F * normal(engine), 0.2F * normal(engine), 0.9F + 0.4F * normal(engine)));
    while (result.size() < count) {
        std::vector<Vec3f> next = result.back();
        const Eigen::AngleAxisf turn(0.02F, Vec3f(0.2F, 0.1F, 0.9F).normalized());
        for (Vec3f& p : next)
            p = turn * p + 0.003F * Vec3f(normal(engine), normal(engine), normal(engine));
        result.push_back(next);
    }
    return result;
}

std::vector<CentredPose> centred(const std::vector<std::vector<Vec3f>>& all)
{
    std::vector<CentredPose> result;
    for (const std::vector<Vec3f>& positions : all)
        result.push_back({positions, centroid(positions)});
    return result;
}

Eigen::Matrix3d plain(const CentredPose& target, const CentredPose& source)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t v = 0; v < target.positions.size(); ++v)
        sum += (target.positions[v].cast<double>() - target.centre) *
               (source.positions[v].cast<double>() - source.centre).transpose();
    return sum;
}

} // namespace

TEST(Covariances, AgreeWithSumsInDoublePrecision)
{
    // Counts that fill no tile and no panel.
    const auto all = poses(13, 1301);
    const std::vector<CentredPose> targets = centred(all);
    const std::span<const CentredPose> sources = std::span(targets).subspan(2, 7);
    const Eigen::MatrixXd found = covariances(targets, sources);
    ASSERT_EQ(found.rows(), 39);
    ASSERT_EQ(found.cols(), 21);
    double worst = 0;
    for (std::size_t t = 0; t < targets.size(); ++t) {
        for (std::size_t s = 0; s < sources.size(); ++s) {
            const Eigen::Matrix3d block =
                found.block<3, 3>(static_cast<Eigen::Index>(3 * t), static_cast<Eigen::Index>(3 * s));
            const Eigen::Matrix3d expected = plain(targets[t], sources[s]);
            EXPECT_LT((block - expected).norm(), 3e-7 * expected.norm()) << t << ", " << s;
            worst =
                std::max(worst, rotationOfCovariance(block).angularDistance(rotationOfCovariance(expected)));
        }
    }
    // Rounding averages out over the vertices: a tenth of what 1e-5 of the distance of neighbouring frames
    // (some 0.01 radians) allows.
    EXPECT_LT(worst, 1e-8);
}

TEST(Covariances, AreExactlySymmetricForEqualPoses)
{
    auto all = poses(1, 300);
    all.push_back(all[0]);
    const std::vector<CentredPose> pair = centred(all);
    const Eigen::Matrix3d block = covariances(pair, pair).block<3, 3>(0, 3);
    EXPECT_EQ(block, block.transpose());
}

TEST(Covariances, OfNothingAreEmpty)
{
    EXPECT_EQ(covariances({}, {}).size(), 0);
}

TEST(Covariances, CanBeCancelled)
{
    CancelToken token;
    token.cancel();
    const std::vector<std::vector<Vec3f>> all = poses(2, 10);
    EXPECT_THROW(covariances(centred(all), centred(all), Progress(token)), Error);
}
