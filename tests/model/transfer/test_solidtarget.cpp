// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transfer/solidtarget.h"
#include "tests/model/codeof.h"
#include "tests/model/geometry/surfaces.h"

#include <gtest/gtest.h>
#include <limits>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Two triangles of a square that do not share vertices, one of them far below a third that nothing holds.
Surface splitSquare()
{
    Surface square;
    square.pose = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 2, 0}};
    square.data.vertexCount = 7;
    square.data.triangles = {corners(0, 1, 2), corners(3, 4, 5), corners(0, 3, 1)};
    return square;
}

} // namespace

TEST(SolidTarget, WeldsVerticesAtOnePlace)
{
    const Surface square = splitSquare();
    const SolidTarget target(*square.topology(), square.pose);
    EXPECT_EQ(target.positions().size(), 4U);
    EXPECT_EQ(target.topology()->statistics().components, 1);
    EXPECT_EQ(target.vertices()[0], target.vertices()[3]);
    EXPECT_EQ(target.vertices()[2], target.vertices()[4]);
    EXPECT_EQ(target.triangleOf(TriangleIndex(1)), 1U);
}

TEST(SolidTarget, LeavesOutTrianglesThatLoseACorner)
{
    const Surface square = splitSquare();
    const SolidTarget target(*square.topology(), square.pose);
    EXPECT_EQ(target.topology()->triangles().size(), 2U);
    EXPECT_FALSE(target.triangleOf(TriangleIndex(2)));
    EXPECT_FALSE(target.triangleOf(TriangleIndex(3)));
}

TEST(SolidTarget, HoldsLooseVerticesByTheNearest)
{
    const Surface square = splitSquare();
    const SolidTarget target(*square.topology(), square.pose);
    ASSERT_EQ(target.offsets().size(), 1U);
    EXPECT_EQ(target.offsets()[0].vertex, 6U);
    EXPECT_EQ(target.offsets()[0].offset, Vec3f(1, 1, 0));
    EXPECT_EQ(target.vertices()[6], target.vertices()[2]);
}

TEST(SolidTarget, BridgesComponentsToTheLargest)
{
    Surface two = makeTube(8, 3, 0.5F, 0.1F);
    const Surface large = makeTube(8, 5, 0.5F, 1.0F);
    const auto first = static_cast<std::uint32_t>(two.pose.size());
    for (const Vec3f& p : large.pose)
        two.pose.push_back(p + Vec3f(0, 10, 0));
    for (const Triangle& t : large.data.triangles)
        two.data.triangles.push_back(corners(first + t[0].value, first + t[1].value, first + t[2].value));
    two.data.vertexCount = static_cast<std::uint32_t>(two.pose.size());
    const SolidTarget target(*two.topology(), two.pose);
    ASSERT_EQ(target.bridges().size(), 2U);
    const SolidTarget::Bridge& small = target.bridges()[0];
    EXPECT_EQ(target.bridges()[1].vertex, target.bridges()[1].onto);
    EXPECT_FLOAT_EQ(target.positions()[small.vertex].y(), 1);
    EXPECT_FLOAT_EQ(target.positions()[small.onto].y(), 10);
}

TEST(SolidTarget, RefusesWhatIsNoMesh)
{
    Surface square = splitSquare();
    EXPECT_EQ(codeOf([&] { SolidTarget(*square.topology(), Positions(square.pose).first(6)); }),
              ErrorCode::VertexCountMismatch);
    square.pose[5].x() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(codeOf([&] { SolidTarget(*square.topology(), square.pose); }), ErrorCode::NonFiniteCoordinate);
    const std::vector<Vec3f> point(7, Vec3f::Zero());
    EXPECT_EQ(codeOf([&] { SolidTarget(*square.topology(), point); }), ErrorCode::NoFaces);
}
