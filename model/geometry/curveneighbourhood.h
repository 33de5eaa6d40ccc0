// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/crosscut.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// What a closed curve surrounds, and how the surface is opened along it.
struct CurveNeighbourhood
{
    /// Of each vertex its distance from the curve over the surface, metres, negative on the right; infinite
    /// beyond the limit and where no way leads.
    std::vector<float> offsets;
    /// Farthest from the curve within the limit on the left and on the right.
    std::array<VertexIndex, 2> ends;
    /// Areas on the left and on the right, square metres.
    std::array<double, 2> areas{};
    CrossCut cut; ///< from the one end to the other

    float depth(std::size_t side) const { return std::abs(offsets[ends[side].value]); }
};

/// Nothing where the curve does not part the surface, or has no vertices beside it. \param limit  how far
/// from the curve to look, metres.
std::optional<CurveNeighbourhood> neighbourhoodOf(const SurfaceGraph& graph,
                                                  std::span<const VertexIndex> curve,
                                                  float limit = std::numeric_limits<float>::infinity());

} // namespace quadrille
