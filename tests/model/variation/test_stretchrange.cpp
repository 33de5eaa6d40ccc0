// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/stitching.h"
#include "model/variation/parts/stretchrange.h"
#include "tests/model/variation/handmadeparts.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace quadrille;

namespace {

using Pose = std::vector<Vec3f>;
using Matrix32 = Eigen::Matrix<double, 3, 2>;

Topology oneTriangle()
{
    return Topology({.vertexCount = 3, .triangles = {{VertexIndex(0U), VertexIndex(1U), VertexIndex(2U)}}});
}

TriangleEdges edgesOf(const Pose& pose)
{
    TriangleEdges edges{};
    Vec3d::Map(edges.first.data()) = (pose[0] - pose[2]).cast<double>();
    Vec3d::Map(edges.second.data()) = (pose[1] - pose[2]).cast<double>();
    return edges;
}

Matrix32 matrixOf(const TriangleEdges& edges)
{
    Matrix32 matrix;
    matrix << Vec3d::Map(edges.first.data()), Vec3d::Map(edges.second.data());
    return matrix;
}

TriangleEdges restricted(const Pose& rest, const std::vector<Pose>& poses, const Pose& pose)
{
    TriangleEdges edges = edgesOf(pose);
    StretchRange(oneTriangle(), rest, std::vector<Positions>(poses.begin(), poses.end()))
        .restrict(std::span(&edges, 1));
    return edges;
}

/// The map of the plane of a triangle into space that takes its edges to others, and its principal stretches.
Eigen::JacobiSVD<Matrix32> mapOf(const Pose& rest, const TriangleEdges& edges)
{
    const Matrix32 from = matrixOf(edgesOf(rest));
    Matrix32 frame;
    frame.col(0) = from.col(0).normalized();
    frame.col(1) = (from.col(1) - frame.col(0).dot(from.col(1)) * frame.col(0)).normalized();
    const Eigen::Matrix2d flat = frame.transpose() * from;
    const Matrix32 map = matrixOf(edges) * flat.inverse();
    return Eigen::JacobiSVD<Matrix32>(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

const Pose corner{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}};

} // namespace

TEST(StretchRange, LetsBeWhatLiesInside)
{
    const Pose wider{{2, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    const Pose between{{0, 1.5F, 1}, {1.1F, 0, 1}, {0, 0, 1}};
    EXPECT_EQ(matrixOf(restricted(corner, {wider}, between)), matrixOf(edgesOf(between)));
    // Without any range all is inside.
    TriangleEdges edges = edgesOf({{70, 0, 0}, {0, 1, 0}, {0, 0, 0}});
    StretchRange().restrict(std::span(&edges, 1));
    EXPECT_EQ(edges.first[0], 70);
}

TEST(StretchRange, BringsBackWhatLiesBeyond)
{
    const Pose wider{{1.2F, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    // Stretched threefold along one edge, halved along the other, and turned.
    const TriangleEdges edges = restricted(corner, {wider}, {{0, 0, 3}, {0, 0.5F, 0}, {0, 0, 0}});
    EXPECT_LT((matrixOf(edges).col(0) - Vec3d(0, 0, 1.2)).norm(), 1e-7);
    EXPECT_LT((matrixOf(edges).col(1) - Vec3d(0, 1, 0)).norm(), 1e-7);
}

TEST(StretchRange, KeepsPrincipalDirectionsAndTurns)
{
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    const auto triangle = [&] {
        Pose pose;
        for (int v = 0; v < 3; ++v)
            pose.emplace_back(normal(random), normal(random), normal(random));
        return pose;
    };
    int changed = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Pose rest = triangle();
        const std::vector<Pose> poses{triangle(), triangle()};
        const Pose pose = triangle();
        double least = 1;
        double greatest = 1;
        for (const Pose& each : poses) {
            const Vec2d stretches = mapOf(rest, edgesOf(each)).singularValues();
            least = std::min(least, stretches[1]);
            greatest = std::max(greatest, stretches[0]);
        }
        const Eigen::JacobiSVD<Matrix32> given = mapOf(rest, edgesOf(pose));
        const Vec2d wanted(std::clamp(given.singularValues()[0], least, greatest),
                           std::clamp(given.singularValues()[1], least, greatest));
        changed += wanted != given.singularValues() ? 1 : 0;
        const Matrix32 expected =
            given.matrixU().leftCols<2>() * wanted.asDiagonal() * given.matrixV().transpose();
        const Eigen::JacobiSVD<Matrix32> got = mapOf(rest, restricted(rest, poses, pose));
        const Matrix32 map =
            got.matrixU().leftCols<2>() * got.singularValues().asDiagonal() * got.matrixV().transpose();
        EXPECT_LT((map - expected).norm(), 1e-5 * (1 + expected.norm())) << trial;
    }
    EXPECT_GT(changed, 100);
}

TEST(StretchRange, LetsTrianglesWithoutAreaBe)
{
    const Pose flat{{1, 0, 0}, {2, 0, 0}, {0, 0, 0}};
    const Pose large{{5, 0, 0}, {0, 5, 0}, {0, 0, 0}};
    EXPECT_EQ(matrixOf(restricted(flat, {flat}, large)), matrixOf(edgesOf(large)));
    EXPECT_EQ(matrixOf(restricted(corner, {flat}, {{9, 0, 0}, {18, 0, 0}, {0, 0, 0}})),
              matrixOf(edgesOf({{9, 0, 0}, {18, 0, 0}, {0, 0, 0}})));
    EXPECT_EQ(matrixOf(restricted(corner, {corner}, Pose(3, Vec3f::Zero()))), Matrix32::Zero());
}

// A part that a model made half as long again. The bend alone stretches by a tenth.
TEST(StretchRange, KeepsStitchedPartsToTheShapesThatAreGiven)
{
    const quadrille::test::PartedBar parted;
    const Pose& rest = parted.bar.positions;
    const Pose other = bent(rest, 2.0, 1.5);
    const auto stitched = [&](const Stitching& stitching, const std::vector<Pose>& poses) {
        Pose out(rest.size());
        stitching.stitch(quadrille::test::viewed(poses), out);
        return out;
    };
    const auto largestDistance = [](const Pose& a, const Pose& b) {
        float largest = 0;
        for (std::size_t v = 0; v < a.size(); ++v)
            largest = std::max(largest, (a[v] - b[v]).norm());
        return largest;
    };
    const Stitching kept(parted.bar.topology, parted.parts, rest, std::vector<Positions>{rest, other});
    const Stitching free(parted.bar.topology, parted.parts, rest);
    std::vector<Pose> poses = quadrille::test::cutPose(parted.parts, other);
    EXPECT_LT(largestDistance(stitched(kept, poses), other), 2e-6F);
    for (Vec3f& position : poses[3])
        position *= 1.5F;
    EXPECT_LT(largestDistance(stitched(kept, poses), other), 0.03F);
    EXPECT_GT(largestDistance(stitched(free, poses), other), 0.1F);
}
