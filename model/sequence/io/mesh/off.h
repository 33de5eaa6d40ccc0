// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/mesh/meshfile.h"

namespace quadrille {

/// Reads OFF as text, with or without its first line, and the variants with normals, colours or texture
/// coordinates (NOFF, COFF, STOFF, …); of these, texture coordinates are kept. Polygons are cut into fans
/// from their first corner. \throws Error FileSyntax, FileTruncated, CountTooLarge, FormatRefused (binary,
/// higher dimensions), IndexOutOfRange, NoVertices, NoFaces; with the line.
MeshFile parseOff(std::string_view content, const std::filesystem::path& file);

std::unique_ptr<Importer> makeOffImporter();

} // namespace quadrille
