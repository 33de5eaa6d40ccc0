// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/alignposes.h"

#include "model/variation/resampling.h"

#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Captured frames of a take on the template.
struct LaidFrames
{
    std::vector<Vec3f> poses;
    std::vector<RigidMotion> placements;
};

LaidFrames layFrames(const MeshSequence& sequence, FrameRange frames, const AlignmentTemplate& templatePose,
                     const Progress& progress)
{
    const std::size_t vertices = templatePose.pose.size();
    const auto count = static_cast<std::size_t>(frames.count());
    LaidFrames laid{.poses = std::vector<Vec3f>(count * vertices),
                    .placements = std::vector<RigidMotion>(count)};
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
        progress.report(static_cast<double>(k) / static_cast<double>(count));
        const Frame frame = sequence.frame(FrameIndex(frames.first.value + static_cast<std::int64_t>(k)));
        const RigidMotion onto = templatePose.onto(frame.positions());
        for (std::size_t v = 0; v < vertices; ++v)
            laid.poses[k * vertices + v] = onto(frame.positions()[v].cast<double>()).cast<float>();
        const Eigen::Quaterniond back = onto.rotation.conjugate();
        laid.placements[k] = {back, -(back * onto.translation)};
    });
    return laid;
}

} // namespace

void alignPoses(const MeshSequence& sequence, AlignedTake& take, const Progress& progress)
{
    const LaidFrames laid = layFrames(sequence, take.warp.frames, *take.laidOnto, progress);
    const std::size_t vertices = take.laidOnto->pose.size();
    take.poses.resize(take.warp.positions.size() * vertices);
    for (std::size_t f = 0; f < take.warp.positions.size(); ++f) {
        const FramesAround at =
            framesAround(take.warp.positions[f] - static_cast<double>(take.warp.frames.first.value),
                         laid.placements.size());
        take.placements.push_back(placementAt(at, laid.placements));
        for (std::size_t v = 0; v < vertices; ++v)
            take.poses[f * vertices + v] = vertexAt(at, laid.poses, vertices, v);
    }
}

} // namespace quadrille
