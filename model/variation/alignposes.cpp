// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/alignposes.h"

#include "model/variation/playback.h"

#include <algorithm>
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
        const double frame =
            std::clamp(take.warp.positions[f] - static_cast<double>(take.warp.frames.first.value), 0.0,
                       static_cast<double>(laid.placements.size() - 1));
        const auto before = static_cast<std::size_t>(frame);
        const std::size_t after = std::min(before + 1, laid.placements.size() - 1);
        const double share = frame - static_cast<double>(before);
        take.placements.push_back(interpolated(laid.placements[before], laid.placements[after], share));
        for (std::size_t v = 0; v < vertices; ++v) {
            const Vec3f& a = laid.poses[before * vertices + v];
            const Vec3f& b = laid.poses[after * vertices + v];
            take.poses[f * vertices + v] = a + static_cast<float>(share) * (b - a);
        }
    }
}

} // namespace quadrille
