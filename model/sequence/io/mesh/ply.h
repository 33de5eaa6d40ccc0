// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/mesh/meshfile.h"

namespace quadrille {

/// Reads PLY (ASCII, binary of either byte order): vertices as they are; UVs of corners (`texcoord`) or of
/// vertices (`s t`, `u v`, `texture_u texture_v`); polygons cut into fans from their first corner; materials
/// by `texnumber`; further elements and properties are passed over. \throws Error FileSyntax, FileTruncated,
/// CountTooLarge, IndexOutOfRange, NoVertices, NoFaces; with the line or the byte.
MeshFile parsePly(std::string_view content, const std::filesystem::path& file);

/// Reads positions of further files that have the same layout, and compares all behind the vertices byte by
/// byte.
std::shared_ptr<const PositionReader> makePlyPositionReader(std::string_view content, const MeshFile& mesh);

const FormatInfo& plyFormat();
std::unique_ptr<Importer> makePlyImporter();
/// Writes binary little endian with UVs per corner (`texcoord`) and, where there are several textures, the
/// number of each face's (`texnumber`); pictures beside the files, named by "comment TextureFile".
std::unique_ptr<Exporter> makePlyExporter();

} // namespace quadrille
