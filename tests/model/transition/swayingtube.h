// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace quadrille::test {

/// A tube of a man's size and some slanting of its triangles, 2 · around · (rings − 1) of them.
inline std::shared_ptr<const Topology> tubeTopology(std::uint32_t around, std::uint32_t rings)
{
    TopologyData data{.vertexCount = around * rings};
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
        for (std::uint32_t k = 0; k < around; ++k) {
            const VertexIndex a(ring * around + k);
            const VertexIndex b(ring * around + (k + 1) % around);
            const VertexIndex c(a.value + around);
            const VertexIndex d(b.value + around);
            data.triangles.push_back({a, b, d});
            data.triangles.push_back({a, d, c});
        }
    }
    return std::make_shared<Topology>(std::move(data));
}

/// The tube bent, twisted, thickened, turned and moved over time.
/// \param step  of time from frame to frame; 1 is fast, 0.001 hardly moves.
inline MeshSequence swayingTube(const std::shared_ptr<const Topology>& topology, std::uint32_t around,
                                std::int64_t frames, double step)
{
    const std::uint32_t rings = topology->vertexCount() / around;
    std::vector<Vec3f> positions;
    for (std::int64_t f = 0; f < frames; ++f) {
        const double t = step * static_cast<double>(f);
        const Eigen::Quaterniond turn(
            Eigen::AngleAxisd(2 * t, Vec3d(std::sin(t), 0.3, 1 + std::cos(t)).normalized()));
        for (std::uint32_t ring = 0; ring < rings; ++ring) {
            const double height = 1.8 * ring / (rings - 1);
            for (std::uint32_t k = 0; k < around; ++k) {
                const double angle =
                    2 * std::numbers::pi * (k + 0.3 * ring) / around + height * std::sin(1.7 * t);
                const double radius =
                    0.2 + 0.05 * std::sin(3 * height + t) + 0.02 * std::sin(2 * angle - 2 * t);
                const Vec3d straight(radius * std::cos(angle), 0.6 * radius * std::sin(angle), 0);
                const double bend = 0.9 * height * std::sin(t);
                const Vec3d spine(0.5 * height * bend, 0.1 * std::sin(2 * height + 3 * t), height);
                const Vec3d point = spine + Eigen::AngleAxisd(bend, Vec3d::UnitY()) * straight;
                positions.push_back((turn * point + Vec3d(3 * t, -t, 0.2)).cast<float>());
            }
        }
    }
    return makeSequence("tube", topology,
                        std::make_shared<MemoryFrames>(std::move(positions), topology->vertexCount()), 25);
}

} // namespace quadrille::test
