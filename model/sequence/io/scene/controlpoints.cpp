// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/controlpoints.h"

#include "model/core/error.h"

#include <assimp/scene.h>
#include <cmath>
#include <map>
#include <optional>

namespace quadrille {

namespace {

/// Assimp reads numbers in text a little less exactly than the standard library.
bool isNear(float value, double expected)
{
    return std::abs(static_cast<double>(value) - expected) <= 1e-6 * std::abs(expected) + 1e-30;
}

/// Which control point each vertex of a node's meshes came from. Assimp makes one mesh per material, in the
/// order in which the polygons first use them, and one vertex per corner.
std::optional<std::vector<std::uint32_t>> controlPointsOf(const PolygonGeometry& geometry,
                                                          const aiScene& scene, const aiNode& node)
{
    std::size_t vertexCount = 0;
    std::vector<std::size_t> firstVertex;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        firstVertex.push_back(vertexCount);
        vertexCount += scene.mMeshes[node.mMeshes[m]]->mNumVertices;
    }
    if (vertexCount != geometry.polygonVertices.size())
        return std::nullopt;
    std::vector<std::uint32_t> pointOf(vertexCount);
    std::vector<std::size_t> used(node.mNumMeshes, 0);
    std::map<std::int32_t, std::size_t> meshOfMaterial;
    std::size_t polygon = 0;
    for (const std::int32_t index : geometry.polygonVertices) {
        const auto& materials = geometry.polygonMaterials;
        const std::int32_t material = materials.empty()            ? 0
                                      : polygon < materials.size() ? materials[polygon]
                                                                   : materials.front();
        const std::size_t m = meshOfMaterial.try_emplace(material, meshOfMaterial.size()).first->second;
        const auto point = static_cast<std::size_t>(index < 0 ? -1 - index : index);
        if (m >= node.mNumMeshes || point * 3 + 2 >= geometry.controlPoints.size())
            return std::nullopt;
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
        if (used[m] >= mesh.mNumVertices)
            return std::nullopt;
        const aiVector3D& position = mesh.mVertices[used[m]];
        const double* expected = geometry.controlPoints.data() + point * 3;
        if (!isNear(position.x, expected[0]) || !isNear(position.y, expected[1]) ||
            !isNear(position.z, expected[2]))
            return std::nullopt;
        pointOf[firstVertex[m] + used[m]++] = static_cast<std::uint32_t>(point);
        polygon += index < 0;
    }
    return pointOf;
}

/// Gives a mesh the control points' count and order; points without a polygon are added.
void useControlPoints(SceneMesh& mesh, const PolygonGeometry& geometry, std::vector<std::uint32_t> pointOf)
{
    const std::size_t count = geometry.controlPoints.size() / 3;
    std::vector<bool> isUsed(count, false);
    for (const std::uint32_t point : pointOf)
        isUsed[point] = true;
    for (std::size_t point = 0; point < count; ++point) {
        if (isUsed[point])
            continue;
        const double* p = geometry.controlPoints.data() + point * 3;
        mesh.positions.emplace_back(Vec3d(p[0], p[1], p[2]).cast<float>());
        pointOf.push_back(static_cast<std::uint32_t>(point));
    }
    const std::size_t vertices = mesh.positions.size();
    if (!mesh.uvs.empty())
        mesh.uvs.resize(vertices, Vec2f::Zero());
    if (!mesh.influences.empty())
        mesh.influences.resize(vertices);
    for (auto& target : mesh.morphTargets)
        target.resize(vertices, Vec3f::Zero());
    mesh.originalVertices = std::move(pointOf);
    mesh.originalVertexCount = static_cast<std::uint32_t>(count);
}

void collectMeshNodes(const aiNode& node, std::vector<const aiNode*>& nodes)
{
    if (node.mNumMeshes > 0)
        nodes.push_back(&node);
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        collectMeshNodes(*node.mChildren[c], nodes);
}

} // namespace

void checkCorners(const PolygonGeometry& geometry, const std::filesystem::path& file)
{
    const auto count = static_cast<std::int64_t>(geometry.controlPoints.size() / 3);
    for (const std::int32_t index : geometry.polygonVertices) {
        const auto point = std::int64_t{index < 0 ? -1 - index : index};
        if (point >= count) {
            throw Error(
                ErrorCode::IndexOutOfRange,
                {file,
                 {},
                 {{"what", "vertex"}, {"index", std::to_string(point)}, {"count", std::to_string(count)}}});
        }
    }
}

void restoreControlPoints(Scene& scene, const aiScene& source, std::span<const PolygonGeometry> geometries)
{
    std::vector<const aiNode*> nodes; // as sceneFromAssimp walks them
    if (source.mRootNode)
        collectMeshNodes(*source.mRootNode, nodes);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        for (const PolygonGeometry& geometry : geometries) {
            if (auto pointOf = controlPointsOf(geometry, source, *nodes[m])) {
                useControlPoints(scene.meshes[m], geometry, std::move(*pointOf));
                break;
            }
        }
    }
}

} // namespace quadrille
