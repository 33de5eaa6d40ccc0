// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/vertextriangles.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// The edges of a mesh in one pose, with what ways over the surface need: lengths, creases, neighbouring
/// triangles. Takes any topology (holes, several components, edges of more than two triangles). Immutable,
/// safe from any thread.
class SurfaceGraph
{
public:
    /// An edge as seen from one of its ends.
    struct Edge
    {
        std::uint32_t to;
        float length; ///< metres
        float crease; ///< 0 where the surface is flat or open, 1 where it bends by 60 degrees or more
    };

    /// \param pose  of all vertices, metres; copied.
    SurfaceGraph(std::shared_ptr<const Topology> topology, Positions pose);

    const Topology& topology() const { return *m_topology; }
    Positions pose() const { return m_pose; }
    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(m_pose.size()); }
    std::span<const Edge> edgesOf(VertexIndex v) const
    {
        return {m_edges.data() + m_edgeStarts[v.value], m_edgeStarts[v.value + 1] - m_edgeStarts[v.value]};
    }
    /// Indices of the triangles around a vertex, ascending.
    std::span<const std::uint32_t> trianglesOf(VertexIndex v) const { return m_around.of(v); }
    const VertexTriangles& around() const { return m_around; }
    bool haveEdge(VertexIndex a, VertexIndex b) const;
    /// Mean length of an edge, metres.
    float meanEdge() const { return m_meanEdge; }
    /// Square metres.
    float area(TriangleIndex triangle) const { return m_areas[triangle.value]; }

private:
    void addEdgesOf(VertexIndex v);

    std::shared_ptr<const Topology> m_topology;
    std::vector<Vec3f> m_pose;
    std::vector<std::uint32_t> m_edgeStarts;
    std::vector<Edge> m_edges; ///< of each vertex in ascending order of their other ends
    VertexTriangles m_around;
    std::vector<float> m_areas;
    float m_meanEdge = 0;
};

/// The corner of a triangle that is nearest to a point of it. \param weights  of the corners.
VertexIndex nearestVertex(const SurfaceGraph& graph, TriangleIndex triangle, const Vec3f& weights);

/// The vertex nearest over the surface at which a crease passes; nothing where there is none within the
/// radius. \param radius  metres over the edges.
std::optional<VertexIndex> nearestCrease(const SurfaceGraph& graph, VertexIndex from, double radius);

} // namespace quadrille
