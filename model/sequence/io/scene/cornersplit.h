// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <cstdint>
#include <vector>

namespace quadrille {

/// Vertices with one texture coordinate each, as glTF and graphics cards need them.
struct CornerSplit
{
    std::vector<std::uint32_t> vertexOf; ///< per split vertex its vertex; ascending
    std::vector<std::uint32_t> uvOf;     ///< per split vertex its texture coordinate; empty without
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Splits vertices at the seams of their texture coordinates; vertices of no triangle stay. Cost: O(n log n).
CornerSplit splitCorners(const TopologyData& topology);

} // namespace quadrille
