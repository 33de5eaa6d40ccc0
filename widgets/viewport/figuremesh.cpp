// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/figuremesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::widgets {

int FigureMesh::materialCount() const
{
    if (triangleMaterials.empty())
        return 1;
    return *std::max_element(triangleMaterials.begin(), triangleMaterials.end()) + 1;
}

SplitMesh splitAtSeams(const FigureMesh& mesh)
{
    SplitMesh split;
    split.source.resize(mesh.vertexCount);
    for (std::uint32_t v = 0; v < mesh.vertexCount; ++v)
        split.source[v] = v;
    if (!mesh.hasUvs()) {
        split.triangles = mesh.triangles;
        return split;
    }
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    split.uvs.assign(mesh.vertexCount, {0.0F, 0.0F});
    split.triangles.resize(mesh.triangles.size());
    // Each vertex heads a list of its split copies, linked by `next`; two UVs of one value count as one.
    std::vector<std::uint32_t> next(mesh.vertexCount, none);
    std::vector<char> used(mesh.vertexCount, 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[t][corner];
            const auto& uv = mesh.uvs[mesh.triangleUvs[t][corner]];
            if (!used[vertex]) {
                used[vertex] = 1;
                split.uvs[vertex] = uv;
            }
            std::uint32_t copy = vertex;
            while (split.uvs[copy] != uv && next[copy] != none)
                copy = next[copy];
            if (split.uvs[copy] != uv) {
                const auto added = static_cast<std::uint32_t>(split.source.size());
                next[copy] = added;
                next.push_back(none);
                split.source.push_back(vertex);
                split.uvs.push_back(uv);
                copy = added;
            }
            split.triangles[t][corner] = copy;
        }
    }
    return split;
}

void computeNormals(const FigureMesh& mesh, std::span<const float> positions, std::span<float> normals)
{
    std::fill(normals.begin(), normals.end(), 0.0F);
    for (const auto& triangle : mesh.triangles) {
        const float* a = &positions[std::size_t{3} * triangle[0]];
        const float* b = &positions[std::size_t{3} * triangle[1]];
        const float* c = &positions[std::size_t{3} * triangle[2]];
        const float u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const float v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        for (const std::uint32_t vertex : triangle) {
            float* sum = &normals[std::size_t{3} * vertex];
            sum[0] += n[0];
            sum[1] += n[1];
            sum[2] += n[2];
        }
    }
    for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
        const float squared =
            normals[i] * normals[i] + normals[i + 1] * normals[i + 1] + normals[i + 2] * normals[i + 2];
        const float scale = squared > 0.0F ? 1.0F / std::sqrt(squared) : 0.0F;
        normals[i] *= scale;
        normals[i + 1] *= scale;
        normals[i + 2] *= scale;
    }
}

void spread(const SplitMesh& split, std::span<const float> perVertex, std::span<float> perSplitVertex)
{
    for (std::size_t i = 0; i < split.source.size(); ++i)
        std::copy_n(&perVertex[std::size_t{3} * split.source[i]], 3, &perSplitVertex[3 * i]);
}

} // namespace quadrille::widgets
