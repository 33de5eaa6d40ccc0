// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poissonsystem.h"

#include <array>
#include <span>
#include <vector>

namespace quadrille {

/// How far the triangles of a surface stretch and shrink in some poses, and no further. Poses that are sums
/// of others, as those of learned models are, make limbs longer or shorter that lie between them or beyond;
/// what turns stays as it is.
class StretchRange
{
public:
    /// Lets everything be.
    StretchRange() = default;
    /// \param rest  of all vertices: the pose that stretches are relative to.
    /// \param poses  that span the range; it holds the rest pose as well.
    StretchRange(const Topology& topology, Positions rest, std::span<const Positions> poses);

    /// Brings the principal stretches of each triangle back into the range of its own; those inside keep
    /// their edges. \param edges  of all triangles.
    void restrict(std::span<TriangleEdges> edges) const;

private:
    struct Bounds
    {
        double least = 1;
        double greatest = 1;
    };
    /// Of the rest pose: v1 − v3 = (b11, 0), v2 − v3 = (b12, b22); b22 is 0 where a triangle has no area.
    std::vector<std::array<double, 3>> m_rest;
    std::vector<Bounds> m_bounds;
};

} // namespace quadrille
