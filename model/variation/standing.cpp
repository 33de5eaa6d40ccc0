// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/standing.h"

#include "model/core/smoothing.h"

namespace quadrille {

namespace {

/// Standard deviation of the Gaussian that evens the way out, seconds: a body does not change its speed
/// within a frame.
constexpr double evening = 0.1;

/// Vertices that stand in both frames that a pose comes from.
std::vector<std::uint32_t> standingIn(const FrameOrigin& origin, std::span<const Support> supports)
{
    const auto of = [&](NodeIndex node) -> const std::vector<std::uint32_t>& {
        return supports[static_cast<std::size_t>(node)].vertices;
    };
    return common(of(origin.source), of(origin.destination));
}

Vec2d meanPlace(Positions positions, std::span<const std::uint32_t> vertices, const Ground& ground)
{
    Vec2d sum = Vec2d::Zero();
    for (const std::uint32_t vertex : vertices)
        sum += ground.of(positions[vertex].cast<double>());
    return sum / static_cast<double>(vertices.size());
}

/// How far each frame is to be moved so that nothing slides that stands in it and in the one before.
std::vector<Vec2d> shiftsOf(const Clip& clip, std::span<const Support> supports, const Ground& ground)
{
    std::vector<Vec2d> shifts;
    std::vector<std::uint32_t> before;
    Vec2d shift = Vec2d::Zero();
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const std::vector<std::uint32_t> now =
            standingIn(clip.origins[static_cast<std::size_t>(f)], supports);
        const std::vector<std::uint32_t> standing = common(before, now);
        if (!standing.empty())
            shift +=
                meanPlace(clip.frame(f - 1), standing, ground) - meanPlace(clip.frame(f), standing, ground);
        shifts.push_back(shift);
        before = now;
    }
    return shifts;
}

} // namespace

void keepStanding(Clip& clip, std::span<const Support> supports, UpAxis up)
{
    const Ground ground(up);
    const std::vector<Vec2d> shifts = evened(shiftsOf(clip, supports, ground), evening * clip.fps);
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const Vec3f moved = ground.at(shifts[static_cast<std::size_t>(f)], 0).cast<float>();
        for (Vec3f& position : clip.frame(f))
            position += moved;
    }
}

} // namespace quadrille
