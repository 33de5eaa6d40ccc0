// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/blendkernels.h"

#include "model/core/simd.h"

#include <algorithm>
#include <cstddef>

namespace quadrille {

namespace {

/// Four poses are read for each time that the sum is; a block of it stays in the first cache.
QUADRILLE_SIMD_CLONES
void addFour(const float* a, const float* b, const float* c, const float* d, const float* weights, float* out,
             std::size_t count)
{
    const float wa = weights[0];
    const float wb = weights[1];
    const float wc = weights[2];
    const float wd = weights[3];
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i)
        out[i] += wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i];
}

} // namespace

void addPoses(std::span<const WeightedPose> poses, std::span<float> out)
{
    constexpr std::size_t block = 2048;
    for (std::size_t from = 0; from < out.size(); from += block) {
        const std::size_t count = std::min(block, out.size() - from);
        std::fill_n(out.data() + from, count, 0.0F);
        for (std::size_t p = 0; p < poses.size(); p += 4) {
            // Where fewer are left the first of them counts with a weight of 0.
            float weights[4]{};
            const float* values[4];
            for (std::size_t i = 0; i < 4; ++i) {
                const bool isThere = p + i < poses.size();
                values[i] = poses[isThere ? p + i : p].values + from;
                weights[i] = isThere ? poses[p + i].weight : 0;
            }
            addFour(values[0], values[1], values[2], values[3], weights, out.data() + from, count);
        }
    }
}

} // namespace quadrille
