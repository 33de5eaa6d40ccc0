// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/playback.h"

#include "model/variation/resampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Frame of a take, from 0, at a position on the reference.
NodeIndex nearestFrame(const TakeWarp& warp, double position)
{
    const FramesAround at = framesAround(position, warp.positions.size());
    const double frame = (1 - at.share) * warp.positions[at.before()] + at.share * warp.positions[at.after()];
    return static_cast<NodeIndex>(std::lround(frame));
}

} // namespace

RigidMotion interpolated(const RigidMotion& a, const RigidMotion& b, double share)
{
    return {a.rotation.slerp(share, b.rotation), (1 - share) * a.translation + share * b.translation};
}

Vec3d upSeenFrom(const RigidMotion& place, const Vec3d& up)
{
    return place.rotation.conjugate() * up;
}

RigidMotion leanedTo(const Vec3d& wantedUp, const RigidMotion& place, const Vec3d& up, double share)
{
    const Eigen::Quaterniond lean = Eigen::Quaterniond::FromTwoVectors(wantedUp, upSeenFrom(place, up));
    return {(place.rotation * Eigen::Quaterniond::Identity().slerp(share, lean)).normalized(),
            place.translation};
}

std::vector<RigidMotion> pathOnGround(std::span<const Displacement> displacements,
                                      std::span<const RigidMotion> guide, const PathSettings& settings)
{
    assert(displacements.size() == guide.size());
    const Vec3d up = Vec3d::Unit(static_cast<Eigen::Index>(settings.up));
    const double frames = settings.driftHalfLife * settings.fps;
    const double kept = frames > 0 ? std::exp2(-1 / frames) : 0;
    std::vector<RigidMotion> path;
    path.reserve(guide.size());
    for (std::size_t i = 0; i < guide.size(); ++i) {
        if (i == 0) {
            path.push_back(guide[0]);
            continue;
        }
        RigidMotion place = moved(path.back(), displacements[i]);
        const double height = up.dot(place.translation);
        place.translation += (1 - kept) * (up.dot(guide[i].translation) - height) * up;
        path.push_back(leanedTo(upSeenFrom(guide[i], up), place, up, 1 - kept));
    }
    return path;
}

std::vector<Vec3f> played(std::span<const Vec3f> poses, std::span<const RigidMotion> placements,
                          const TakeWarp& warp, const Progress& progress)
{
    const std::size_t vertices = placements.empty() ? 0 : poses.size() / placements.size();
    std::vector<Vec3f> frames(warp.playback.size() * vertices);
    tbb::parallel_for(std::size_t{0}, warp.playback.size(), [&](std::size_t k) {
        progress.report(static_cast<double>(k) / static_cast<double>(warp.playback.size()));
        const FramesAround at = framesAround(warp.playback[k], placements.size());
        const RigidMotion place = placementAt(at, placements);
        const Eigen::Matrix3f turn = place.rotation.toRotationMatrix().cast<float>();
        const Vec3f shift = place.translation.cast<float>();
        for (std::size_t v = 0; v < vertices; ++v)
            frames[k * vertices + v] = turn * vertexAt(at, poses, vertices, v) + shift;
    });
    return frames;
}

std::vector<FrameProvenance> variationOrigins(const TakeWarp& warp, NodeIndex firstNode)
{
    std::vector<FrameProvenance> origins;
    for (std::int64_t f = warp.frames.first.value; f <= warp.frames.last.value; ++f) {
        const auto node = static_cast<NodeIndex>(firstNode + f);
        origins.push_back({node, node, 0, false});
    }
    return origins;
}

std::vector<FrameProvenance> variationOrigins(std::span<const OriginTake> takes)
{
    assert(!takes.empty());
    if (takes.size() == 1)
        return variationOrigins(*takes.front().part.warp, takes.front().firstNode);
    std::vector<std::size_t> order(takes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](std::size_t t) { return takes[t].part.share; });
    const OriginTake& a = takes[std::min(order[0], order[1])];
    const OriginTake& b = takes[std::max(order[0], order[1])];
    const double weight = b.part.share / (a.part.share + b.part.share);
    std::vector<WarpShare> warps;
    for (const OriginTake& take : takes)
        warps.push_back(take.part);
    std::vector<FrameProvenance> origins;
    for (const double position : blendedWarp(warps).playback)
        origins.push_back({a.firstNode + nearestFrame(*a.part.warp, position),
                           b.firstNode + nearestFrame(*b.part.warp, position), weight, false});
    return origins;
}

} // namespace quadrille
