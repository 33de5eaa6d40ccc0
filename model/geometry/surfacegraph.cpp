// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/surfacegraph.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>

namespace quadrille {

namespace {

constexpr float degree = 0.017453293F;
constexpr float leastCrease = 15 * degree;
constexpr float fullCrease = 60 * degree;

/// Twice the area, along the normal.
Vec3f areaVector(const Triangle& t, Positions pose)
{
    return (pose[t[1].value] - pose[t[0].value]).cross(pose[t[2].value] - pose[t[0].value]);
}

/// How much the surface bends at an edge of two triangles.
float creaseBetween(const Vec3f& one, const Vec3f& two)
{
    const float angle = std::atan2(one.cross(two).norm(), one.dot(two));
    return std::clamp((angle - leastCrease) / (fullCrease - leastCrease), 0.0F, 1.0F);
}

} // namespace

SurfaceGraph::SurfaceGraph(std::shared_ptr<const Topology> topology, Positions pose)
    : m_topology(std::move(topology)), m_pose(pose.begin(), pose.end()), m_around(*m_topology)
{
    m_areas.reserve(m_topology->triangles().size());
    for (const Triangle& t : m_topology->triangles())
        m_areas.push_back(areaVector(t, m_pose).norm() / 2);
    m_edgeStarts.push_back(0);
    for (std::uint32_t v = 0; v < vertexCount(); ++v) {
        addEdgesOf(VertexIndex(v));
        m_edgeStarts.push_back(static_cast<std::uint32_t>(m_edges.size()));
    }
    double sum = 0;
    for (const Edge& edge : m_edges)
        sum += static_cast<double>(edge.length);
    m_meanEdge = static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(1, m_edges.size())));
}

void SurfaceGraph::addEdgesOf(VertexIndex v)
{
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t t : trianglesOf(v)) {
        for (const VertexIndex corner : m_topology->triangles()[t]) {
            if (corner != v)
                ends.push_back(corner.value);
        }
    }
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (const std::uint32_t to : ends) {
        std::vector<Vec3f> normals;
        for (const std::uint32_t t : trianglesOf(v)) {
            if (hasCorner(m_topology->triangles()[t], VertexIndex(to)))
                normals.push_back(areaVector(m_topology->triangles()[t], m_pose));
        }
        m_edges.push_back({to, (m_pose[to] - m_pose[v.value]).norm(),
                           normals.size() == 2 ? creaseBetween(normals[0], normals[1]) : 0});
    }
}

bool SurfaceGraph::haveEdge(VertexIndex a, VertexIndex b) const
{
    return std::ranges::binary_search(edgesOf(a), b.value, {}, &Edge::to);
}

VertexIndex nearestVertex(const SurfaceGraph& graph, TriangleIndex triangle, const Vec3f& weights)
{
    const Triangle& t = graph.topology().triangles()[triangle.value];
    Vec3f point = Vec3f::Zero();
    for (std::size_t c = 0; c < 3; ++c)
        point += weights[static_cast<Eigen::Index>(c)] * graph.pose()[t[c].value];
    return *std::ranges::min_element(
        t, {}, [&](VertexIndex v) { return (graph.pose()[v.value] - point).squaredNorm(); });
}

std::optional<VertexIndex> nearestCrease(const SurfaceGraph& graph, VertexIndex from, double radius)
{
    // Half of a full crease is one that can be seen.
    constexpr float visible = 0.5F;
    std::vector<bool> done(graph.vertexCount());
    using Reached = std::pair<double, std::uint32_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    queue.emplace(0, from.value);
    while (!queue.empty()) {
        const auto [distance, v] = queue.top();
        queue.pop();
        if (done[v])
            continue;
        done[v] = true;
        const auto edges = graph.edgesOf(VertexIndex(v));
        if (std::ranges::any_of(edges, [&](const SurfaceGraph::Edge& e) { return e.crease >= visible; }))
            return VertexIndex(v);
        for (const SurfaceGraph::Edge& edge : edges) {
            if (const double there = distance + static_cast<double>(edge.length); there <= radius)
                queue.emplace(there, edge.to);
        }
    }
    return std::nullopt;
}

} // namespace quadrille
