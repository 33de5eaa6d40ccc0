// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/decodekernels.h"
#include "model/appearance/lookupkernels.h"
#include "model/appearance/rowwarp.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace quadrille;

namespace {

const WarpGrid grid = WarpGrid::over(40, 24);

/// Smooth, up to 2 texels.
std::vector<float> wave(float phase)
{
    std::vector<float> nodes;
    for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i) {
            nodes.push_back(2 * std::sin(0.4F * static_cast<float>(i) + phase));
            nodes.push_back(1.5F * std::cos(0.3F * static_cast<float>(j) - phase));
        }
    }
    return nodes;
}

Vec2f atNode(const std::vector<float>& nodes, int i, int j)
{
    const auto node = 2 * static_cast<std::size_t>(j * grid.width + i);
    return {nodes[node], nodes[node + 1]};
}

/// A warp between its nodes, and beyond them that of the last.
Vec2f plainWarpAt(const std::vector<float>& nodes, const Vec2f& place)
{
    const auto along = [&](float at, int count) {
        const float position =
            std::clamp(at / static_cast<float>(grid.spacing), 0.0F, static_cast<float>(count - 1));
        const int node = std::min(static_cast<int>(position), count - 2);
        return std::pair(node, position - static_cast<float>(node));
    };
    const auto [i, tx] = along(place.x(), grid.width);
    const auto [j, ty] = along(place.y(), grid.height);
    return (1 - ty) * ((1 - tx) * atNode(nodes, i, j) + tx * atNode(nodes, i + 1, j)) +
           ty * ((1 - tx) * atNode(nodes, i, j + 1) + tx * atNode(nodes, i + 1, j + 1));
}

std::vector<NodeRun> allNodes()
{
    std::vector<NodeRun> runs;
    for (int row = 0; row < grid.height; ++row)
        runs.push_back({.row = row, .column = 0, .count = grid.width});
    return runs;
}

} // namespace

TEST(RowWarp, IsBilinearBetweenNodes)
{
    std::vector<float> nodes(static_cast<std::size_t>(2 * grid.nodes()), 0.0F);
    const auto place = 2 * static_cast<std::size_t>(1 * grid.width + 2);
    nodes[place] = 8;
    nodes[place + 1] = -4;
    std::vector<float> rows;
    RowWarp warp(grid, nodes, 40, rows);
    warp.moveTo(4);
    EXPECT_EQ(warp.of(8), Vec2f(8, -4));
    EXPECT_EQ(warp.of(9), Vec2f(6, -3));
    EXPECT_EQ(warp.of(12), Vec2f(0, 0));
    warp.moveTo(5);
    EXPECT_EQ(warp.of(9), Vec2f(4.5F, -2.25F));
}

TEST(RowWarp, MovesOnByAnyNumberOfRows)
{
    const std::vector<float> waves = wave(0);
    std::vector<float> rows;
    RowWarp warp(grid, waves, 40, rows);
    for (const int y : {0, 1, 6, 7, 16, 23}) {
        warp.moveTo(y);
        for (int x = 0; x < 40; ++x)
            EXPECT_LT(
                (warp.of(x) - plainWarpAt(waves, Vec2f(static_cast<float>(x), static_cast<float>(y)))).norm(),
                1e-5F)
                << x << ' ' << y;
    }
}

TEST(UndoWarp, LeadsBackAlsoFromBeyondTheNodes)
{
    const std::vector<float> waves = wave(0.3F);
    std::vector<float> columns(39); // two whole registers and a part of one
    std::iota(columns.begin(), columns.end(), 0.0F);
    for (int y = 0; y < 24; ++y) {
        std::vector<float> found(2 * columns.size());
        undoWarp(waves.data(), grid, columns.data(), y, static_cast<int>(columns.size()), nullptr,
                 found.data());
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Vec2f back(found[2 * i], found[2 * i + 1]);
            const Vec2f end = Vec2f(columns[i], static_cast<float>(y)) + back;
            EXPECT_LT((back + plainWarpAt(waves, end)).norm(), 1e-3F) << i << ' ' << y;
        }
    }
}

TEST(WarpBetween, IsZeroWhereBothAreTheSame)
{
    for (const float value : warpBetween(wave(1), wave(1), grid, allNodes()))
        EXPECT_EQ(value, 0);
}

TEST(WarpBetween, IsTheDifferenceOfTranslations)
{
    std::vector<float> from;
    std::vector<float> to;
    for (std::int64_t node = 0; node < grid.nodes(); ++node) {
        from.insert(from.end(), {1.5F, -0.5F});
        to.insert(to.end(), {-0.5F, 2});
    }
    const std::vector<float> between = warpBetween(from, to, grid, allNodes());
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i)
            EXPECT_EQ(atNode(between, i, j), Vec2f(-2, 2.5F));
}

TEST(WarpBetween, LeadsToWhatShowsTheSame)
{
    const std::vector<float> from = wave(0);
    const std::vector<float> to = wave(0.7F);
    const std::vector<float> between = warpBetween(from, to, grid, allNodes());
    for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i) {
            const Vec2f place(static_cast<float>(i * grid.spacing), static_cast<float>(j * grid.spacing));
            const Vec2f moved = atNode(between, i, j);
            EXPECT_LT((moved + plainWarpAt(from, place + moved) - atNode(to, i, j)).norm(), 1e-3F);
        }
    }
}

TEST(WarpBetween, IsZeroAtNodesThatAreNotAskedFor)
{
    const std::vector<float> all = warpBetween(wave(0), wave(0.7F), grid, allNodes());
    const std::vector<float> some =
        warpBetween(wave(0), wave(0.7F), grid, std::vector<NodeRun>{{1, 2, 3}, {4, 0, 2}, {4, 5, 1}});
    for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i) {
            const bool isAskedFor = (j == 1 && i >= 2 && i < 5) || (j == 4 && (i < 2 || i == 5));
            EXPECT_EQ(atNode(some, i, j), isAskedFor ? atNode(all, i, j) : Vec2f(0, 0)) << i << ' ' << j;
        }
    }
}

TEST(MixBytes, RoundsToNearest)
{
    std::vector<std::uint8_t> first;
    std::vector<std::uint8_t> second;
    for (int i = 0; i < 256; ++i) {
        first.push_back(static_cast<std::uint8_t>(i));
        second.push_back(static_cast<std::uint8_t>(255 - (i * 7) % 256));
    }
    for (const float weight : {0.0F, 0.3F, 0.5F, 1.0F}) {
        std::vector<std::uint8_t> mixed(first.size());
        mixBytes(first.data(), second.data(), weight, std::ssize(mixed), mixed.data());
        for (std::size_t i = 0; i < mixed.size(); ++i) {
            const float exact = static_cast<float>(first[i]) +
                                weight * (static_cast<float>(second[i]) - static_cast<float>(first[i]));
            EXPECT_EQ(mixed[i], std::lround(exact)) << i << " at " << weight;
        }
    }
}
