// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/lookupkernels.h"

#include "model/appearance/cubicweights.h"
#include "model/core/simd.h"

#include <cstddef>

namespace quadrille {

namespace {

using FourFloats = float __attribute__((vector_size(16), aligned(4), may_alias));

[[gnu::always_inline]] inline FourFloats fourAt(const float* values)
{
    return *reinterpret_cast<const FourFloats*>(values);
}

[[gnu::always_inline]] inline float within(float value, float most)
{
    value = value > 0 ? value : 0; // also what is no number
    return value < most ? value : most;
}

} // namespace

QUADRILLE_SIMD_CLONES
void lookUpSquares(const float* values, const SquareLookup* squares, int count, float* looked)
{
    for (int i = 0; i < count; ++i) {
        const SquareLookup& square = squares[i];
        const CubicWeights across = cubicWeights(square.x);
        const CubicWeights down = cubicWeights(square.y);
        const float* row0 = values + std::size_t{3} * square.rows[0];
        const float* row1 = values + std::size_t{3} * square.rows[1];
        const float* row2 = values + std::size_t{3} * square.rows[2];
        const float* row3 = values + std::size_t{3} * square.rows[3];
        // First the rows become one; of each texel's four values the last is the next texel's.
        const auto column = [&](int c) {
            return down.w0 * fourAt(row0 + c) + down.w1 * fourAt(row1 + c) + down.w2 * fourAt(row2 + c) +
                   down.w3 * fourAt(row3 + c);
        };
        const FourFloats sum =
            across.w0 * column(0) + across.w1 * column(3) + across.w2 * column(6) + across.w3 * column(9);
        float* to = looked + std::size_t{3} * square.to;
        to[0] = sum[0];
        to[1] = sum[1];
        to[2] = sum[2];
    }
}

QUADRILLE_SIMD_CLONES
void undoWarp(const float* nodes, const WarpGrid& grid, const float* x, int y, int count, const float* wanted,
              float* found)
{
    constexpr int iterations = 12; // each leaves as much of the error as the warp stretches
    constexpr int lanes = 16;
    constexpr float enough = 1e-6F;
    const float nodesPerTexel = 1.0F / static_cast<float>(grid.spacing);
    const auto lastColumn = static_cast<float>(grid.width - 1);
    const auto lastRow = static_cast<float>(grid.height - 1);
    const int width = grid.width;
    // The last node is left to the cell before it; grids of one column or row have none.
    const int lastLeft = width > 1 ? width - 2 : 0;
    const int lastTop = grid.height > 1 ? grid.height - 2 : 0;
    const int right = width > 1 ? 2 : 0;
    const int below = grid.height > 1 ? 2 * width : 0;
    const auto row = static_cast<float>(y);
    for (int done = 0; done < count; done += lanes, x += lanes, found += std::ptrdiff_t{2} * lanes) {
        const int some = count - done < lanes ? count - done : lanes;
        alignas(64) float fromX[lanes] = {};
        alignas(64) float wantedX[lanes] = {};
        alignas(64) float wantedY[lanes] = {};
        alignas(64) float foundX[lanes] = {};
        alignas(64) float foundY[lanes] = {};
        alignas(64) std::int32_t isMoving[lanes];
        for (int i = 0; i < lanes; ++i) {
            fromX[i] = i < some ? x[i] : 0.0F;
            isMoving[i] = i < some ? 1 : 0;
        }
        if (wanted != nullptr) {
            const float* next = wanted + std::ptrdiff_t{2} * done;
            for (int i = 0; i < some; ++i, next += 2) {
                wantedX[i] = next[0];
                wantedY[i] = next[1];
            }
        }
        std::int32_t moving = 1;
        for (int iteration = 0; iteration < iterations && moving != 0; ++iteration) {
            moving = 0;
#pragma omp simd reduction(| : moving)
            for (int i = 0; i < lanes; ++i) {
                const float atX = within((fromX[i] + foundX[i]) * nodesPerTexel, lastColumn);
                const float atY = within((row + foundY[i]) * nodesPerTexel, lastRow);
                std::int32_t left = static_cast<std::int32_t>(atX);
                std::int32_t top = static_cast<std::int32_t>(atY);
                left = left < lastLeft ? left : lastLeft;
                top = top < lastTop ? top : lastTop;
                const float across = atX - static_cast<float>(left);
                const float down = atY - static_cast<float>(top);
                const std::int32_t at = 2 * (top * width + left);
                const float upperX = nodes[at] + across * (nodes[at + right] - nodes[at]);
                const float upperY = nodes[at + 1] + across * (nodes[at + right + 1] - nodes[at + 1]);
                const float lowerX =
                    nodes[at + below] + across * (nodes[at + below + right] - nodes[at + below]);
                const float lowerY =
                    nodes[at + below + 1] + across * (nodes[at + below + right + 1] - nodes[at + below + 1]);
                const float newX = wantedX[i] - (upperX + down * (lowerX - upperX));
                const float newY = wantedY[i] - (upperY + down * (lowerY - upperY));
                const float moveX = newX - foundX[i];
                const float moveY = newY - foundY[i];
                foundX[i] = isMoving[i] != 0 ? newX : foundX[i];
                foundY[i] = isMoving[i] != 0 ? newY : foundY[i];
                const std::int32_t goesOn = moveX * moveX + moveY * moveY < enough ? 0 : 1;
                isMoving[i] &= goesOn;
                moving |= isMoving[i];
            }
        }
        for (std::ptrdiff_t i = 0; i < some; ++i) {
            found[2 * i] = foundX[i];
            found[2 * i + 1] = foundY[i];
        }
    }
}

} // namespace quadrille
