// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/procrustes.h"
#include "model/sequence/meshsequence.h"
#include "tests/model/transition/swayingtube.h"

#include <functional>
#include <string>
#include <vector>

namespace quadrille::test {

/// The pose of a tube at a phase, radians: never the same twice within a turn.
inline std::vector<Vec3f> swayedTube(double phase, double size = 1)
{
    constexpr std::uint32_t around = 8;
    constexpr std::uint32_t rings = 7;
    std::vector<Vec3f> positions;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        const double height = 1.8 * ring / (rings - 1);
        const double bend = size * 0.4 * height * std::sin(phase);
        const double twist = size * 0.5 * height * std::cos(phase);
        for (std::uint32_t k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around + twist;
            const Vec3d straight(0.2 * std::cos(angle), 0, 0.12 * std::sin(angle));
            const Vec3d spine(0.5 * height * bend, height, 0.1 * size * std::sin(2 * height + phase));
            positions.push_back((spine + Eigen::AngleAxisd(-bend, Vec3d::UnitZ()) * straight).cast<float>());
        }
    }
    return positions;
}

inline std::shared_ptr<const Topology> swayingTopology()
{
    static const auto topology = tubeTopology(8, 7);
    return topology;
}

/// A take of the tube: its phase and its place at each frame.
inline MeshSequence swayingTake(
    const std::string& name, int frames, const std::function<double(int)>& phaseAt,
    const std::function<RigidMotion(int)>& placeAt = [](int) { return RigidMotion(); }, double size = 1)
{
    std::vector<Vec3f> positions;
    for (int f = 0; f < frames; ++f) {
        const RigidMotion place = placeAt(f);
        for (const Vec3f& p : swayedTube(phaseAt(f), size))
            positions.push_back(place(p.cast<double>()).cast<float>());
    }
    const auto topology = swayingTopology();
    return makeSequence(name, topology,
                        std::make_shared<MemoryFrames>(std::move(positions), topology->vertexCount()), 25);
}

/// Going ahead along a curve, up and down a little: y is up.
inline RigidMotion strideAt(int frame)
{
    const double t = 0.04 * frame;
    return {Eigen::Quaterniond(Eigen::AngleAxisd(0.4 * t, Vec3d::UnitY()) *
                               Eigen::AngleAxisd(0.1 * std::sin(5 * t), Vec3d::UnitX())),
            {1.2 * t, 0.03 * std::sin(9 * t), 0.5 * t * t}};
}

inline double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b)
{
    return a.angularDistance(b);
}

} // namespace quadrille::test
