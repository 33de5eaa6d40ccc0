// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/quality/junctionspeeds.h"

#include "model/synthesis/clips/ground.h"
#include "model/synthesis/quality/framemeasures.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr std::int64_t speedFrames = 3; // that a velocity is taken over

/// Mean velocity over the ground from one frame of a plan to another.
Vec2d velocity(const ClipPlan& plan, std::int64_t from, std::int64_t to, double fps)
{
    const Ground ground(plan.up);
    const auto at = [&](std::int64_t frame) {
        return ground.of(plan.frames[static_cast<std::size_t>(frame)].centre);
    };
    return (at(to) - at(from)) * (fps / static_cast<double>(to - from));
}

} // namespace

std::optional<double> footSlide(const Clip& clip, const ClipPlan::Junction& junction, const RootPoses& roots,
                                std::span<const std::uint32_t> standing)
{
    double sum = 0;
    int count = 0;
    for (std::int64_t f = junction.first; f < junction.last; ++f) {
        const auto index = static_cast<std::size_t>(f);
        const auto slide = slideOf(clip.frame(f), clip.frame(f + 1), standing[index] & standing[index + 1],
                                   roots.stances, roots.up, clip.fps);
        sum += slide.value_or(0);
        count += slide ? 1 : 0;
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::optional<double> speedJump(const ClipPlan& plan, const ClipPlan::Junction& junction, double fps)
{
    const std::int64_t first = std::max<std::int64_t>(junction.first - speedFrames, 0);
    const std::int64_t last = std::min(junction.last + speedFrames, plan.frameCount() - 1);
    if (first == junction.first || last == junction.last)
        return std::nullopt;
    return (velocity(plan, junction.last, last, fps) - velocity(plan, first, junction.first, fps)).norm();
}

} // namespace quadrille
