// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/cubicweights.h"
#include "model/appearance/decodekernels.h"
#include "model/core/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace quadrille {
namespace {

constexpr int planeWidth = 300;
constexpr int planeHeight = 30;
constexpr int planeStride = planeWidth + 3;

/// With a texel before each row and two behind, as rows above and below.
std::vector<std::uint32_t> noisyPlane(bool isOpaque)
{
    Random random(3);
    std::vector<std::uint32_t> plane(std::size_t{planeStride} * (planeHeight + 3) +
                                     std::size_t{2} * lookupLanes);
    for (std::uint32_t& texel : plane)
        texel = static_cast<std::uint32_t>(random.next()) | (isOpaque ? 0xFF000000U : 0U);
    return plane;
}

/// The warps of two rows of nodes: waves of this planeHeight, longer than a texel, so that neighbours move
/// unlike each other.
struct WavyWarp
{
    explicit WavyWarp(float size)
    {
        Random random(7);
        for (auto& row : rows) {
            row.resize(planeWidth + lookupLanes);
            const double phase = random.between(0, 6);
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i] = size * static_cast<float>(std::sin(0.3 * static_cast<double>(i) + phase));
        }
    }
    WarpRows at(int x) const { return {{&rows[0][x], &rows[1][x]}, {&rows[2][x], &rows[3][x]}, 0.3F}; }

    std::array<std::vector<float>, 4> rows;
};

std::array<int, 4> plainLookup(const std::uint32_t* plane, float x, float y, std::int32_t& place)
{
    x = std::clamp(x, 0.0F, static_cast<float>(planeWidth - 1));
    y = std::clamp(y, 0.0F, static_cast<float>(planeHeight - 1));
    const auto left = static_cast<int>(x);
    const auto top = static_cast<int>(y);
    place = top * planeStride + left;
    const auto weightsAt = [](float part) {
        const CubicWeights weights = cubicWeights(part);
        return std::array{weights.w0, weights.w1, weights.w2, weights.w3};
    };
    const auto across = weightsAt(x - static_cast<float>(left));
    const auto down = weightsAt(y - static_cast<float>(top));
    std::array<int, 4> bytes{};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        double sum = 0;
        for (int tap = 0; tap < 16; ++tap) {
            const std::uint32_t texel = plane[place + (tap / 4 - 1) * planeStride + tap % 4 - 1];
            sum += static_cast<double>(across[static_cast<std::size_t>(tap % 4)]) *
                   static_cast<double>(down[static_cast<std::size_t>(tap / 4)]) *
                   (texel >> (8 * channel) & 255U);
        }
        bytes[channel] = static_cast<int>(std::clamp(sum + 0.5, 0.0, 255.0));
    }
    return bytes;
}

TEST(LookUpRow, GivesCubicSumsHoweverNeighboursMove)
{
    for (const bool isOpaque : {true, false}) {
        const auto texels = noisyPlane(isOpaque);
        const std::uint32_t* plane = texels.data() + planeStride + 1;
        int rounded = 0;
        int looked = 0;
        for (const float size : {0.0F, 0.4F, 1.5F, 9.0F, 60.0F}) {
            const WavyWarp rows(size);
            for (int y = 0; y < planeHeight; ++y) {
                const int x = 7 * y % 40;
                const int count = std::min(lookupsAtOnce, y < 20 ? 1 + 3 * y : planeWidth - x);
                const RowLookup lookup{.plane = plane,
                                       .isOpaque = isOpaque,
                                       .stride = planeStride,
                                       .lastX = planeWidth - 1,
                                       .lastY = planeHeight - 1,
                                       .x = x,
                                       .y = y,
                                       .count = count};
                const WarpRows warp = rows.at(x);
                alignas(64) std::array<std::int32_t, lookupsAtOnce> places;
                alignas(64) std::array<std::uint32_t, lookupsAtOnce> found;
                lookUpRow(lookup, warp, places.data(), found.data());
                for (int i = 0; i < count; ++i, ++looked) {
                    std::int32_t place = 0;
                    const auto at = [&](const float* const* of) {
                        return of[0][i] + warp.weight * (of[1][i] - of[0][i]);
                    };
                    const auto wanted = plainLookup(plane, static_cast<float>(x + i) + at(warp.x),
                                                    static_cast<float>(y) + at(warp.y), place);
                    ASSERT_EQ(places[static_cast<std::size_t>(i)], place)
                        << size << ", row " << y << ", texel " << i;
                    for (std::size_t channel = 0; channel < 4; ++channel) {
                        const int byte = found[static_cast<std::size_t>(i)] >> (8 * channel) & 255U;
                        ASSERT_NEAR(byte, wanted[channel], 1) << size << ", row " << y << ", texel " << i;
                        rounded += byte != wanted[channel] ? 1 : 0;
                    }
                }
            }
        }
        EXPECT_LT(rounded, looked / 500); // only where a sum lies on the edge between two bytes
    }
}

TEST(LookUpRow, TakesWarpsThatAreNoNumbers)
{
    const auto texels = noisyPlane(true);
    WavyWarp rows(0.4F);
    rows.rows[0][20] = std::numeric_limits<float>::quiet_NaN();
    rows.rows[2][40] = std::numeric_limits<float>::infinity();
    const RowLookup lookup{.plane = texels.data() + planeStride + 1,
                           .stride = planeStride,
                           .lastX = planeWidth - 1,
                           .lastY = planeHeight - 1,
                           .y = 3,
                           .count = 60};
    alignas(64) std::array<std::int32_t, lookupsAtOnce> places;
    alignas(64) std::array<std::uint32_t, lookupsAtOnce> found;
    lookUpRow(lookup, rows.at(0), places.data(), found.data());
    for (int i = 0; i < lookup.count; ++i) {
        const std::int32_t place = places[static_cast<std::size_t>(i)];
        EXPECT_TRUE(place >= 0 && place <= (planeHeight - 1) * planeStride + planeWidth - 1) << i;
    }
}

} // namespace
} // namespace quadrille
