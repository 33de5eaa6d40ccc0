// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Formats that users may try and that have no packaged reader: what to convert them to.
#include "model/sequence/io/refused.h"

#include "model/core/error.h"
#include "model/sequence/io/sourcefiles.h"

#include <algorithm>
#include <array>

namespace quadrille {

namespace {

struct Refused
{
    std::string_view format;
    std::string_view remedy;
    std::string_view signature; ///< empty where only the extension tells
    std::array<std::string_view, 3> extensions;
};

using namespace std::string_view_literals;

constexpr auto caches = "Export it as OBJ plus PC2 or MDD, or as GLB."sv;
constexpr auto scene = "Open it in its program and export GLB, FBX, or OBJ plus PC2 or MDD."sv;
constexpr auto skeleton =
    "Pose a mesh with it and export that as GLB or FBX; a BVH may be named as the reference joint angles of a sequence."sv;

constexpr std::array refused{
    Refused{"Alembic", "Open it in Blender and export OBJ plus PC2 or MDD, or GLB.", "Ogawa", {".abc"}},
    Refused{"Draco compressed meshes", "Decode them to OBJ or PLY with draco_decoder.", "DRACO", {".drc"}},
    Refused{"KTX2 texture streams",
            "Decode them to PNG or JPEG with ktx extract.",
            "\xABKTX 20\xBB\r\n\x1A\n",
            {".ktx2"}},
    Refused{"Blender files", scene, "BLENDER", {".blend"}},
    Refused{"Maya files", scene, "//Maya ASCII", {".ma", ".mb"}},
    Refused{"3ds Max files", scene, "", {".max", ".3ds"}},
    Refused{"Cinema 4D files", scene, "QC4DC4D6", {".c4d"}},
    Refused{"Houdini files", scene, "", {".hip", ".bgeo"}},
    Refused{"LightWave files", scene, "", {".lwo", ".lws"}},
    Refused{"ZBrush files", "Export the mesh as OBJ.", "", {".ztl", ".zpr"}},
    Refused{"USD scenes", caches, "PXR-USDC", {".usd", ".usdc", ".usdz"}},
    Refused{"USD scenes", caches, "#usda", {".usda"}},
    Refused{"A skeleton without a mesh (BVH)", skeleton, "HIERARCHY", {".bvh"}},
    Refused{"A skeleton without a mesh (Acclaim)", skeleton, "", {".asf", ".amc"}},
    Refused{"Marker data (C3D)",
            "Solve it to a mesh in the capture software and export GLB or FBX.",
            "",
            {".c3d"}},
    Refused{"A point cloud", "Mesh it and export OBJ or PLY with faces.", "# .PCD", {".pcd", ".las", ".e57"}},
    Refused{"A Maya point cache", "Export it as PC2 or MDD.", "", {".mc", ".mcx"}},
    Refused{
        "A compressed archive", "Unpack it and choose the folder.", "PK\x03\x04", {".zip", ".7z", ".rar"}},
    Refused{"A compressed archive", "Unpack it and choose the folder.", "\x1F\x8B", {".gz", ".tgz", ".xz"}},
};

bool hasExtension(const Refused& entry, std::string_view extension)
{
    return !extension.empty() &&
           std::find(entry.extensions.begin(), entry.extensions.end(), extension) != entry.extensions.end();
}

} // namespace

void refuseForeignFormat(const std::filesystem::path& file, std::string_view head)
{
    const auto extension = lowerExtension(file);
    const auto fail = [&file](const Refused& entry) {
        throw Error(
            ErrorCode::FormatRefused,
            {file, {}, {{"format", std::string(entry.format)}, {"remedy", std::string(entry.remedy)}}});
    };
    for (const auto& entry : refused) {
        if (hasExtension(entry, extension))
            fail(entry);
    }
    for (const auto& entry : refused) {
        if (!entry.signature.empty() && head.starts_with(entry.signature))
            fail(entry);
    }
}

std::vector<std::string> refusedSeriesExtensions()
{
    return {".drc", ".bgeo"};
}

} // namespace quadrille
