// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/mirror.h"

#include "model/core/error.h"
#include "model/geometry/procrustes.h"

#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

double heightOf(Positions pose, const Ground& ground)
{
    double low = std::numeric_limits<double>::max();
    double high = -low;
    for (const Vec3f& p : pose) {
        low = std::min(low, ground.heightOf(p.cast<double>()));
        high = std::max(high, ground.heightOf(p.cast<double>()));
    }
    return high - low;
}

} // namespace

Vec2d MirrorLine::reflected(const Vec2d& p) const
{
    const Vec2d from = p - point;
    return point + 2 * direction.dot(from) * direction - from;
}

MirrorLine mirrorLine(const Clip& clip, const Symmetry& symmetry, UpAxis up)
{
    const Ground ground(up);
    // Together with its counterparts a mesh has its centre in its middle, however its vertices are spread.
    const auto centreOf = [&](std::int64_t frame) -> Vec2d {
        const Positions pose = clip.frame(frame);
        return ground.of((centroid(pose) + centroid(counterparts(symmetry, pose))) / 2);
    };
    const Positions first = clip.frame(0);
    MirrorLine line{.point = centreOf(0)};
    const Vec2d way = centreOf(clip.frameCount() - 1) - line.point;
    if (way.norm() > 0.25 * heightOf(first, ground)) {
        line.direction = way.normalized();
        return line;
    }
    const Vec2d side = ground.of(reflectionPlane(first, counterparts(symmetry, first)).normal);
    if (side.norm() > 1e-3)
        line.direction = Vec2d(-side.y(), side.x()).normalized();
    return line;
}

Clip mirrored(const Clip& clip, const Symmetry& symmetry, const MirrorLine& line, UpAxis up,
              const Progress& progress)
{
    progress.report(0.0);
    if (symmetry.vertexCount() != clip.topology->vertexCount())
        throw Error(ErrorCode::VertexCountMismatch,
                    {{},
                     {},
                     {{"expected", std::to_string(clip.topology->vertexCount())},
                      {"found", std::to_string(symmetry.vertexCount())}}});
    const Ground ground(up);
    Clip result = clip;
    for (FrameProvenance& origin : result.origins)
        origin.mirrored = !origin.mirrored;
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        progress.report(f, clip.frameCount());
        const std::vector<Vec3f> places = counterparts(symmetry, clip.frame(f));
        std::ranges::transform(places, result.frame(f).begin(), [&](const Vec3f& place) -> Vec3f {
            const Vec3d p = place.cast<double>();
            return ground.at(line.reflected(ground.of(p)), ground.heightOf(p)).cast<float>();
        });
    }
    progress.report(1.0);
    return result;
}

GroundMotion mirrored(const GroundMotion& motion, const MirrorLine& line)
{
    const Vec2d origin = line.reflected(motion(line.reflected(Vec2d::Zero())));
    return {-motion.turn, origin};
}

Loop mirrored(const Loop& loop, const Symmetry& symmetry, const MirrorLine& line, UpAxis up,
              const Progress& progress)
{
    return {.cycle = mirrored(loop.cycle, symmetry, line, up, progress),
            .travel = mirrored(loop.travel, line),
            .closure = loop.closure};
}

} // namespace quadrille
