// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/survey.h"

#include <algorithm>
#include <limits>

namespace quadrille {

Survey surveySequence(const MeshSequence& sequence, UpAxis up, int maximalFrames, const Progress& progress)
{
    const std::int64_t last = sequence.frameCount() - 1;
    const std::int64_t count = std::min<std::int64_t>(last + 1, maximalFrames);
    constexpr float unbounded = std::numeric_limits<float>::max();
    Survey survey{.lower = Vec3f::Constant(unbounded), .upper = Vec3f::Constant(-unbounded)};
    std::vector<Vec3f> positions(sequence.topology->vertexCount());
    for (std::int64_t i = 0; i < count; ++i) {
        progress.report(i, count);
        const FrameIndex frame(count == 1 ? 0 : i * last / (count - 1));
        sequence.source->read(sequence.sourceFrame(frame), positions);
        Vec3d sum = Vec3d::Zero();
        for (const Vec3f& position : positions) {
            sum += position.cast<double>();
            survey.lower = survey.lower.cwiseMin(position);
            survey.upper = survey.upper.cwiseMax(position);
        }
        survey.centroids.emplace_back((sum / static_cast<double>(positions.size())).cast<float>());
    }
    survey.lowest = survey.lower[static_cast<int>(up)];
    return survey;
}

} // namespace quadrille
