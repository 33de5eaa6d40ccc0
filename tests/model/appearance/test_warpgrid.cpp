// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/decodekernels.h"
#include "model/appearance/warpgrid.h"

#include <cmath>
#include <gtest/gtest.h>

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

} // namespace

TEST(WarpGrid, IsBilinearBetweenNodesAndConstantBeyondThem)
{
    std::vector<float> nodes(static_cast<std::size_t>(2 * grid.nodes()), 0.0F);
    const auto place = 2 * static_cast<std::size_t>(1 * grid.width + 2);
    nodes[place] = 8;
    nodes[place + 1] = -4;
    EXPECT_EQ(warpAt(nodes, grid, {8, 4}), Vec2f(8, -4));
    EXPECT_EQ(warpAt(nodes, grid, {9, 4}), Vec2f(6, -3));
    EXPECT_EQ(warpAt(nodes, grid, {9, 5}), Vec2f(4.5F, -2.25F));
    EXPECT_EQ(warpAt(nodes, grid, {12, 4}), Vec2f(0, 0));
    const std::vector<float> waves = wave(0);
    EXPECT_EQ(warpAt(waves, grid, {-9, -7}), atNode(waves, 0, 0));
    EXPECT_EQ(warpAt(waves, grid, {400, 300}), atNode(waves, grid.width - 1, grid.height - 1));
}

TEST(WarpBetween, IsZeroWhereBothAreTheSame)
{
    for (const float value : warpBetween(wave(1), wave(1), grid))
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
    const std::vector<float> between = warpBetween(from, to, grid);
    for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i)
            EXPECT_EQ(atNode(between, i, j), Vec2f(-2, 2.5F));
}

TEST(WarpBetween, LeadsToWhatShowsTheSame)
{
    const std::vector<float> from = wave(0);
    const std::vector<float> to = wave(0.7F);
    const std::vector<float> between = warpBetween(from, to, grid);
    for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i) {
            const Vec2f place(static_cast<float>(i * grid.spacing), static_cast<float>(j * grid.spacing));
            const Vec2f moved = atNode(between, i, j);
            EXPECT_LT((moved + warpAt(from, grid, place + moved) - atNode(to, i, j)).norm(), 0.01F);
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
