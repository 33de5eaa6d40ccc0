// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/sequence/io/scene/assimplog.h"
#include "model/sequence/io/scene/assimpscene.h"
#include "model/sequence/io/scene/colladageometry.h"
#include "model/sequence/io/scene/controlpoints.h"
#include "model/sequence/io/scene/fbxgeometry.h"
#include "model/sequence/io/scene/scenesequences.h"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <cmath>

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
        throw Error(ErrorCode::FileSyntax,
                    {file, {}, {{"reason", plainAssimpText(importer.GetErrorString())}}});
    return *scene;
}

/// Says which parts of a file Assimp left out.
/// \throws Error FileSyntax where nothing is left.
void reportLosses(const AssimpErrors& errors, const std::filesystem::path& file, Scene& scene)
{
    if (!errors.lines().empty() && scene.meshes.empty())
        throw Error(ErrorCode::FileSyntax, {file, {}, {{"reason", errors.lines().front()}}});
    for (const std::string& line : errors.lines()) {
        scene.issues.push_back({Issue::Severity::Warning,
                                Issue::Code::Other,
                                {file, {}, {{"text", "A damaged part was left out: " + line + "."}}}});
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
    const auto geometries = readFbxGeometries(readFile(file).bytes());
    for (const PolygonGeometry& geometry : geometries)
        checkCorners(geometry, file);
    const AssimpErrors errors;
    Assimp::Importer importer;
    const aiScene& read = readScene(importer, file);
    progress.report(0.5);
    Scene scene = sceneFromAssimp(read, file);
    reportLosses(errors, file, scene);
    restoreControlPoints(scene, read, geometries);
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
    const auto geometries = readColladaGeometries(readFile(file).text(), file);
    progress.report(0.2);
    Assimp::Importer importer;
    const aiScene& read = readScene(importer, file);
    // Assimp applies a COLLADA file's unit and up axis itself.
    Scene scene = sceneFromAssimp(read, file);
    restoreControlPoints(scene, read, geometries);
    return sequencesFromScene(std::move(scene), file, options, progress.part(0.7, 1.0));
}

} // namespace quadrille
