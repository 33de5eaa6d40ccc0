// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/mesh/meshfile.h"

namespace quadrille {

/// Reads Wavefront OBJ: vertices as they are, one UV per corner, polygons cut into fans from their first
/// corner, objects and groups merged. Normals, vertex colours, lines and points are passed over.
/// \throws Error FileEncoding, FileSyntax, IndexOutOfRange, NoVertices, NoFaces; with the line.
MeshFile parseObj(std::string_view content, const std::filesystem::path& file);

/// Reads positions of further files by comparing the text of their faces and UVs with that of this one.
std::shared_ptr<const PositionReader> makeObjPositionReader(std::string_view content, const MeshFile& mesh);

const FormatInfo& objFormat();
std::unique_ptr<Importer> makeObjImporter();
/// Writes vertices, UVs per corner and materials; pictures and a material library (one per frame where
/// textures change) beside them.
std::unique_ptr<Exporter> makeObjExporter();

} // namespace quadrille
