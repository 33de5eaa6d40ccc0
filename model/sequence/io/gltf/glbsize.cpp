// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/gltf/glbwriter.h"
#include "model/sequence/io/scene/cornersplit.h"

#include <algorithm>

namespace quadrille {

std::uint64_t estimateGlbBytes(const MeshSequence& sequence, bool normals)
{
    const auto frames = static_cast<std::uint64_t>(sequence.frameCount());
    const CornerSplit split = splitCorners(sequence.topology->data());
    const std::uint64_t vertices = split.vertexOf.size();
    const std::uint64_t materials = std::max<std::size_t>(1, sequence.topology->data().materials.size());
    const std::uint64_t attributes = normals ? 2 : 1;
    // JSON of a target with its accessors and views
    const std::uint64_t perTarget = attributes * (600 + 30 * materials);
    return vertices * (attributes * sizeof(Vec3f) * frames + sizeof(Vec2f) + sizeof(float)) +
           split.triangles.size() * 12 + frames * frames * sizeof(float) + frames * perTarget +
           materials * 500 + 3000;
}

} // namespace quadrille
