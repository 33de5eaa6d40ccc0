// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Formats that users may try and that have no packaged reader: what to convert them to.
#include "model/sequence/io/files/refused.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/sequence/io/files/sourcefiles.h"

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

constexpr std::string_view caches = QUADRILLE_MESSAGE("Export it as OBJ plus PC2 or MDD, or as GLB.");
constexpr std::string_view scene =
    QUADRILLE_MESSAGE("Open it in its program and export GLB, FBX, or OBJ plus PC2 or MDD.");
constexpr std::string_view skeleton =
    QUADRILLE_MESSAGE("Pose a mesh with it and export that as GLB or FBX; a BVH may be named as the "
                      "reference joint angles of a sequence.");

constexpr std::array refused{
    Refused{"Alembic",
            QUADRILLE_MESSAGE("Open it in Blender and export OBJ plus PC2 or MDD, or GLB."),
            "Ogawa",
            {".abc"}},
    Refused{QUADRILLE_MESSAGE("Draco compressed meshes"),
            QUADRILLE_MESSAGE("Decode them to OBJ or PLY with draco_decoder."),
            "DRACO",
            {".drc"}},
    Refused{QUADRILLE_MESSAGE("KTX2 texture streams"),
            QUADRILLE_MESSAGE("Decode them to PNG or JPEG with ktx extract."),
            "\xABKTX 20\xBB\r\n\x1A\n",
            {".ktx2"}},
    Refused{QUADRILLE_MESSAGE("Blender files"), scene, "BLENDER", {".blend"}},
    Refused{QUADRILLE_MESSAGE("Maya files"), scene, "//Maya ASCII", {".ma", ".mb"}},
    Refused{"3ds Max files", scene, "", {".max", ".3ds"}},
    Refused{QUADRILLE_MESSAGE("Cinema 4D files"), scene, "QC4DC4D6", {".c4d"}},
    Refused{QUADRILLE_MESSAGE("Houdini files"), scene, "", {".hip", ".bgeo"}},
    Refused{QUADRILLE_MESSAGE("LightWave files"), scene, "", {".lwo", ".lws"}},
    Refused{QUADRILLE_MESSAGE("ZBrush files"),
            QUADRILLE_MESSAGE("Export the mesh as OBJ."),
            "",
            {".ztl", ".zpr"}},
    Refused{QUADRILLE_MESSAGE("USD scenes"), caches, "PXR-USDC", {".usd", ".usdc", ".usdz"}},
    Refused{QUADRILLE_MESSAGE("USD scenes"), caches, "#usda", {".usda"}},
    Refused{QUADRILLE_MESSAGE("A skeleton without a mesh (BVH)"), skeleton, "HIERARCHY", {".bvh"}},
    Refused{QUADRILLE_MESSAGE("A skeleton without a mesh (Acclaim)"), skeleton, "", {".asf", ".amc"}},
    Refused{QUADRILLE_MESSAGE("Marker data (C3D)"),
            QUADRILLE_MESSAGE("Solve it to a mesh in the capture software and export GLB or FBX."),
            "",
            {".c3d"}},
    Refused{QUADRILLE_MESSAGE("A point cloud"),
            QUADRILLE_MESSAGE("Mesh it and export OBJ or PLY with faces."),
            "# .PCD",
            {".pcd", ".las", ".e57"}},
    Refused{QUADRILLE_MESSAGE("A Maya point cache"),
            QUADRILLE_MESSAGE("Export it as PC2 or MDD."),
            "",
            {".mc", ".mcx"}},
    Refused{QUADRILLE_MESSAGE("A compressed archive"),
            QUADRILLE_MESSAGE("Unpack it and choose the folder."),
            "PK\x03\x04",
            {".zip", ".7z", ".rar"}},
    Refused{QUADRILLE_MESSAGE("A compressed archive"),
            QUADRILLE_MESSAGE("Unpack it and choose the folder."),
            "\x1F\x8B",
            {".gz", ".tgz", ".xz"}},
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
