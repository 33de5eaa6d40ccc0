// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

struct HalfEdges;

/// The three corners of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<VertexIndex, 3>;

/// What a topology is made from. Polygons come fan-triangulated from their first corner.
struct TopologyData
{
    std::uint32_t vertexCount = 0;
    std::vector<Triangle> triangles;
    /// Texture coordinates, origin at the lower left; empty without UVs.
    std::vector<Vec2f> uvs;
    /// Per triangle, the indices of its corners' UVs; as many as triangles, or empty.
    std::vector<std::array<std::uint32_t, 3>> triangleUvs;
    /// Material names; empty when the source has none.
    std::vector<std::string> materials;
    /// Per triangle an index into `materials`; empty when all triangles have the first.
    std::vector<std::uint16_t> triangleMaterials;

    bool operator==(const TopologyData&) const = default;
};

/// How a surface hangs together.
struct TopologyStatistics
{
    std::int64_t components = 0; ///< connected by shared vertices; unused vertices not counted
    std::int64_t edges = 0;
    std::int64_t boundaryEdges = 0; ///< with one triangle
    std::int64_t boundaryLoops = 0;
    std::int64_t nonManifoldEdges = 0; ///< with more than two triangles
    std::int64_t nonManifoldVertices = 0;
    std::int64_t unusedVertices = 0;
    std::int64_t eulerCharacteristic = 0; ///< used vertices − edges + triangles

    bool isClosed() const { return boundaryEdges == 0 && nonManifoldEdges == 0; }
};

/// The faces that all frames of a sequence share, immutable once built; shared between sequences.
class Topology
{
public:
    /// \param file names the source in errors.
    /// \throws Error NoVertices, NoFaces, IndexOutOfRange (a vertex, UV or material).
    explicit Topology(TopologyData data, const std::filesystem::path& file = {});
    ~Topology();
    Topology(const Topology&) = delete;
    Topology& operator=(const Topology&) = delete;

    const TopologyData& data() const { return m_data; }
    std::uint32_t vertexCount() const { return m_data.vertexCount; }
    const std::vector<Triangle>& triangles() const { return m_data.triangles; }
    bool hasUvs() const { return !m_data.triangleUvs.empty(); }
    const TopologyStatistics& statistics() const { return m_statistics; }
    bool isClosed() const { return m_statistics.isClosed(); }
    /// True when no two triangles share a vertex though there are several: an unwelded mesh.
    bool isPolygonSoup() const;
    /// Per vertex the zero-based connected component; −1 for unused vertices.
    const std::vector<std::int32_t>& components() const { return m_components; }
    /// Half-edge adjacency, built at the first call (thread-safe); see halfedges.h.
    const HalfEdges& halfEdges() const;

private:
    struct LazyHalfEdges;
    TopologyData m_data;
    TopologyStatistics m_statistics;
    std::vector<std::int32_t> m_components;
    std::unique_ptr<LazyHalfEdges> m_halfEdges;
};

} // namespace quadrille
