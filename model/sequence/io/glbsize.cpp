// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/cornersplit.h"
#include "model/sequence/io/glbwriter.h"

#include <algorithm>

namespace quadrille {

std::uint64_t estimateGlbBytes(const MeshSequence& sequence)
{
    const auto frames = static_cast<std::uint64_t>(sequence.frameCount());
    const CornerSplit split = splitCorners(sequence.topology->data());
    const std::uint64_t vertices = split.vertexOf.size();
    const std::uint64_t materials = std::max<std::size_t>(1, sequence.topology->data().materials.size());
    const std::uint64_t perTarget = 600 + 30 * materials; // JSON of a target with its accessor and views
    return vertices * (sizeof(Vec3f) * frames + sizeof(Vec2f) + sizeof(float)) + split.triangles.size() * 12 +
           frames * frames * sizeof(float) + frames * perTarget + materials * 500 + 3000;
}

} // namespace quadrille
