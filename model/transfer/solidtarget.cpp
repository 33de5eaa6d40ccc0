// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/solidtarget.h"

#include "model/core/error.h"
#include "model/geometry/pointtree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace quadrille {

namespace {

constexpr auto noVertex = std::numeric_limits<std::uint32_t>::max();

void check(const Topology& mesh, Positions positions)
{
    if (positions.size() != mesh.vertexCount()) {
        throw Error(ErrorCode::VertexCountMismatch,
                    {.values = {{"expected", std::to_string(mesh.vertexCount())},
                                {"found", std::to_string(positions.size())}}});
    }
    const auto bad = std::ranges::find_if(positions, [](const Vec3f& p) { return !p.allFinite(); });
    if (bad != positions.end())
        throw Error(ErrorCode::NonFiniteCoordinate,
                    {.values = {{"vertex", std::to_string(bad - positions.begin())}}});
}

/// Of each vertex the first one at the same place.
std::vector<std::uint32_t> firstAtPlace(Positions positions)
{
    const auto placeOf = [&](std::uint32_t v) {
        const Vec3f& p = positions[v];
        return std::tuple(p.x(), p.y(), p.z());
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(placeOf(a), a) < std::tuple(placeOf(b), b);
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool isSame = i > 0 && placeOf(order[i]) == placeOf(order[i - 1]);
        first[order[i]] = isSame ? first[order[i - 1]] : order[i];
    }
    return first;
}

} // namespace

SolidTarget::SolidTarget(const Topology& mesh, Positions positions)
{
    check(mesh, positions);
    weld(mesh, positions);
    bridge();
    attachLoose(positions);
}

std::optional<std::size_t> SolidTarget::triangleOf(TriangleIndex triangle) const
{
    if (triangle.value >= m_triangles.size() || m_triangles[triangle.value] < 0)
        return std::nullopt;
    return static_cast<std::size_t>(m_triangles[triangle.value]);
}

void SolidTarget::weld(const Topology& mesh, Positions positions)
{
    const std::vector<std::uint32_t> first = firstAtPlace(positions);
    TopologyData data;
    m_vertices.assign(positions.size(), noVertex);
    m_triangles.reserve(mesh.triangles().size());
    for (const Triangle& triangle : mesh.triangles()) {
        const std::array<std::uint32_t, 3> corners{first[triangle[0].value], first[triangle[1].value],
                                                   first[triangle[2].value]};
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
            m_triangles.push_back(-1);
            continue;
        }
        Triangle welded;
        for (std::size_t c = 0; c < 3; ++c) {
            std::uint32_t& vertex = m_vertices[corners[c]];
            if (vertex == noVertex) {
                vertex = static_cast<std::uint32_t>(m_positions.size());
                m_positions.push_back(positions[corners[c]]);
            }
            welded[c] = VertexIndex(vertex);
        }
        m_triangles.push_back(static_cast<std::int32_t>(data.triangles.size()));
        data.triangles.push_back(welded);
    }
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
        m_vertices[v] = m_vertices[first[v]];
    if (data.triangles.empty())
        throw Error(ErrorCode::NoFaces);
    data.vertexCount = static_cast<std::uint32_t>(m_positions.size());
    m_topology = std::make_shared<const Topology>(std::move(data));
}

void SolidTarget::bridge()
{
    const std::vector<std::int32_t>& components = m_topology->components();
    const auto count = static_cast<std::size_t>(m_topology->statistics().components);
    std::vector<double> areas(count, 0.0);
    for (const Triangle& t : m_topology->triangles()) {
        const Vec3f& at = m_positions[t[0].value];
        areas[static_cast<std::size_t>(components[t[0].value])] +=
            static_cast<double>((m_positions[t[1].value] - at).cross(m_positions[t[2].value] - at).norm());
    }
    const auto largest = std::ranges::max_element(areas) - areas.begin();
    std::vector<std::uint32_t> held;
    std::vector<Vec3f> places;
    for (std::uint32_t v = 0; v < components.size(); ++v) {
        if (components[v] == largest) {
            held.push_back(v);
            places.push_back(m_positions[v]);
        }
    }
    m_bridges.resize(count);
    m_bridges[static_cast<std::size_t>(largest)] = {held.front(), held.front()};
    if (count == 1)
        return;
    const PointTree tree(places);
    std::vector<float> distances(count, std::numeric_limits<float>::infinity());
    for (std::uint32_t v = 0; v < components.size(); ++v) {
        if (components[v] == largest)
            continue;
        const auto component = static_cast<std::size_t>(components[v]);
        const std::uint32_t onto = held[tree.nearest(m_positions[v])];
        const float distance = (m_positions[onto] - m_positions[v]).squaredNorm();
        if (distance < distances[component]) {
            distances[component] = distance;
            m_bridges[component] = {v, onto};
        }
    }
}

void SolidTarget::attachLoose(Positions positions)
{
    std::optional<PointTree> tree;
    for (std::uint32_t v = 0; v < m_vertices.size(); ++v) {
        if (m_vertices[v] != noVertex)
            continue;
        if (!tree)
            tree.emplace(m_positions);
        m_vertices[v] = tree->nearest(positions[v]);
        m_offsets.push_back({v, positions[v] - m_positions[m_vertices[v]]});
    }
}

} // namespace quadrille
