// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/appearance.h"
#include "model/sample/groundtruth.h"
#include "sampletest.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <sstream>

namespace quadrille {
namespace {

TEST(SampleGroundTruth, weightsAddUpToOne)
{
    const SampleCharacter& character = smallSample();
    ASSERT_EQ(character.weights.size(), character.body.rest.size());
    for (const VertexWeights& w : character.weights) {
        float sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_GE(w.weights[k], 0.0F);
            EXPECT_LT(w.joints[k], character.skeleton.size());
            sum += w.weights[k];
        }
        EXPECT_NEAR(sum, 1.0F, 1e-5F);
    }
}

TEST(SampleGroundTruth, skinningTheRestPoseGivesTheRestPose)
{
    const SampleCharacter& character = smallSample();
    SkeletonPose pose;
    pose.root = character.skeleton.rest[0];
    pose.rotations.assign(character.skeleton.size(), Eigen::Quaterniond::Identity());
    std::vector<Vec3d> rest;
    for (const Vec3f& p : character.body.rest)
        rest.push_back(p.cast<double>());
    std::vector<Vec3d> moved;
    skin(rest, character.weights, character.skeleton, worldJoints(character.skeleton, pose), moved);
    for (std::size_t v = 0; v < rest.size(); ++v)
        EXPECT_LT((moved[v] - rest[v]).norm(), 1e-9);
}

TEST(SampleGroundTruth, bvhAnglesRebuildTheJoints)
{
    const SampleCharacter& character = smallSample();
    const SampleTake& take = character.takes.front();
    std::istringstream text(toBvh(character.skeleton, take.poses, take.sequence.fps));
    std::vector<std::size_t> order;
    std::string word;
    while (text >> word && word != "MOTION")
        if (word == "ROOT" || word == "JOINT") {
            text >> word;
            order.push_back(character.skeleton.index(word));
        }
    EXPECT_EQ(order.size(), character.skeleton.size());
    std::size_t frames = 0;
    double step = 0;
    text >> word >> frames >> word >> word >> step;
    EXPECT_EQ(frames, take.poses.size());
    EXPECT_NEAR(step, 0.04, 1e-9);
    for (std::size_t f = 0; f < frames; ++f) {
        SkeletonPose pose;
        pose.rotations.resize(character.skeleton.size());
        text >> pose.root.x() >> pose.root.y() >> pose.root.z();
        for (const std::size_t joint : order) {
            double z = 0;
            double x = 0;
            double y = 0;
            text >> z >> x >> y;
            constexpr double radians = 3.14159265358979323846 / 180;
            pose.rotations[joint] = Eigen::AngleAxisd(z * radians, Vec3d::UnitZ()) *
                                    Eigen::AngleAxisd(x * radians, Vec3d::UnitX()) *
                                    Eigen::AngleAxisd(y * radians, Vec3d::UnitY());
        }
        const WorldJoints expected = worldJoints(character.skeleton, take.poses[f]);
        const WorldJoints found = worldJoints(character.skeleton, pose);
        for (std::size_t j = 0; j < character.skeleton.size(); ++j)
            EXPECT_LT((expected.positions[j] - found.positions[j]).norm(), 1e-5); // five digits of a degree
    }
}

TEST(SampleGroundTruth, landmarksLieAtTheSamePlacesOfBothBodies)
{
    const SampleCharacter& character = smallSample();
    EXPECT_GE(character.landmarks.size(), 40U);
    const auto place = [](const SampleBody& body, const SurfacePoint& point) {
        Vec3d p = Vec3d::Zero();
        for (std::size_t c = 0; c < 3; ++c)
            p += point.weights[static_cast<Eigen::Index>(c)] *
                 body.rest[body.topology->triangles()[point.triangle.value][c].value].cast<double>();
        return p;
    };
    const auto top = [](const SampleBody& body) {
        float y = 0;
        for (const Vec3f& p : body.rest)
            y = std::max(y, p.y());
        return static_cast<double>(y);
    };
    for (const LandmarkPair& pair : character.landmarks) {
        EXPECT_NEAR(pair.source.weights.sum(), 1.0, 1e-9) << pair.name;
        EXPECT_GE(pair.source.weights.minCoeff(), 0.0) << pair.name;
        const Vec3d a = place(character.body, pair.source) / top(character.body);
        const Vec3d b = place(character.target, pair.target) / top(character.target);
        // The bodies are proportioned differently, but nothing changes sides or is a hand's breadth off.
        EXPECT_LT((a - b).norm(), 0.12) << pair.name;
        EXPECT_GE(a.x() * b.x(), -1e-5) << pair.name; // those in the middle may lie a little beside it
    }
}

TEST(SampleGroundTruth, warpsAreSmallAndSmooth)
{
    int takes = 0;
    for (const SampleTake& take : smallSample().takes) {
        if (!take.appearance)
            continue;
        ++takes;
        const SampleAppearance appearance = makeAppearance(take.sequence.frameCount(), 512, 5);
        ASSERT_EQ(static_cast<std::int64_t>(appearance.warps.size()), take.sequence.frameCount());
        float most = 0;
        for (std::size_t f = 0; f < appearance.warps.size(); ++f)
            for (double u = 0; u < 0.99; u += 0.05) {
                const Vec2f here = appearance.warps[f].at(u, 0.4);
                most = std::max(most, here.norm());
                EXPECT_LT((appearance.warps[f].at(u + 1.0 / 512, 0.4) - here).norm(),
                          0.06F); // texels a texel
                const Vec2f before = appearance.warps[f == 0 ? 0 : f - 1].at(u, 0.4);
                EXPECT_LT((before - here).norm(), 0.5F);
            }
        EXPECT_GT(most, 0.3F);
        EXPECT_LT(most, 3.0F);
    }
    EXPECT_EQ(takes, 3);
}

TEST(SampleGroundTruth, bodiesForTexturesOfTheirOwnSizeStayAsTheyAre)
{
    const SampleBody& body = smallSample().body;
    EXPECT_EQ(*forTexturesOf(body.texture->width, body).texture, *body.texture);
}

TEST(SampleGroundTruth, bodiesForSmallerTexturesShowNothingFinerThanTheirTexels)
{
    constexpr int side = 32;
    Image fine(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            std::fill_n(fine.pixel(x, y), 4,
                        static_cast<std::uint8_t>(x < side / 2 ? 40 + 160 * (x % 2) : 90));
    SampleBody body = smallSample().body;
    body.texture = std::make_shared<const Image>(fine);
    const Image coarse = *forTexturesOf(side / 2, body).texture;
    EXPECT_EQ(coarse.width, side);
    for (int x = 1; x < side / 2 - 1; ++x)
        EXPECT_EQ(coarse.pixel(x, 5)[1], 120) << "stripes of one texel become their mean";
    for (int x = side / 2 + 1; x < side; ++x)
        EXPECT_EQ(coarse.pixel(x, 5)[1], 90) << "what is even stays";
}

TEST(SampleGroundTruth, frameTexturesFollowWarpAndLight)
{
    const SampleCharacter& character = smallSample();
    const TexelMap texels = mapTexels(character.body.topology->data(), 128, 1);
    SampleAppearance plain;
    plain.textureSize = 128;
    plain.lights.push_back({Vec3d::UnitY(), Vec3d::Zero(), Vec3d::Ones()});
    plain.warps.push_back({std::vector<Vec2f>(SampleWarp::nodes * SampleWarp::nodes, Vec2f::Zero())});
    const Image same = frameTexture(character.body, texels, character.body.rest, plain, FrameIndex(0));
    plain.warps[0].offsets.assign(SampleWarp::nodes * SampleWarp::nodes, Vec2f(2, 1));
    const Image shifted = frameTexture(character.body, texels, character.body.rest, plain, FrameIndex(0));
    plain.lights[0].ambient = Vec3d(0.5, 0.5, 0.5);
    const Image dark = frameTexture(character.body, texels, character.body.rest, plain, FrameIndex(0));
    int checked = 0;
    for (int y = 4; y < 124; ++y)
        for (int x = 4; x < 124; ++x) {
            if (!texels.isInside[static_cast<std::size_t>(y * 128 + x)])
                continue;
            ++checked;
            EXPECT_EQ(same.pixel(x, y)[1], character.body.texture->pixel(x, y)[1]);
            EXPECT_EQ(shifted.pixel(x, y)[1], character.body.texture->pixel(x + 2, y + 1)[1]);
            EXPECT_NEAR(dark.pixel(x, y)[1], shifted.pixel(x, y)[1] / 2, 1);
        }
    EXPECT_GT(checked, 5000);
}

} // namespace
} // namespace quadrille
