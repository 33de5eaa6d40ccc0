// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/resampling.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

FramesAround framesAround(double position, std::size_t count)
{
    assert(count > 0);
    const std::size_t last = count - 1;
    const double clamped = std::clamp(position, 0.0, static_cast<double>(last));
    const auto before = static_cast<std::size_t>(clamped);
    const std::size_t after = std::min(before + 1, last);
    const double s = clamped - static_cast<double>(before);
    FramesAround around{.frames = {before > 0 ? before - 1 : 0, before, after, std::min(after + 1, last)},
                        .weights = {-s * (1 - s) * (1 - s) / 2, 1 + s * s * (3 * s - 5) / 2,
                                    s * (1 + s * (4 - 3 * s)) / 2, -s * s * (1 - s) / 2},
                        .share = s};
    std::array<double, 4>& w = around.weights;
    // A frame that there is not lies opposite the next but one.
    if (before == 0) {
        w[1] += 2 * w[0];
        w[2] -= w[0];
        w[0] = 0;
    }
    if (after == last) {
        w[2] += 2 * w[3];
        w[1] -= w[3];
        w[3] = 0;
    }
    return around;
}

RigidMotion placementAt(const FramesAround& at, std::span<const RigidMotion> placements)
{
    RigidMotion place{placements[at.before()].rotation.slerp(at.share, placements[at.after()].rotation),
                      Vec3d::Zero()};
    for (std::size_t i = 0; i < 4; ++i)
        place.translation += at.weights[i] * placements[at.frames[i]].translation;
    return place;
}

} // namespace quadrille
