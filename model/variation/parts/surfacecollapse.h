// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/parts/bodyparts.h"

#include <array>
#include <span>
#include <vector>

namespace quadrille {

/// How small triangles get in some poses and how far neighbours are folded onto each other, and how many go
/// beyond that in others, by region of the body: a foot that is crumpled is too little of it to change its
/// volume. Regions are slices of the parts, across the longest direction of each. Immutable.
class SurfaceCollapse
{
public:
    /// \param parts  none: the surface is one part. \param poses  that triangles may be as small and as
    /// folded as in; the first of them is sliced; at least one. \param slices  of each part.
    SurfaceCollapse(const Topology& topology, const BodyParts& parts, std::span<const Positions> poses,
                    int slices = 4);

    /// Of the worst region the share of its triangles that are smaller than half of the least, or folded by
    /// 60 degrees more than ever.
    double of(Positions pose) const;

private:
    struct Fold
    {
        std::array<std::uint32_t, 2> triangles{};
        double greatest = 0; ///< angle between their normals, radians
    };

    std::vector<std::array<VertexIndex, 3>> m_triangles;
    std::vector<double> m_leastAreas;
    std::vector<Fold> m_folds;
    std::vector<int> m_regions; ///< of each triangle
    std::vector<int> m_counts;  ///< triangles of each region
};

} // namespace quadrille
