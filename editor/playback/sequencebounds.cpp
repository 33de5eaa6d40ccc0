// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/sequencebounds.h"

#include <algorithm>
#include <limits>

namespace quadrille {

SequenceBounds surveySequence(const MeshSequence& sequence, UpAxis up, int maximalFrames,
                              const Progress& progress)
{
    const std::int64_t last = sequence.frameCount() - 1;
    const std::int64_t count = std::min<std::int64_t>(last + 1, maximalFrames);
    constexpr float unbounded = std::numeric_limits<float>::max();
    SequenceBounds bounds{.lower = Vec3f::Constant(unbounded), .upper = Vec3f::Constant(-unbounded)};
    std::vector<Vec3f> positions(sequence.topology->vertexCount());
    for (std::int64_t i = 0; i < count; ++i) {
        progress.report(i, count);
        const FrameIndex frame(count == 1 ? 0 : i * last / (count - 1));
        sequence.source->read(sequence.sourceFrame(frame), positions);
        Vec3d sum = Vec3d::Zero();
        for (const Vec3f& position : positions) {
            sum += position.cast<double>();
            bounds.lower = bounds.lower.cwiseMin(position);
            bounds.upper = bounds.upper.cwiseMax(position);
        }
        bounds.centroids.emplace_back((sum / static_cast<double>(positions.size())).cast<float>());
    }
    bounds.lowest = bounds.lower[static_cast<int>(up)];
    return bounds;
}

} // namespace quadrille
