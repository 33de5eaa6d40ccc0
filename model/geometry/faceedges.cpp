// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/faceedges.h"

#include "model/geometry/indices.h"

#include <algorithm>
#include <unordered_map>

namespace quadrille {

namespace {

std::uint64_t edgeKey(std::uint32_t from, std::uint32_t to)
{
    return (std::uint64_t{from} << 32U) | to;
}

/// Half-edges by their two ends; those that occur twice count as none.
std::unordered_map<std::uint64_t, std::int32_t> halfEdgesByEnds(const FaceEdges& edges)
{
    std::unordered_map<std::uint64_t, std::int32_t> found;
    found.reserve(edges.vertices.size());
    for (std::int32_t h = 0; h < edges.count(); ++h) {
        const auto [place, isNew] = found.try_emplace(edgeKey(edges.from(h), edges.to(h)), h);
        if (!isNew)
            place->second = -1;
    }
    return found;
}

} // namespace

FaceEdges faceEdges(const Topology& topology, bool joinsFans)
{
    std::vector<std::vector<std::uint32_t>> faces;
    for (const Triangle& t : topology.triangles()) {
        const bool joins = joinsFans && !faces.empty() && faces.back().front() == t[0].value &&
                           faces.back().back() == t[1].value &&
                           std::ranges::find(faces.back(), t[2].value) == faces.back().end();
        if (joins)
            faces.back().push_back(t[2].value);
        else
            faces.push_back({t[0].value, t[1].value, t[2].value});
    }
    FaceEdges edges;
    for (const auto& face : faces) {
        const auto first = static_cast<std::int32_t>(edges.vertices.size());
        const auto size = static_cast<std::int32_t>(face.size());
        for (std::int32_t k = 0; k < size; ++k) {
            edges.vertices.push_back(face[at(k)]);
            edges.next.push_back(first + (k + 1) % size);
            edges.previous.push_back(first + (k + size - 1) % size);
            edges.face.push_back(static_cast<std::int32_t>(edges.faceSizes.size()));
        }
        edges.faceSizes.push_back(size);
    }
    const auto byEnds = halfEdgesByEnds(edges);
    for (std::int32_t h = 0; h < edges.count(); ++h) {
        const auto found = byEnds.find(edgeKey(edges.to(h), edges.from(h)));
        const auto own = byEnds.find(edgeKey(edges.from(h), edges.to(h)));
        edges.twin.push_back(found == byEnds.end() || own->second < 0 ? -1 : found->second);
    }
    return edges;
}

bool reversesFaces(const FaceEdges& edges, const std::vector<VertexIndex>& opposite)
{
    const auto byEnds = halfEdgesByEnds(edges);
    for (std::int32_t h = 0; h < edges.count(); ++h) {
        const auto imageOf = [&](std::int32_t e) {
            const auto found =
                byEnds.find(edgeKey(opposite[edges.to(e)].value, opposite[edges.from(e)].value));
            return found == byEnds.end() ? -1 : found->second;
        };
        const std::int32_t image = imageOf(h);
        const std::int32_t imageOfNext = imageOf(edges.next[at(h)]);
        if (image < 0 || imageOfNext < 0 || imageOfNext != edges.previous[at(image)])
            return false;
    }
    return true;
}

} // namespace quadrille
