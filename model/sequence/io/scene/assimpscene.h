// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/io/files/format.h"
#include "model/sequence/io/scene/scene.h"

struct aiScene;

namespace quadrille {

/// FBX (binary and text): skins, blend shapes and node animation, one sequence per animation stack. Units and
/// axes as the file says. The control points of binary files keep their count and order; elsewhere split
/// vertices are welded (weld.h).
class FbxImporter : public Importer
{
public:
    const FormatInfo& format() const override;
    bool recognises(std::string_view head) const override;
    ImportResult open(const SourceFiles& source, const ImportOptions& options,
                      const Progress& progress) const override;
};

/// COLLADA (.dae), likewise; split vertices are welded.
class ColladaImporter : public Importer
{
public:
    const FormatInfo& format() const override;
    bool recognises(std::string_view head) const override;
    ImportResult open(const SourceFiles& source, const ImportOptions& options,
                      const Progress& progress) const override;
};

/// Takes over what assimp read, vertices split as assimp split them. Nodes stand under one that turns the
/// file's axes to y up.
Scene sceneFromAssimp(const aiScene& source, const std::filesystem::path& file);
/// Appends the clips of an assimp scene. \param scene  holds nodes and meshes already.
void readAssimpAnimations(const aiScene& source, Scene& scene);

} // namespace quadrille
