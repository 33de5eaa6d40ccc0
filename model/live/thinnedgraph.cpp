// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/thinnedgraph.h"

#include <algorithm>

namespace quadrille {

namespace {

/// \param stride  from one vertex that stays to the next.
MotionSpace thinnedSpace(const MotionSpace& space, std::size_t stride,
                         const std::shared_ptr<const Topology>& topology)
{
    const std::size_t vertices = space.vertexCount();
    MotionSpace thinned{.name = space.name,
                        .topology = topology,
                        .up = space.up,
                        .fps = space.fps,
                        .isCyclic = space.isCyclic,
                        .takes = {},
                        .weights = space.weights,
                        .references = {},
                        .parameters = space.parameters,
                        .map = space.map};
    for (const SpaceTake& take : space.takes) {
        SpaceTake& few = thinned.takes.emplace_back();
        few.name = take.name;
        few.steps = take.steps;
        few.seconds = take.seconds;
        for (std::size_t f = 0; f < take.steps.size(); ++f) {
            for (std::size_t v = 0; v < vertices; v += stride)
                few.poses.push_back(take.poses[f * vertices + v]);
        }
    }
    thinned.references.resize(space.references.size());
    for (SpaceReference& reference : thinned.references)
        reference.starts.assign(space.frameCount() + 1, 0);
    return thinned;
}

} // namespace

std::shared_ptr<const LiveGraph> thinnedGraph(const LiveGraph& graph, std::size_t mostVertices)
{
    const std::size_t vertices = graph.vertexCount();
    const std::size_t stride = std::max<std::size_t>(1, (vertices + mostVertices - 1) / mostVertices);
    TopologyData points;
    points.vertexCount = static_cast<std::uint32_t>((vertices + stride - 1) / stride);
    points.triangles = {{VertexIndex(0), VertexIndex(0), VertexIndex(0)}}; // nothing is shown of it
    const auto topology = std::make_shared<const Topology>(std::move(points));
    auto thinned = std::make_shared<LiveGraph>(LiveGraph{graph.fps, {}, graph.tables});
    for (const auto& space : graph.spaces)
        thinned->spaces.push_back(
            std::make_shared<const MotionSpace>(thinnedSpace(*space, stride, topology)));
    return thinned;
}

} // namespace quadrille
