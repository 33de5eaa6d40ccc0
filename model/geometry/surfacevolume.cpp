// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/surfacevolume.h"

#include "model/geometry/procrustes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

namespace quadrille {

namespace {

struct Edge
{
    int triangles = 0;
    int turns = 0; ///< how often from the lower to the higher vertex, less how often back
};

std::map<std::array<std::uint32_t, 2>, Edge> edgesOf(const Topology& topology)
{
    std::map<std::array<std::uint32_t, 2>, Edge> edges;
    for (const Triangle& triangle : topology.triangles()) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = triangle[c].value;
            const std::uint32_t b = triangle[(c + 1) % 3].value;
            if (a == b)
                continue;
            Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
            ++edge.triangles;
            edge.turns += a < b ? 1 : -1;
        }
    }
    return edges;
}

} // namespace

SurfaceVolume::SurfaceVolume(const Topology& topology) : m_topology(&topology)
{
    // Rims that meet at a vertex count as one.
    std::map<std::uint32_t, std::vector<RimEdge>> rims;
    for (const auto& [ends, edge] : edgesOf(topology)) {
        if (edge.triangles > 2 || (edge.triangles == 2 && edge.turns != 0))
            m_isAvailable = false;
        if (edge.triangles != 1)
            continue;
        const RimEdge rim = edge.turns > 0 ? RimEdge{ends[1], ends[0]} : RimEdge{ends[0], ends[1]};
        rims[rim[0]].push_back(rim);
    }
    while (!rims.empty()) {
        std::vector<std::uint32_t> reached{rims.begin()->first};
        std::vector<RimEdge>& opening = m_openings.emplace_back();
        while (!reached.empty()) {
            const auto next = rims.find(reached.back());
            reached.pop_back();
            if (next == rims.end())
                continue;
            for (const RimEdge& edge : next->second) {
                opening.push_back(edge);
                reached.push_back(edge[1]);
            }
            rims.erase(next);
        }
    }
}

std::optional<double> SurfaceVolume::of(Positions pose) const
{
    if (!m_isAvailable)
        return std::nullopt;
    const Vec3d centre = centroid(pose);
    const auto at = [&](std::uint32_t v) -> Vec3d { return pose[v].cast<double>() - centre; };
    double sum = 0;
    for (const auto& [a, b, c] : m_topology->triangles())
        sum += at(a.value).dot(at(b.value).cross(at(c.value)));
    for (const std::vector<RimEdge>& opening : m_openings) {
        Vec3d middle = Vec3d::Zero();
        Vec3d areas = Vec3d::Zero();
        for (const auto& [from, to] : opening) {
            middle += at(from);
            areas += at(from).cross(at(to));
        }
        sum += areas.dot(middle) / static_cast<double>(opening.size());
    }
    return sum / 6;
}

} // namespace quadrille
