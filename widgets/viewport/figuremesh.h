// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille::widgets {

/// What stays the same from frame to frame of a figure.
struct FigureMesh
{
    std::uint32_t vertexCount = 0;
    /// Corners, counter-clockwise seen from outside.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Texture coordinates, origin at the lower left; empty without UVs.
    std::vector<std::array<float, 2>> uvs;
    /// Per triangle, the indices of its corners' UVs; as many as triangles, or empty.
    std::vector<std::array<std::uint32_t, 3>> triangleUvs;
    /// Per triangle the index of its material; empty when all have material 0.
    std::vector<std::uint16_t> triangleMaterials;

    bool hasUvs() const { return !triangleUvs.empty(); }
    int materialCount() const;
};

/// Vertices as the graphics card wants them: one per pair of vertex and UV, so that seams have both UVs.
struct SplitMesh
{
    std::vector<std::uint32_t> source;                   ///< per split vertex its vertex in the figure
    std::vector<std::array<float, 2>> uvs;               ///< per split vertex; empty without UVs
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< into the split vertices
};

/// Splits the vertices at UV seams; each vertex without triangles stays once.
/// \pre the indices of the mesh are inside its arrays.
SplitMesh splitAtSeams(const FigureMesh& mesh);

/// Area-weighted vertex normals over the figure's own vertices, so that UV seams do not show.
/// \param positions  vertices × 3. \param normals  vertices × 3, written; zero for unused vertices.
void computeNormals(const FigureMesh& mesh, std::span<const float> positions, std::span<float> normals);

/// Writes per split vertex the three values of its source vertex.
void spread(const SplitMesh& split, std::span<const float> perVertex, std::span<float> perSplitVertex);

} // namespace quadrille::widgets
