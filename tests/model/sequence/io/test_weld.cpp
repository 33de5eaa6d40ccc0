// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/weld.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace quadrille;
using ::testing::ElementsAre;

namespace {

using Corners = std::array<std::uint32_t, 3>;

// Two triangles of a unit square, cut along the diagonal.
const std::vector<Vec3f> cutSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<Corners> cutSquareTriangles = {{0, 1, 2}, {3, 4, 5}};

/// A box of twelve triangles with its own vertices for each side, as flat shading makes it.
void addFlatBox(std::vector<Vec3f>& positions, std::vector<Corners>& triangles, const Vec3f& origin)
{
    for (int axis = 0; axis < 3; ++axis) {
        for (int end = 0; end < 2; ++end) {
            const auto first = static_cast<std::uint32_t>(positions.size());
            for (int corner = 0; corner < 4; ++corner) {
                Vec3f p;
                p[axis] = static_cast<float>(end);
                p[(axis + 1) % 3] = static_cast<float>(corner & 1);
                p[(axis + 2) % 3] = static_cast<float>(corner >> 1);
                positions.push_back(origin + p);
            }
            if (end == 1) {
                triangles.push_back({first, first + 1, first + 3});
                triangles.push_back({first, first + 3, first + 2});
            } else {
                triangles.push_back({first, first + 3, first + 1});
                triangles.push_back({first, first + 2, first + 3});
            }
        }
    }
}

} // namespace

TEST(Weld, JoinsACutAndKeepsTheOrderOfFirstOccurrence)
{
    const Weld weld = weldVertices(cutSquare, {}, cutSquareTriangles);
    EXPECT_THAT(weld.vertexOf, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(weld.firstOf, ElementsAre(0, 1, 2, 5));
}

TEST(Weld, NegativeZeroIsZero)
{
    auto positions = cutSquare;
    positions[3] = {-0.0F, -0.0F, -0.0F};
    EXPECT_EQ(weldVertices(positions, {}, cutSquareTriangles).vertexCount(), 4U);
}

TEST(Weld, DifferentBonesOrMorphsStayApart)
{
    // Lips: the same places, but the lower side belongs to the jaw.
    EXPECT_EQ(weldVertices(cutSquare, std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1}, cutSquareTriangles)
                  .vertexCount(),
              6U);
    // One end of the cut alone is no edge to continue over.
    EXPECT_EQ(weldVertices(cutSquare, std::vector<std::uint32_t>{0, 0, 0, 0, 1, 0}, cutSquareTriangles)
                  .vertexCount(),
              6U);
}

TEST(Weld, ShellsThatTouchInAPointStayApart)
{
    const std::vector<Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
    const std::vector<Corners> triangles = {{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(weldVertices(positions, {}, triangles).vertexCount(), 6U);
}

TEST(Weld, TwoSidesOfACardStayApart)
{
    const std::vector<Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    const std::vector<Corners> triangles = {{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(weldVertices(positions, {}, triangles).vertexCount(), 6U);
}

TEST(Weld, AFlatShadedBoxClosesAndStackedBoxesStayTwo)
{
    std::vector<Vec3f> positions;
    std::vector<Corners> triangles;
    addFlatBox(positions, triangles, {0, 0, 0});
    EXPECT_EQ(weldVertices(positions, {}, triangles).vertexCount(), 8U);
    addFlatBox(positions, triangles, {0, 0, 1});
    const Weld weld = weldVertices(positions, {}, triangles);
    EXPECT_EQ(weld.vertexCount(), 16U);
    for (std::size_t v = 0; v < 24; ++v)
        EXPECT_LT(weld.vertexOf[v], 8U);
}

TEST(Weld, VerticesOfNoTriangleStay)
{
    const std::vector<Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(weldVertices(positions, {}, std::vector<Corners>{{0, 1, 2}}).vertexCount(), 5U);
}

TEST(Weld, RowsThatAreEqualShareAClass)
{
    RowClasses classes;
    EXPECT_EQ(classes.classOf("a"), 0U);
    EXPECT_EQ(classes.classOf("b"), 1U);
    EXPECT_EQ(classes.classOf("a"), 0U);
}
