// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/blendedges.h"

namespace quadrille {

bool BlendEdge::isBetween(const std::string& one, const std::string& other) const
{
    return (from == one && to == other) || (from == other && to == one);
}

std::vector<BlendEdge> edgesOf(const BlendEntry& blend)
{
    std::vector<BlendEdge> edges{{blend.from, blend.to, blend.weights}};
    if (const auto& across = blend.across) {
        edges.push_back({across->from, across->to, blend.weights});
        edges.push_back({blend.from, across->from, across->weights});
        edges.push_back({blend.to, across->to, across->weights});
    }
    return edges;
}

} // namespace quadrille
