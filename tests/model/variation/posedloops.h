// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/posespread.h"
#include "tests/model/variation/latentloops.h"

#include <optional>

namespace quadrille::test {

/// Sequences that run once around and a model of their poses, which follow the latents smoothly.
struct PosedLoops
{
    LatentLoops loops;
    RowMatrix rows; ///< centred
    GpdmDynamics dynamics;
    PoseSpread poses;

    /// \param takes  how many of the sequences were captured; all by default.
    PosedLoops(Eigen::Index sequences, Eigen::Index frames, std::optional<std::size_t> takes = {})
        : PosedLoops(latentLoops(sequences, frames), takes)
    {
    }
    explicit PosedLoops(LatentLoops given, std::optional<std::size_t> takes = {}, Eigen::Index vertices = 12)
        : loops(std::move(given))
        , rows(posesOf(loops.state.latents, 3 * vertices))
        , dynamics(loops.state, loops.spans)
        , poses(loops.state, rows,
                std::span<const RowSpan>(loops.spans).first(takes.value_or(loops.spans.size())), vertices)
    {
    }

    PoseReconstruction reconstruction() const
    {
        return {loops.state, rows, Eigen::RowVectorXd::Zero(rows.cols())};
    }

private:
    static RowMatrix posesOf(const RowMatrix& latents, Eigen::Index coordinates)
    {
        RowMatrix poses = 0.2 * (0.5 * latents * normals(latents.cols(), coordinates, 11)).array().sin();
        poses.rowwise() -= poses.colwise().mean().eval();
        return poses;
    }
};

} // namespace quadrille::test
