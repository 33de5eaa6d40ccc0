// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm/gpdm.h"

#include <array>
#include <span>

namespace quadrille {

/// Which two of the learned blends a wanted one lies between, and their shares (CVS §7): the second one's is
/// 1 − share.
struct BlendNeighbours
{
    std::size_t first = 0; ///< in the learned weights
    std::size_t second = 0;
    double share = 1; ///< of the first

    bool operator==(const BlendNeighbours&) const = default;
};

/// \param learned  weights of the learned blends, 0, …, 1, ascending.
/// \throws Error BadArgument (a wanted weight outside of [0, 1], learned weights that do not ascend from 0
/// to 1).
BlendNeighbours blendNeighbours(std::span<const double> learned, double wanted);

/// A blend with two parameters: takes at the corners of a square, learned blends on a grid over it.
struct BlendCell
{
    BlendNeighbours across; ///< columns of the grid
    BlendNeighbours along;  ///< rows of the grid
    /// Shares of (first, first), (second, first), (first, second) and (second, second), in (across, along);
    /// they add up to 1.
    std::array<double, 4> shares() const;
};

/// \throws as blendNeighbours.
BlendCell blendCell(std::span<const double> learnedAcross, std::span<const double> learnedAlong,
                    double wantedAcross, double wantedAlong);

/// A trajectory and its share in a blend.
struct LatentShare
{
    RowMatrix latents; ///< reference frames × dimensions
    double share = 0;
};

/// A trajectory between others. \pre At least one; all have the same size.
RowMatrix latentBlend(std::span<const LatentShare> trajectories);

} // namespace quadrille
