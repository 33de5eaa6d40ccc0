// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/ownperiod.h"

#include "model/geometry/procrustes.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/transition/posedistance.h"

namespace quadrille {

namespace {

bool isBetween(float value, float least, float most)
{
    return value >= least && value <= most;
}

/// How far the figure goes and turns from one frame to the next.
struct Step
{
    Vec2d shift;
    double turn;
};

Step stepOf(const Clip& clip, std::int64_t from, std::int64_t to, const Ground& ground)
{
    return {ground.of(centroid(clip.frame(to))) - ground.of(centroid(clip.frame(from))),
            groundAlignment(clip.frame(from), clip.frame(to), ground)};
}

} // namespace

MeshSequence partOf(const Clip& clip, std::int64_t first, std::int64_t last)
{
    const std::uint32_t vertices = clip.topology->vertexCount();
    const auto begin = clip.positions.begin() + first * vertices;
    std::vector<Vec3f> positions(begin, begin + (last - first + 1) * vertices);
    return makeSequence({}, clip.topology, std::make_shared<MemoryFrames>(std::move(positions), vertices),
                        clip.fps);
}

std::optional<OwnPeriod> ownPeriod(const Clip& clip, UpAxis up, const PoseDistanceSettings& pose)
{
    const std::int64_t last = clip.frameCount() - 1;
    if (last < 3)
        return {};
    const CharacterFrames ends(std::vector{partOf(clip, 0, 1), partOf(clip, last - 1, last)});
    const Table<float> d = poseDistances(ends, pose).distances;
    const float step = (d(0, 1) + d(2, 3)) / 2;
    // Poses that differ by rounding only are at some 1e-5 from each other.
    constexpr float rounding = 1e-4F;
    const Ground ground(up);
    const Step whole = stepOf(clip, 0, last, ground);
    const Vec2d first = ground.of(centroid(clip.frame(0)));
    const bool isAgain = d(0, 3) <= 0.35F * step + rounding && d(1, 2) >= 1.5F * step;
    if (isAgain)
        return OwnPeriod{last, GroundMotion::taking(first, first + whole.shift, whole.turn), d(0, 3)};
    const bool goesOn = isBetween(d(0, 3), 0.6F * step, 1.4F * step) &&
                        isBetween(d(0, 2), 1.7F * step, 2.5F * step) &&
                        isBetween(d(1, 3), 1.7F * step, 2.5F * step);
    if (!goesOn)
        return {};
    const Step before = stepOf(clip, last - 1, last, ground);
    const Step after = stepOf(clip, 0, 1, ground);
    const double turn = whole.turn + (before.turn + after.turn) / 2;
    const Vec2d shift = whole.shift + (before.shift + Eigen::Rotation2Dd(turn) * after.shift) / 2;
    return OwnPeriod{last + 1, GroundMotion::taking(first, first + shift, turn), d(0, 3)};
}

} // namespace quadrille
