// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "atlas.h"
#include "model/appearance/chartlookup.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// Two charts of three texels with one free texel between their gutters, one row: aAAAa.bBBBb.
ChartLookup rowOfCharts()
{
    return ChartLookup(usedTexels(Topology(test::atlasOf({{1, 0, 4, 1}, {7, 0, 10, 1}}, 12, 1)), 12, 1, 1));
}

ChartLookup wholeAtlas(int size)
{
    const double side = size;
    return ChartLookup(usedTexels(Topology(test::atlasOf({{0, 0, side, side}}, side, side)), size, size));
}

std::vector<Vec2f> fieldOf(const ChartLookup& charts, const auto& at)
{
    std::vector<Vec2f> field;
    for (std::size_t k = 0; k < charts.used().texels.size(); ++k) {
        const auto [x, y] = charts.place(k);
        field.push_back(at(static_cast<float>(x), static_cast<float>(y)));
    }
    return field;
}

float largestDifference(const std::vector<Vec2f>& field, const std::vector<Vec2f>& wanted)
{
    float largest = 0;
    for (std::size_t k = 0; k < field.size(); ++k)
        largest = std::max(largest, (field[k] - wanted[k]).norm());
    return largest;
}

} // namespace

TEST(ChartLookup, ShortensDisplacementsToStayInTheChart)
{
    const ChartLookup charts = rowOfCharts();
    ASSERT_EQ(charts.count(), 10);
    // From column 1 to 5.5 is beyond the gutter in column 4: 7/8 and less of the way are tried.
    std::vector<Vec2f> field(10, Vec2f::Zero());
    field[1] = Vec2f(4.5F, 0);
    field[2] = Vec2f(1.75F, 0);
    field[7] = Vec2f(-4, 0);     // column 8 to 4 would take the other chart's gutter
    field[6] = Vec2f(1, -1e-6F); // along the edge of the atlas
    field[3] = Vec2f(0, 0.5F);   // above the edge of the atlas
    charts.keepInside(field);
    EXPECT_EQ(field[1], Vec2f(4.5F * 5 / 8, 0));
    EXPECT_EQ(field[2], Vec2f(1.75F, 0));
    EXPECT_EQ(field[7], Vec2f(-2, 0));
    EXPECT_EQ(field[3], Vec2f(0, 0));
    EXPECT_EQ(field[6], Vec2f(1, 0));
}

TEST(ChartLookup, CarriesDisplacementsIntoTheGutter)
{
    const ChartLookup charts = rowOfCharts();
    std::vector<Vec2f> field(10, Vec2f(9, 9));
    for (const std::size_t k : {1U, 2U, 3U})
        field[k] = Vec2f(0.25F, 0);
    for (const std::size_t k : {6U, 7U, 8U})
        field[k] = Vec2f(-0.25F, 0);
    charts.keepInside(field);
    EXPECT_EQ(field[0], Vec2f(0.25F, 0));
    EXPECT_EQ(field[4], Vec2f(0, 0)); // a quarter to the right would be outside
    EXPECT_EQ(field[5], Vec2f(0, 0));
    EXPECT_EQ(field[9], Vec2f(-0.25F, 0));
}

TEST(ChartLookup, LooksColoursUpBetweenTexelsOfTheChart)
{
    const ChartLookup charts = rowOfCharts();
    Image texture(12, 1);
    for (int x = 0; x < 12; ++x)
        for (int c = 0; c < 3; ++c)
            texture.pixel(x, 0)[c] = static_cast<std::uint8_t>(20 * x + c);
    const std::vector<std::uint8_t> still = charts.colours(texture);
    EXPECT_EQ(std::vector<std::uint8_t>(still.begin() + 3, still.begin() + 6),
              (std::vector<std::uint8_t>{20, 21, 22}));
    EXPECT_EQ(charts.colours(texture, std::vector<Vec2f>(10, Vec2f::Zero())), still);
    std::vector<Vec2f> field(10, Vec2f::Zero());
    field[1] = Vec2f(1.25F, 0);
    field[4] = Vec2f(0.5F, 0); // between the gutter, which shows column 3, and a free texel
    const std::vector<std::uint8_t> moved = charts.colours(texture, field);
    EXPECT_EQ(moved[3], 45);
    EXPECT_EQ(moved[12], 60);
    EXPECT_EQ(still[12], 60);
}

TEST(ChartLookup, IsExactForPolynomialsOfTheSecondDegree)
{
    const ChartLookup charts = wholeAtlas(40);
    const auto value = [](float x, float y, int c) {
        return 0.02F * x * x - 0.05F * x * y + static_cast<float>(c) * y;
    };
    std::vector<float> values;
    for (std::size_t k = 0; k < 1600; ++k) {
        const auto [x, y] = charts.place(k);
        for (int c = 0; c < 3; ++c)
            values.push_back(value(static_cast<float>(x), static_cast<float>(y), c));
    }
    values.push_back(NAN); // counts nothing
    const std::vector<Vec2f> field(1600, Vec2f(-0.375F, 1.25F));
    std::vector<float> looked(4800);
    charts.sample(values, field, looked);
    for (std::size_t k = 0; k < 1600; ++k) {
        const auto [x, y] = charts.place(k);
        if (x < 2 || y < 1 || x > 37 || y > 36)
            continue; // linear
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(looked[3 * k + static_cast<std::size_t>(c)],
                        value(static_cast<float>(x) - 0.375F, static_cast<float>(y) + 1.25F, c), 1e-3F)
                << x << ' ' << y;
    }
}

TEST(ChartLookup, NeverMixesColoursOfTwoCharts)
{
    // Their gutters meet: aAAabBBb.
    const ChartLookup charts(
        usedTexels(Topology(test::atlasOf({{1, 0, 3, 1}, {5, 0, 7, 1}}, 8, 1)), 8, 1, 1));
    Image texture(8, 1);
    for (int x = 0; x < 8; ++x)
        std::fill_n(texture.pixel(x, 0), 3, static_cast<std::uint8_t>(x < 4 ? 10 : 200));
    std::vector<Vec2f> field(8, Vec2f(0.5F, 0));
    const std::vector<std::uint8_t> moved = charts.colours(texture, field);
    EXPECT_EQ(moved[9], 10);
    EXPECT_EQ(moved[12], 200);
}

TEST(ChartLookup, KeepsSmoothFieldsOnAGrid)
{
    const ChartLookup charts = wholeAtlas(41);
    const WarpGrid grid = WarpGrid::over(41, 41, 4);
    EXPECT_EQ(grid.width, 11);
    EXPECT_EQ(WarpGrid::over(42, 1, 4).width, 12);
    EXPECT_EQ(WarpGrid::over(42, 1, 4).height, 1);
    const auto smooth = [](float x, float y) {
        return Vec2f(0.8F * std::sin(0.0785F * x), -0.5F * std::sin(0.157F * y)); // none at the edges
    };
    std::vector<Vec2f> wanted = fieldOf(charts, smooth);
    charts.keepInside(wanted);
    // Straight lines over four texels miss curves by 4² / 8 of the second derivative, which is 0.012 here.
    EXPECT_LT(largestDifference(charts.atTexels(charts.atNodes(wanted, grid), grid), wanted), 0.03F);
    std::vector<Vec2f> constant(wanted.size(), Vec2f(0.5F, 0.25F));
    const std::vector<float> nodes = charts.atNodes(constant, grid);
    for (std::size_t n = 0; n < nodes.size(); n += 2) {
        EXPECT_FLOAT_EQ(nodes[n], 0.5F);
        EXPECT_FLOAT_EQ(nodes[n + 1], 0.25F);
    }
}

TEST(ChartLookup, LeavesNodesOfOtherChartsAlone)
{
    const ChartLookup charts = rowOfCharts();
    std::vector<Vec2f> field(10, Vec2f::Zero());
    for (const std::size_t k : {5U, 6U, 7U, 8U, 9U})
        field[k] = Vec2f(3, 0);
    const std::vector<float> nodes = charts.atNodes(field, WarpGrid::over(12, 1, 2));
    // Nodes at columns 0, 2, 4, 6, …: the texel in column 5 belongs to none.
    EXPECT_FLOAT_EQ(nodes[2 * 2], 0);
    EXPECT_FLOAT_EQ(nodes[2 * 3], 3);
}

TEST(ChartLookup, InvertsWarps)
{
    const ChartLookup charts = wholeAtlas(64);
    const WarpGrid grid = WarpGrid::over(64, 64, 4);
    const auto warp = [](float x, float y) {
        const float fade = std::sin(3.1416F * x / 63) * std::sin(3.1416F * y / 63);
        return Vec2f(3 * fade, -2 * fade);
    };
    const std::vector<float> nodes = charts.atNodes(fieldOf(charts, warp), grid);
    const std::vector<Vec2f> inverse = charts.inverse(nodes, grid);
    for (std::size_t k = 0; k < inverse.size(); ++k) {
        const auto [x, y] = charts.place(k);
        const Vec2f end = Vec2f(static_cast<float>(x), static_cast<float>(y)) + inverse[k];
        // As exact as the grid holds the warp.
        EXPECT_LT((inverse[k] + warp(end.x(), end.y())).norm(), 0.05F) << x << ' ' << y;
    }
    const std::vector<float> constant =
        charts.atNodes(std::vector<Vec2f>(inverse.size(), Vec2f(0.5F, 1)), grid);
    EXPECT_EQ(charts.inverse(constant, grid)[30 * 64 + 30], Vec2f(-0.5F, -1));
}
