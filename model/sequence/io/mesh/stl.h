// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/mesh/meshfile.h"

namespace quadrille {

/// Reads STL, text or binary. STL names no vertices: corners at exactly the same place are one vertex, in the
/// order in which they first come; an issue says so. All frames of a series need their triangles in the same
/// order.
/// \throws Error FileSyntax, FileTruncated, CountTooLarge, NoFaces; with the line or byte.
MeshFile parseStl(std::string_view content, const std::filesystem::path& file);

std::unique_ptr<Importer> makeStlImporter();

} // namespace quadrille
