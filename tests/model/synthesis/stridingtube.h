// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/ground.h"
#include "tests/model/largestdistance.h"
#include "tests/model/transition/swayingtube.h"

namespace quadrille::test {

/// A tube (z up) that sways through the same poses again and again and goes over the ground at an even pace.
struct Stride
{
    int frames = 70;
    int period = 20;   ///< frames
    GroundMotion pace; ///< from frame to frame
    double growth = 0; ///< of the swaying, per frame
};

inline Clip stridingTube(const Stride& stride, const GroundMotion& start = {})
{
    constexpr std::uint32_t around = 12;
    constexpr std::uint32_t rings = 9;
    Clip clip{.topology = tubeTopology(around, rings), .fps = 25, .positions = {}, .origins = {}};
    const Ground ground(UpAxis::Z);
    GroundMotion place = start;
    for (int f = 0; f < stride.frames; ++f) {
        const double t = 2 * std::numbers::pi * f / stride.period;
        const double size = 1 + stride.growth * f;
        const RigidMotion inSpace = place.inSpace(ground);
        for (std::uint32_t ring = 0; ring < rings; ++ring) {
            const double height = 1.8 * ring / (rings - 1);
            const double bend = size * 0.5 * height * std::sin(t);
            for (std::uint32_t k = 0; k < around; ++k) {
                const double angle = 2 * std::numbers::pi * (k + 0.3 * ring) / around;
                const Vec3d straight(0.2 * std::cos(angle), 0.12 * std::sin(angle), 0);
                const Vec3d spine(0.5 * height * bend, size * 0.1 * std::sin(2 * height + t), height);
                const Vec3d point = spine + Eigen::AngleAxisd(bend, Vec3d::UnitY()) * straight;
                clip.positions.push_back(inSpace(point).cast<float>());
            }
        }
        clip.origins.push_back({f, f, 0, false});
        place = place * stride.pace;
    }
    return clip;
}

inline std::vector<Vec3f> movedBy(const GroundMotion& motion, Positions positions, UpAxis up)
{
    std::vector<Vec3f> moved;
    for (const Vec3f& p : positions)
        moved.push_back(motion(p.cast<double>(), Ground(up)).cast<float>());
    return moved;
}

} // namespace quadrille::test
