// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <array>
#include <optional>
#include <vector>

namespace quadrille {

/// The volume that a surface encloses, in one pose after the other. Openings are closed by fans from the
/// middles of their rims. Refers to the topology.
class SurfaceVolume
{
public:
    explicit SurfaceVolume(const Topology& topology);

    /// Whether the surface has an inside: no edge with more than two triangles, or with two that turn
    /// opposite ways.
    bool isAvailable() const { return m_isAvailable; }
    /// Signed, m³; nothing where it is not available.
    std::optional<double> of(Positions pose) const;

private:
    /// From, to: as they run around the opening, seen from outside.
    using RimEdge = std::array<std::uint32_t, 2>;

    const Topology* m_topology;
    bool m_isAvailable = true;
    std::vector<std::vector<RimEdge>> m_openings;
};

} // namespace quadrille
