// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/standing.h"

#include "model/core/smoothing.h"
#include "model/sequence/feet.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace quadrille {

namespace {

/// Standard deviation of the Gaussian that evens the way out, seconds: a body does not change its speed
/// within a frame.
constexpr double evening = 0.1;

/// What stands in a pose of a variation, and how far above the ground's zero it stood, metres.
struct StandingPose
{
    std::vector<std::uint32_t> vertices; ///< those that stand in both frames that the pose comes from
    double height = 0;
};

StandingPose standingIn(const FrameOrigin& origin, const CapturedStanding& captured, const Ground& ground)
{
    const auto of = [&](NodeIndex node) -> const std::vector<std::uint32_t>& {
        return captured.supports[static_cast<std::size_t>(node)].vertices;
    };
    StandingPose pose{.vertices = common(of(origin.source), of(origin.destination))};
    if (pose.vertices.empty())
        return pose;
    const auto height = [&](NodeIndex node) {
        return ground.heightOf(
            meanOf(captured.character.frame(node).positions(), pose.vertices).cast<double>());
    };
    pose.height = height(origin.source);
    if (origin.destination != origin.source)
        pose.height += origin.lambda * (height(origin.destination) - pose.height);
    return pose;
}

std::vector<StandingPose> standingPoses(const Clip& clip, const CapturedStanding& captured,
                                        const Ground& ground)
{
    std::vector<StandingPose> poses;
    for (const FrameOrigin& origin : clip.origins)
        poses.push_back(standingIn(origin, captured, ground));
    return poses;
}

/// How far each frame is to be moved so that nothing slides that stands in it and in the one before.
std::vector<Vec2d> shiftsOf(const Clip& clip, std::span<const StandingPose> poses, const Ground& ground)
{
    std::vector<Vec2d> shifts{Vec2d::Zero()};
    for (std::size_t f = 1; f < poses.size(); ++f) {
        Vec2d shift = shifts.back();
        const std::vector<std::uint32_t> standing = common(poses[f - 1].vertices, poses[f].vertices);
        if (!standing.empty()) {
            const auto frame = static_cast<std::int64_t>(f);
            const Vec3f moved = meanOf(clip.frame(frame - 1), standing) - meanOf(clip.frame(frame), standing);
            shift += ground.of(moved.cast<double>());
        }
        shifts.push_back(shift);
    }
    return shifts;
}

/// How far each frame is to be raised so that what stands is as high as it was; where nothing does, evenly
/// from the frame before to the one after that stands.
std::vector<double> risesOf(const Clip& clip, std::span<const StandingPose> poses, const Ground& ground)
{
    std::vector<double> rises(poses.size());
    std::vector<std::size_t> known;
    for (std::size_t f = 0; f < poses.size(); ++f) {
        if (poses[f].vertices.empty())
            continue;
        const Vec3f place = meanOf(clip.frame(static_cast<std::int64_t>(f)), poses[f].vertices);
        rises[f] = poses[f].height - ground.heightOf(place.cast<double>());
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
    std::fill_n(rises.begin(), known.front(), rises[known.front()]);
    std::fill_n(rises.rbegin(), rises.size() - known.back(), rises[known.back()]);
    return rises;
}

} // namespace

void keepStanding(Clip& clip, const CapturedStanding& captured, UpAxis up)
{
    if (clip.origins.empty())
        return;
    const Ground ground(up);
    const std::vector<StandingPose> poses = standingPoses(clip, captured, ground);
    const double deviation = evening * clip.fps;
    const std::vector<Vec2d> shifts = evened(shiftsOf(clip, poses, ground), deviation);
    const std::vector<double> rises = evened(risesOf(clip, poses, ground), deviation);
    for (std::size_t f = 0; f < poses.size(); ++f) {
        const Vec3f moved = ground.at(shifts[f], rises[f]).cast<float>();
        for (Vec3f& position : clip.frame(static_cast<std::int64_t>(f)))
            position += moved;
    }
}

} // namespace quadrille
