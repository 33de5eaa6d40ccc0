// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"
#include "model/sequence/io/scene/scene.h"

namespace quadrille {

/// glTF 2.0 (.gltf, .glb): skins, morph targets and node animation, one sequence per animation. Vertices that
/// glTF split are welded (weld.h); files that our GLB writer made come back in their original order.
class GltfImporter : public Importer
{
public:
    const FormatInfo& format() const override;
    bool recognises(std::string_view head) const override;
    ImportResult open(const SourceFiles& source, const ImportOptions& options,
                      const Progress& progress) const override;
};

class GltfDocument;

/// Attribute of a primitive in which our writer keeps the vertex order: the original vertex of each vertex.
inline constexpr const char* gltfVertexAttribute = "_VERTEX";

/// The meshes of the document's nodes, with materials and textures, appended to the scene.
/// \param nodeOf  scene node of each glTF node.
void readGltfMeshes(const GltfDocument& document, const std::vector<int>& nodeOf, Scene& scene);
/// The clips of the document, appended to the scene.
void readGltfAnimations(const GltfDocument& document, const std::vector<int>& nodeOf, Scene& scene);

} // namespace quadrille
