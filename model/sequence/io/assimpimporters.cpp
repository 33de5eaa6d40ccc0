// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/sequence/io/assimpscene.h"
#include "model/sequence/io/fbxgeometry.h"
#include "model/sequence/io/scenesequences.h"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <cmath>
#include <map>

namespace quadrille {

namespace {

constexpr double metresPerCentimetre = 0.01;

const aiScene& readScene(Assimp::Importer& importer, const std::filesystem::path& file)
{
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    // Assimp 5.2 puts a node's whole motion, pre-rotation included, into one channel; with pivots kept as
    // nodes of their own the pre-rotation would count twice.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    // No post-processing: vertices stay in the order of the file's polygon corners.
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (!scene)
        throw Error(ErrorCode::FileSyntax, {file, {}, {{"reason", importer.GetErrorString()}}});
    return *scene;
}

/// Which control point each vertex of a node's meshes came from. Assimp makes one mesh per material, in the
/// order in which the polygons first use them, and one vertex per corner.
std::optional<std::vector<std::uint32_t>> controlPointsOf(const FbxGeometry& geometry, const aiScene& scene,
                                                          const aiNode& node)
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
        if (position.x != static_cast<float>(expected[0]) || position.y != static_cast<float>(expected[1]) ||
            position.z != static_cast<float>(expected[2]))
            return std::nullopt;
        pointOf[firstVertex[m] + used[m]++] = static_cast<std::uint32_t>(point);
        polygon += index < 0;
    }
    return pointOf;
}

/// Gives a mesh the control points' count and order; points without a polygon are added.
void useControlPoints(SceneMesh& mesh, const FbxGeometry& geometry, std::vector<std::uint32_t> pointOf)
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

void restoreControlPoints(Scene& scene, const aiScene& source, const std::filesystem::path& file)
{
    const auto geometries = readFbxGeometries(readFile(file).bytes());
    std::vector<const aiNode*> nodes; // as sceneFromAssimp walks them
    if (source.mRootNode)
        collectMeshNodes(*source.mRootNode, nodes);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        for (const FbxGeometry& geometry : geometries) {
            if (auto pointOf = controlPointsOf(geometry, source, *nodes[m])) {
                useControlPoints(scene.meshes[m], geometry, std::move(*pointOf));
                break;
            }
        }
    }
}

double metresPerUnit(const aiScene& source)
{
    double centimetres = 1;
    float asFloat = 1;
    if (source.mMetaData && !source.mMetaData->Get("UnitScaleFactor", centimetres) &&
        source.mMetaData->Get("UnitScaleFactor", asFloat))
        centimetres = static_cast<double>(asFloat);
    const bool isPossible = std::isfinite(centimetres) && centimetres > 0;
    return metresPerCentimetre * (isPossible ? centimetres : 1.0);
}

} // namespace

const FormatInfo& FbxImporter::format() const
{
    static const FormatInfo info{.id = "fbx", .name = "Autodesk FBX", .extensions = {".fbx"}};
    return info;
}

bool FbxImporter::recognises(std::string_view head) const
{
    return head.starts_with("Kaydara FBX Binary") || head.starts_with("; FBX ");
}

ImportResult FbxImporter::open(const SourceFiles& source, const ImportOptions& options,
                               const Progress& progress) const
{
    progress.report(0);
    const auto& file = source.files.front();
    const InputFile exists(file);
    Assimp::Importer importer;
    const aiScene& read = readScene(importer, file);
    progress.report(0.5);
    Scene scene = sceneFromAssimp(read, file);
    restoreControlPoints(scene, read, file);
    scene.coordinates = {UpAxis::Y, metresPerUnit(read)};
    return sequencesFromScene(std::move(scene), file, options, progress.part(0.7, 1.0));
}

const FormatInfo& ColladaImporter::format() const
{
    static const FormatInfo info{.id = "collada", .name = "COLLADA", .extensions = {".dae"}};
    return info;
}

bool ColladaImporter::recognises(std::string_view head) const
{
    return head.find("<COLLADA") != std::string_view::npos;
}

ImportResult ColladaImporter::open(const SourceFiles& source, const ImportOptions& options,
                                   const Progress& progress) const
{
    progress.report(0);
    const auto& file = source.files.front();
    const InputFile exists(file);
    Assimp::Importer importer;
    // Assimp applies a COLLADA file's unit and up axis itself.
    Scene scene = sceneFromAssimp(readScene(importer, file), file);
    return sequencesFromScene(std::move(scene), file, options, progress.part(0.7, 1.0));
}

} // namespace quadrille
