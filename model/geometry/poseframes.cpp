// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/poseframes.h"

#include "model/geometry/poseframekernel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace quadrille {

PoseFrames poseFrames(std::span<const Triangle> triangles, Positions positions)
{
    Eigen::AlignedBox<double, 3> box;
    for (const Vec3f& position : positions)
        box.extend(position.cast<double>());
    const double least = std::max(2e-12 * box.diagonal().squaredNorm(), 1e-300);

    PoseFrames frames;
    const std::array targets{&frames.qw,  &frames.qx,  &frames.qy, &frames.qz,
                             &frames.b11, &frames.b12, &frames.b22};
    for (std::vector<double>* target : targets)
        target->resize(triangles.size());
    FrameBlock block{};
    for (std::size_t from = 0; from < triangles.size(); from += frameBlockSize) {
        const std::size_t count = std::min(frameBlockSize, triangles.size() - from);
        for (std::size_t i = 0; i < count; ++i) {
            const auto& [v1, v2, v3] = triangles[from + i];
            const Vec3d third = positions[v3.value].cast<double>();
            const Vec3d first = positions[v1.value].cast<double>() - third;
            const Vec3d second = positions[v2.value].cast<double>() - third;
            for (std::size_t c = 0; c < 3; ++c) {
                block.first[c][i] = first[static_cast<Eigen::Index>(c)];
                block.second[c][i] = second[static_cast<Eigen::Index>(c)];
            }
        }
        computeFrames(block, least);
        const auto offset = static_cast<std::ptrdiff_t>(from);
        for (std::size_t t = 0; t < targets.size(); ++t) {
            const auto& values = t < 4 ? block.quaternion[t] : block.edges[t - 4];
            std::copy_n(values.begin(), count, targets[t]->begin() + offset);
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (!(block.doubleArea[i] >= least))
                frames.degenerate.push_back(static_cast<int>(from + i));
        }
    }
    return frames;
}

} // namespace quadrille
