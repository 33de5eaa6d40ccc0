// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/random.h"
#include "model/variation/gpdm/gpdm.h"

#include <cmath>

namespace quadrille::test {

/// Latent positions that a model could have learned: sequences that run once around, each a little different.
struct LatentLoops
{
    GpdmState state;
    std::vector<RowSpan> spans;

    RowMatrix trajectory(std::size_t sequence) const
    {
        return state.latents.middleRows(spans[sequence].first, spans[sequence].count);
    }
};

inline LatentLoops latentLoops(Eigen::Index sequences, Eigen::Index frames, int dimensions = 3)
{
    LatentLoops loops;
    loops.state.latents.resize(sequences * frames, dimensions);
    for (Eigen::Index s = 0; s < sequences; ++s) {
        loops.spans.push_back({s * frames, frames});
        for (Eigen::Index f = 0; f < frames; ++f) {
            const double angle = 6.1 * static_cast<double>(f) / static_cast<double>(frames);
            const double size = 1.2 + 0.15 * static_cast<double>(s);
            for (int d = 0; d < dimensions; ++d)
                loops.state.latents(s * frames + f, d) =
                    size * std::sin(angle * (d < 2 ? 1 : 2) + 1.57 * d + 0.1 * static_cast<double>(s * d));
        }
    }
    loops.state.hyperparameters = {
        .alpha1 = 0.05, .alpha3 = 2e4, .beta1 = 0.8, .beta2 = 0.7, .beta3 = 0.02, .beta4 = 4e4};
    return loops;
}

inline RowMatrix normals(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed)
{
    Random random(seed);
    RowMatrix values(rows, columns);
    for (double& value : values.reshaped<Eigen::RowMajor>())
        value = random.normal();
    return values;
}

} // namespace quadrille::test
