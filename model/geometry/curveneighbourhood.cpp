// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/curveneighbourhood.h"

#include "model/geometry/surfacedistances.h"

namespace quadrille {

std::optional<CurveNeighbourhood> neighbourhoodOf(const SurfaceGraph& graph,
                                                  std::span<const VertexIndex> curve, float limit)
{
    const auto sides = curveSides(graph.topology(), graph.around(), curve);
    if (!sides)
        return std::nullopt;
    SurfaceDistances distances(graph);
    for (const VertexIndex v : curve)
        distances.add({v, 0}, 0);
    distances.growTo(limit);
    std::vector<float> offsets(graph.vertexCount());
    std::array<VertexIndex, 2> ends{curve[0], curve[0]};
    for (std::uint32_t v = 0; v < graph.vertexCount(); ++v) {
        const VertexIndex vertex(v);
        offsets[v] = distances.at({vertex, 0});
        if (graph.trianglesOf(vertex).empty())
            continue;
        const bool isRight = (*sides)[graph.trianglesOf(vertex).front()] == TriangleSide::Right;
        VertexIndex& end = ends[isRight ? 1 : 0];
        if (std::isfinite(offsets[v]) && offsets[v] > std::abs(offsets[end.value]))
            end = vertex;
        if (isRight)
            offsets[v] = -offsets[v];
    }
    if (offsets[ends[0].value] == 0 || offsets[ends[1].value] == 0)
        return std::nullopt;
    std::array<double, 2> areas{};
    for (std::uint32_t t = 0; t < sides->size(); ++t) {
        if ((*sides)[t] != TriangleSide::Elsewhere)
            areas[(*sides)[t] == TriangleSide::Left ? 0 : 1] +=
                static_cast<double>(graph.area(TriangleIndex(t)));
    }
    CrossCut cut(graph, fewestEdges(graph, ends[0], ends[1]));
    return CurveNeighbourhood{std::move(offsets), ends, areas, std::move(cut)};
}

} // namespace quadrille
