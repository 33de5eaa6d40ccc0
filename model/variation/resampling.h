// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/procrustes.h"

#include <array>
#include <span>

namespace quadrille {

/// A time between frames, by a uniform Catmull–Rom cubic through the four around it: linear between two, what
/// flies or swings would go along chords, with a kink at each frame. Beyond the ends, frames go straight on.
struct FramesAround
{
    std::array<std::size_t, 4> frames{};
    std::array<double, 4> weights{};

    std::size_t before() const { return frames[1]; }
    std::size_t after() const { return frames[2]; }
    double share = 0; ///< of the frame after
};

/// \param position  in frames from 0; what is outside of them is the first or the last. \pre count > 0
FramesAround framesAround(double position, std::size_t count);

/// A placement between others: translations by the cubic, rotations by slerp.
RigidMotion placementAt(const FramesAround& at, std::span<const RigidMotion> placements);

/// A vertex between poses that are stored one after the other.
inline Vec3f vertexAt(const FramesAround& at, std::span<const Vec3f> poses, std::size_t vertices,
                      std::size_t vertex)
{
    Vec3d sum = Vec3d::Zero();
    for (std::size_t i = 0; i < 4; ++i)
        sum += at.weights[i] * poses[at.frames[i] * vertices + vertex].cast<double>();
    return sum.cast<float>();
}

} // namespace quadrille
