// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/pairtiles.h"

#include <algorithm>
#include <cstdint>

namespace quadrille {

namespace {

/// Two whole numbers with their bits in turn: what is near in both is near in this (Morton 1966).
std::uint64_t interleaved(std::uint32_t a, std::uint32_t b)
{
    std::uint64_t result = 0;
    for (int bit = 0; bit < 32; ++bit)
        result |=
            (std::uint64_t{a >> bit & 1U} << (2 * bit + 1)) | (std::uint64_t{b >> bit & 1U} << (2 * bit));
    return result;
}

} // namespace

std::vector<PairTile> pairTiles(NodeIndex frameCount, NodeIndex size)
{
    std::vector<PairTile> tiles;
    for (NodeIndex row = 0; row < frameCount; row += size) {
        for (NodeIndex column = row; column < frameCount; column += size)
            tiles.push_back(
                {row, std::min(size, frameCount - row), column, std::min(size, frameCount - column)});
    }
    const auto key = [size](const PairTile& tile) {
        return interleaved(static_cast<std::uint32_t>(tile.firstRow / size),
                           static_cast<std::uint32_t>(tile.firstColumn / size));
    };
    std::sort(tiles.begin(), tiles.end(),
              [&key](const PairTile& a, const PairTile& b) { return key(a) < key(b); });
    return tiles;
}

void storeSymmetric(const PairTile& tile, std::span<const float> values, Table<float>& table)
{
    const Eigen::Map<const Table<float>> pairs(values.data(), tile.rows, tile.columns);
    for (NodeIndex row = 0; row < tile.rows; ++row) {
        for (NodeIndex column = 0; column < tile.columns; ++column) {
            const NodeIndex i = tile.firstRow + row;
            const NodeIndex j = tile.firstColumn + column;
            if (i < j)
                table(i, j) = table(j, i) = pairs(row, column);
        }
    }
}

} // namespace quadrille
