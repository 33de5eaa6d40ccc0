// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/pictures/uvedges.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace quadrille {

namespace {

constexpr std::size_t reportInterval = 65536;

} // namespace

QList<QLineF> uvEdges(const Topology& topology, std::optional<int> material, const Progress& progress)
{
    const TopologyData& data = topology.data();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(data.triangleUvs.size() * 3);
    for (std::size_t t = 0; t < data.triangleUvs.size(); ++t) {
        if (t % reportInterval == 0)
            progress.report(static_cast<std::int64_t>(t), static_cast<std::int64_t>(data.triangleUvs.size()));
        const int own = data.triangleMaterials.empty() ? 0 : data.triangleMaterials[t];
        if (material.has_value() && *material != own)
            continue;
        const auto& corners = data.triangleUvs[t];
        for (std::size_t corner = 0; corner < 3; ++corner)
            edges.emplace_back(std::minmax(corners.at(corner), corners.at((corner + 1) % 3)));
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    QList<QLineF> lines;
    lines.reserve(static_cast<qsizetype>(edges.size()));
    for (const auto& [first, second] : edges) {
        const Vec2f& from = data.uvs[first];
        const Vec2f& to = data.uvs[second];
        lines += QLineF(from.x(), from.y(), to.x(), to.y());
    }
    return lines;
}

} // namespace quadrille
