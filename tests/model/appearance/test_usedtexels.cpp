// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "atlas.h"
#include "model/appearance/usedtexels.h"
#include "model/core/random.h"
#include "tests/model/codeof.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>

using namespace quadrille;
using test::atlasOf;
using test::codeOf;

namespace {

/// A letter for each texel: the chart as 'A', 'B', … where it is covered, small in the gutter, '.' elsewhere.
std::vector<std::string> drawn(const UsedTexels& used)
{
    std::vector<std::string> rows(static_cast<std::size_t>(used.height),
                                  std::string(static_cast<std::size_t>(used.width), '.'));
    for (std::size_t k = 0; k < used.texels.size(); ++k) {
        const auto width = static_cast<std::uint32_t>(used.width);
        rows[used.texels[k] / width][used.texels[k] % width] =
            static_cast<char>((used.covered[k] != 0 ? 'A' : 'a') + used.charts[k]);
    }
    return rows;
}

std::vector<std::string> drawn(const TopologyData& data, int width, int height, int gutter)
{
    return drawn(usedTexels(Topology(data), width, height, gutter));
}

using Rows = std::vector<std::string>;

} // namespace

TEST(UsedTexels, CoverTheCentresThatLieInTriangles)
{
    // The upper edge passes above the centres of row 1, the right edge left of those of column 3.
    EXPECT_EQ(drawn(atlasOf({{1, 1.25, 3.25, 3}}, 5, 4), 5, 4, 0),
              (Rows{".....", ".AA..", ".AA..", "....."}));
    EXPECT_EQ(drawn(atlasOf({{1, 1.75, 3.75, 3}}, 5, 4), 5, 4, 0),
              (Rows{".....", ".....", ".AAA.", "....."}));
    // Centres on the edge count.
    EXPECT_EQ(drawn(atlasOf({{1.5, 1.5, 3.5, 2.5}}, 5, 4), 5, 4, 0),
              (Rows{".....", ".AAA.", ".AAA.", "....."}));
}

TEST(UsedTexels, CountRowsFromTheTopWhileVGrowsUpwards)
{
    TopologyData data;
    data.vertexCount = 3;
    data.triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}};
    data.triangleUvs = {{0, 1, 2}};
    data.uvs = {Vec2f(0, 1), Vec2f(1, 1), Vec2f(0, 0)};
    const Rows rows{"AAAA", "AAA.", "AA..", "A..."};
    EXPECT_EQ(drawn(data, 4, 4, 0), rows);
    // Turned over, as mirrored charts are.
    data.triangleUvs = {{0, 2, 1}};
    EXPECT_EQ(drawn(data, 4, 4, 0), rows);
}

TEST(UsedTexels, HaveARoundGutter)
{
    EXPECT_EQ(drawn(atlasOf({{3, 3, 4, 4}}, 7, 7), 7, 7, 2),
              (Rows{".......", "...a...", "..aaa..", ".aaAaa.", "..aaa..", "...a...", "......."}));
}

TEST(UsedTexels, ShareTheGutterBetweenTwoChartsByDistance)
{
    // Five texels between them: the one in the middle goes to the first.
    EXPECT_EQ(drawn(atlasOf({{1, 0, 2, 1}, {7, 0, 8, 1}}, 9, 1), 9, 1, 4), (Rows{"aAaaabbBb"}));
    EXPECT_EQ(drawn(atlasOf({{7, 0, 8, 1}, {1, 0, 2, 1}}, 9, 1), 9, 1, 4), (Rows{"bBbbaaaAa"}));
    EXPECT_EQ(drawn(atlasOf({{1, 0, 2, 1}, {2.25, 0, 3, 1}}, 4, 1), 4, 1, 4), (Rows{"aABb"}));
}

TEST(UsedTexels, FindPiecesByThePlacesOfUvs)
{
    // Each triangle of a quad with UVs of its own, as files with one UV per corner have it.
    TopologyData data = atlasOf({{0, 0, 4, 4}}, 8, 4);
    TopologyData split = data;
    split.uvs.clear();
    split.triangleUvs.clear();
    for (const auto& t : data.triangleUvs) {
        const auto first = static_cast<std::uint32_t>(split.uvs.size());
        for (const std::uint32_t uv : t)
            split.uvs.push_back(data.uvs[uv]);
        split.triangleUvs.push_back({first, first + 1, first + 2});
    }
    EXPECT_EQ(usedTexels(Topology(split), 8, 4), usedTexels(Topology(data), 8, 4));
    EXPECT_EQ(usedTexels(Topology(split), 8, 4).chartCount, 1);
}

TEST(UsedTexels, GiveTexelsOfTwoChartsToTheFirst)
{
    EXPECT_EQ(drawn(atlasOf({{2, 0, 5, 1}, {0, 0, 3, 1}}, 6, 1), 6, 1, 0), (Rows{"BBAAA."}));
}

TEST(UsedTexels, RepeatWhatLiesOutside)
{
    EXPECT_EQ(drawn(atlasOf({{-1, 0, 2, 1}}, 6, 2), 6, 2, 0), (Rows{"AA...A", "......"}));
    EXPECT_EQ(drawn(atlasOf({{13, 5, 15, 6}}, 6, 2), 6, 2, 0), (Rows{"......", ".AA..."}));
    // More than the whole atlas, however far it goes.
    EXPECT_EQ(drawn(atlasOf({{-1e9, -1e9, 1e9, 1e9}}, 3, 2), 3, 2, 0), (Rows{"AAA", "AAA"}));
}

TEST(UsedTexels, HoldTrianglesBetweenCentres)
{
    EXPECT_EQ(drawn(atlasOf({{1, 1.1, 4, 1.2}}, 5, 3), 5, 3, 0), (Rows{".....", ".aaaa", "....."}));
    EXPECT_EQ(drawn(atlasOf({{1.1, 1.1, 1.2, 1.2}}, 4, 3), 4, 3, 1), (Rows{".a..", "aaa.", ".a.."}));
}

TEST(UsedTexels, AreGivenToTheNearestChartAsAPlainSearchFinds)
{
    Random random(3);
    std::vector<test::Rectangle> rectangles;
    for (int k = 0; k < 12; ++k) {
        const double x = random.between(0, 56);
        const double y = random.between(0, 40);
        rectangles.push_back({x, y, x + random.between(1, 9), y + random.between(1, 9)});
    }
    constexpr int width = 64;
    constexpr int height = 48;
    constexpr int gutter = 6;
    const Topology topology(atlasOf(rectangles, width, height));
    const Rows inside = drawn(usedTexels(topology, width, height, 0));
    const UsedTexels used = usedTexels(topology, width, height, gutter);
    Rows wanted = inside;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            char& found = wanted[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
            if (found != '.')
                continue;
            int best = gutter * gutter + 1;
            for (int row = 0; row < height; ++row)
                for (int column = 0; column < width; ++column) {
                    const char chart =
                        inside[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
                    const int distance = (row - y) * (row - y) + (column - x) * (column - x);
                    if (chart == '.' || distance > best || (distance == best && chart - 'A' + 'a' >= found))
                        continue;
                    best = distance;
                    found = static_cast<char>(chart - 'A' + 'a');
                }
            if (best > gutter * gutter)
                found = '.';
        }
    EXPECT_EQ(drawn(used), wanted);
    EXPECT_TRUE(std::is_sorted(used.texels.begin(), used.texels.end()));
    EXPECT_EQ(used.charts.size(), used.texels.size());
    EXPECT_EQ(used.covered.size(), used.texels.size());
    EXPECT_EQ(used.chartCount, 12);
}

TEST(UsedTexels, AreRefusedWithoutUvsAndWithoutTexels)
{
    TopologyData data = atlasOf({{0, 0, 2, 2}}, 4, 4);
    EXPECT_EQ(codeOf([&] { usedTexels(Topology(data), 0, 4); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([&] { usedTexels(Topology(data), 4, 1 << 16); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([&] { usedTexels(Topology(data), 4, 4, -1); }), ErrorCode::BadArgument);
    TopologyData lost = data;
    lost.uvs.assign(4, Vec2f(std::numeric_limits<float>::quiet_NaN(), 0));
    EXPECT_EQ(codeOf([&] { usedTexels(Topology(lost), 4, 4); }), ErrorCode::BadArgument);
    data.uvs.clear();
    data.triangleUvs.clear();
    EXPECT_EQ(codeOf([&] { usedTexels(Topology(data), 4, 4); }), ErrorCode::NoUvs);
}
