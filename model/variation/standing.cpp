// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/standing.h"

#include "model/core/bounds.h"
#include "model/core/smoothing.h"
#include "model/sequence/feet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace quadrille {

namespace {

/// Standard deviation of the Gaussian that evens the way out, seconds: a body does not change its speed
/// within a frame.
constexpr double evening = 0.1;
/// The same for what is raised so that nothing is under the ground.
constexpr double eveningOfFloor = 0.06;
/// Of the figure's size: no further above the deepest point frames without known stances count as on the
/// ground.
constexpr double groundShare = 0.015;

/// A frame that a variation follows.
struct FollowedFrame
{
    std::vector<std::uint32_t> standing; ///< in both frames that it comes from
    double lowest = 0;                   ///< height of its lowest vertex, metres
    bool isOnGround = false;
};

double levelOf(Positions pose, const Ground& ground)
{
    double lowest = ground.heightOf(pose.front().cast<double>());
    for (const Vec3f& position : pose)
        lowest = std::min(lowest, ground.heightOf(position.cast<double>()));
    return lowest;
}

std::vector<FollowedFrame> followedFrames(const Clip& clip, const CapturedStanding& captured,
                                          const Ground& ground)
{
    const auto standing = [&](NodeIndex node) -> const std::vector<std::uint32_t>& {
        return captured.supports[static_cast<std::size_t>(node)].vertices;
    };
    const auto lowest = [&](NodeIndex node) {
        return levelOf(captured.character.frame(node).positions(), ground);
    };
    std::vector<FollowedFrame> frames;
    double floor = std::numeric_limits<double>::infinity();
    for (const FrameProvenance& origin : clip.origins) {
        FollowedFrame& frame = frames.emplace_back();
        frame.standing = common(standing(origin.source), standing(origin.destination));
        frame.lowest = lowest(origin.source);
        if (origin.destination != origin.source)
            frame.lowest = std::lerp(frame.lowest, lowest(origin.destination), origin.lambda);
        floor = std::min(floor, frame.lowest);
    }
    // Stances are not known in all frames: what is as low as it gets is on the ground as well.
    const double size = boundsOf(captured.character.frame(0).positions()).size().norm();
    for (FollowedFrame& frame : frames)
        frame.isOnGround = !frame.standing.empty() || frame.lowest <= floor + groundShare * size;
    return frames;
}

/// How far each frame is to be moved so that nothing slides that stands in it and in the one before.
std::vector<Vec2d> shiftsOf(const Clip& clip, std::span<const FollowedFrame> poses, const Ground& ground)
{
    std::vector<Vec2d> shifts{Vec2d::Zero()};
    for (std::size_t f = 1; f < poses.size(); ++f) {
        Vec2d shift = shifts.back();
        const std::vector<std::uint32_t> standing = common(poses[f - 1].standing, poses[f].standing);
        if (!standing.empty()) {
            const auto frame = static_cast<std::int64_t>(f);
            const Vec3f moved = meanOf(clip.frame(frame - 1), standing) - meanOf(clip.frame(frame), standing);
            shift += ground.of(moved.cast<double>());
        }
        shifts.push_back(shift);
    }
    return shifts;
}

/// How far each frame is to be raised so that it is as low as what it follows where that is on the ground;
/// between such frames evenly from the one to the other, and before the first and after the last, where no
/// flight is seen whole, as low as what it follows.
std::vector<double> risesOf(std::span<const double> lowest, std::span<const FollowedFrame> poses)
{
    std::vector<double> rises(poses.size());
    std::vector<std::size_t> known;
    for (std::size_t f = 0; f < poses.size(); ++f) {
        rises[f] = poses[f].lowest - lowest[f];
        if (poses[f].isOnGround)
            known.push_back(f);
    }
    if (known.empty())
        return rises;
    for (std::size_t i = 1; i < known.size(); ++i) {
        const std::size_t first = known[i - 1];
        const std::size_t last = known[i];
        for (std::size_t f = first + 1; f < last; ++f)
            rises[f] = std::lerp(rises[first], rises[last],
                                 static_cast<double>(f - first) / static_cast<double>(last - first));
    }
    return rises;
}

/// Rises that leave nothing deeper than a floor, as even as before: what is missing anywhere is added for so
/// many frames around it, and evened out.
std::vector<double> keptAbove(std::vector<double> rises, std::span<const double> lowest, double floor,
                              double deviation)
{
    const auto count = static_cast<std::ptrdiff_t>(rises.size());
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(2 * deviation));
    std::vector<double> missing(rises.size());
    bool isAnyMissing = false;
    for (std::ptrdiff_t f = 0; f < count; ++f) {
        for (std::ptrdiff_t g = std::max<std::ptrdiff_t>(f - reach, 0); g <= std::min(f + reach, count - 1);
             ++g) {
            const auto at = static_cast<std::size_t>(g);
            missing[static_cast<std::size_t>(f)] =
                std::max(missing[static_cast<std::size_t>(f)], floor - lowest[at] - rises[at]);
        }
        isAnyMissing = isAnyMissing || missing[static_cast<std::size_t>(f)] > 0;
    }
    if (!isAnyMissing)
        return rises;
    missing = evened(missing, deviation);
    for (std::size_t f = 0; f < rises.size(); ++f)
        rises[f] += missing[f];
    return rises;
}

} // namespace

void keepStanding(Clip& clip, const CapturedStanding& captured, UpAxis up)
{
    if (clip.origins.empty())
        return;
    const Ground ground(up);
    const std::vector<FollowedFrame> poses = followedFrames(clip, captured, ground);
    const double deviation = evening * clip.fps;
    const std::vector<Vec2d> shifts = evened(shiftsOf(clip, poses, ground), deviation);
    std::vector<double> lowest;
    for (std::int64_t f = 0; f < clip.frameCount(); ++f)
        lowest.push_back(levelOf(clip.frame(f), ground));
    const double floor = std::ranges::min_element(poses, {}, &FollowedFrame::lowest)->lowest;
    const std::vector<double> rises =
        keptAbove(evened(risesOf(lowest, poses), deviation), lowest, floor, eveningOfFloor * clip.fps);
    for (std::size_t f = 0; f < poses.size(); ++f) {
        const Vec3f moved = ground.at(shifts[f], rises[f]).cast<float>();
        for (Vec3f& position : clip.frame(static_cast<std::int64_t>(f)))
            position += moved;
    }
}

} // namespace quadrille
