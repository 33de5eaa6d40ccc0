// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/spreadpoints.h"

#include <algorithm>
#include <array>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

using namespace quadrille;

namespace {

/// A square of quads in two triangles each, which follow each other row by row.
struct Sheet
{
    std::vector<Vec3f> positions;
    std::vector<Triangle> triangles;

    explicit Sheet(std::uint32_t side)
    {
        for (std::uint32_t row = 0; row <= side; ++row) {
            for (std::uint32_t column = 0; column <= side; ++column)
                positions.emplace_back(static_cast<float>(column), static_cast<float>(row), 0.0F);
        }
        const auto vertex = [side](std::uint32_t row, std::uint32_t column) {
            return VertexIndex(row * (side + 1) + column);
        };
        for (std::uint32_t row = 0; row < side; ++row) {
            for (std::uint32_t column = 0; column < side; ++column) {
                triangles.push_back(
                    {vertex(row, column), vertex(row, column + 1), vertex(row + 1, column + 1)});
                triangles.push_back(
                    {vertex(row, column), vertex(row + 1, column + 1), vertex(row + 1, column)});
            }
        }
    }
};

} // namespace

TEST(SpreadTriangles, AreSoManyAndInTheOrderOfTheMesh)
{
    const Sheet sheet(16);
    for (const std::size_t count : {1, 2, 7, 100, 511}) {
        const std::vector<Triangle> spread = spreadTriangles(sheet.triangles, sheet.positions, count);
        ASSERT_EQ(spread.size(), count);
        auto next = sheet.triangles.begin();
        for (const Triangle& triangle : spread) {
            next = std::find(next, sheet.triangles.end(), triangle);
            ASSERT_NE(next, sheet.triangles.end());
            ++next;
        }
    }
}

TEST(SpreadTriangles, AreAllWhereThereAreNoMore)
{
    const Sheet sheet(4);
    EXPECT_EQ(spreadTriangles(sheet.triangles, sheet.positions, 32), sheet.triangles);
    EXPECT_EQ(spreadTriangles(sheet.triangles, sheet.positions, 1000), sheet.triangles);
    EXPECT_TRUE(spreadTriangles({}, {}, 5).empty());
}

TEST(SpreadTriangles, LieInEachPartOfTheSurfaceAsManyAsItsShare)
{
    // 16 parts of 32 triangles each: every eighth triangle makes four in each.
    const Sheet sheet(16);
    std::array<int, 16> counts{};
    for (const Triangle& triangle : spreadTriangles(sheet.triangles, sheet.positions, 64)) {
        const Vec3f corner = sheet.positions[triangle[0].value] / 4;
        ++counts[static_cast<std::size_t>(corner.y()) * 4 + static_cast<std::size_t>(corner.x())];
    }
    for (const int count : counts)
        EXPECT_EQ(count, 4);
}

TEST(SpreadTriangles, AreTakenFromTrianglesAtOnePlace)
{
    const std::vector<Vec3f> positions(3, Vec3f(1, 2, 3));
    const std::vector<Triangle> same(10, {VertexIndex(0), VertexIndex(1), VertexIndex(2)});
    EXPECT_EQ(spreadTriangles(same, positions, 4).size(), 4U);
}

TEST(SpreadPoints, AreRisingPlacesInEachPartOfThePlane)
{
    const Sheet sheet(15); // 16 × 16 points
    const std::vector<std::size_t> spread = spreadPoints(sheet.positions, 64);
    ASSERT_EQ(spread.size(), 64U);
    EXPECT_TRUE(std::ranges::is_sorted(spread, std::less_equal<>()));
    std::array<int, 16> counts{};
    for (const std::size_t place : spread)
        ++counts[place / 16 / 4 * 4 + place % 16 / 4];
    for (const int count : counts)
        EXPECT_EQ(count, 4);
}

TEST(SpreadPoints, AreAllWhereThereAreNoMore)
{
    const std::vector<Vec3f> points(5, Vec3f(1, 2, 3));
    EXPECT_EQ(spreadPoints(points, 5), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(spreadPoints(points, 50), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(spreadPoints(points, 3).size(), 3U);
    EXPECT_TRUE(spreadPoints({}, 5).empty());
}
