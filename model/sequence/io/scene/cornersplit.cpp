// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/cornersplit.h"

#include <algorithm>
#include <numeric>

namespace quadrille {

CornerSplit splitCorners(const TopologyData& topology)
{
    CornerSplit split;
    const auto& triangles = topology.triangles;
    split.triangles.resize(triangles.size());
    if (topology.triangleUvs.empty()) {
        split.vertexOf.resize(topology.vertexCount);
        std::iota(split.vertexOf.begin(), split.vertexOf.end(), 0U);
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (std::size_t c = 0; c < 3; ++c)
                split.triangles[t][c] = triangles[t][c].value;
        return split;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // vertex, texture coordinate
    std::vector<bool> isUsed(topology.vertexCount, false);
    pairs.reserve(triangles.size() * 3);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            pairs.emplace_back(triangles[t][c].value, topology.triangleUvs[t][c]);
            isUsed[triangles[t][c].value] = true;
        }
    }
    for (std::uint32_t v = 0; v < topology.vertexCount; ++v)
        if (!isUsed[v])
            pairs.emplace_back(v, 0);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [vertex, uv] : pairs) {
        split.vertexOf.push_back(vertex);
        split.uvOf.push_back(uv);
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::pair wanted(triangles[t][c].value, topology.triangleUvs[t][c]);
            const auto found = std::lower_bound(pairs.begin(), pairs.end(), wanted);
            split.triangles[t][c] = static_cast<std::uint32_t>(found - pairs.begin());
        }
    }
    return split;
}

} // namespace quadrille
