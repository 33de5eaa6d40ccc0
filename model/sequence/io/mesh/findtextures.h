// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"
#include "model/sequence/io/mesh/meshfile.h"
#include "model/sequence/texture.h"

#include <filesystem>
#include <vector>

namespace quadrille {

struct FoundTextures
{
    TextureSet textures;
    std::vector<Issue> issues;
};

/// What to look for textures of.
struct TextureSearch
{
    SourceFiles take;            ///< file or series with the frames
    std::int64_t frameCount = 0; ///< of the take
    /// What the user named: a picture, or a folder or pattern with one per frame; may be empty.
    std::filesystem::path named;
    /// What the mesh itself names or has beside it.
    TextureSet ofMesh;
};

/// The textures of a take: those the user named, else one per frame from `textures/STEM/` or from pictures
/// beside a series that bear its numbers, else those of the mesh. A folder found by itself that does not hold
/// one picture per frame becomes an issue.
/// \throws Error ImageCountMismatch, FileNotFound, SeriesEmpty for what the user named.
FoundTextures findTextures(const TextureSearch& search);

/// The textures that a mesh names (material libraries, texture files), or else a picture beside it that is
/// called like the mesh or `texture`. Files that are not there become issues.
FoundTextures texturesNamedBy(const MeshFile& mesh, const std::filesystem::path& file);

} // namespace quadrille
