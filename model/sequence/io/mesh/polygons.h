// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/sequence/topology.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace quadrille {

/// Gathers the corners of polygons and cuts them into fans of triangles from the first corner. Triangles that
/// name a vertex twice are left out.
class PolygonCollector
{
public:
    /// Stands for the UV of a corner that has none.
    static constexpr std::uint32_t noUv = 0xFFFFFFFF;

    /// Starts a polygon of a material.
    void begin(std::uint16_t material = 0)
    {
        m_vertices.clear();
        m_uvs.clear();
        m_material = material;
    }
    void add(std::uint32_t vertex, std::uint32_t uv = noUv)
    {
        m_vertices.push_back(vertex);
        m_uvs.push_back(uv);
    }
    std::size_t cornerCount() const { return m_vertices.size(); }
    /// Adds the triangles of the polygon, with their UVs and material.
    void end(TopologyData& topology);

    /// Gives corners without UV the origin, drops UVs and materials that say nothing, and reports polygons
    /// and triangles left out. \throws Error NoFaces.
    void finish(TopologyData& topology, const std::filesystem::path& file, std::vector<Issue>& issues) const;

private:
    std::vector<std::uint32_t> m_vertices;
    std::vector<std::uint32_t> m_uvs;
    std::uint16_t m_material = 0;
    std::int64_t m_polygonCount = 0; ///< with more than three corners
    std::int64_t m_leftOutCount = 0;
};

} // namespace quadrille
