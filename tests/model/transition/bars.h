// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace quadrille {

/// A tube of square section along x, open at both ends unless closed: a mesh of about rings × 4 · side quads.
struct Bar
{
    std::shared_ptr<const Topology> topology;
    std::vector<Vec3f> positions;
};

inline Bar makeBar(int rings, int side, float length, float width, bool closed = true, int copies = 1)
{
    TopologyData data;
    Bar bar;
    const int around = 4 * side;
    for (int copy = 0; copy < copies; ++copy) {
        const auto first = static_cast<std::uint32_t>(bar.positions.size());
        const float aside = 3.0F * width * static_cast<float>(copy);
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            data.triangles.push_back(
                {VertexIndex(first + a), VertexIndex(first + b), VertexIndex(first + c)});
        };
        for (int r = 0; r < rings; ++r) {
            const float x = length * static_cast<float>(r) / static_cast<float>(rings - 1);
            for (int k = 0; k < around; ++k) {
                const float t = static_cast<float>(k % side) / static_cast<float>(side) - 0.5F;
                const std::array<Vec2f, 4> corners{Vec2f(t, -0.5F), Vec2f(0.5F, t), Vec2f(-t, 0.5F),
                                                   Vec2f(-0.5F, -t)};
                const Vec2f yz = corners[static_cast<std::size_t>(k / side)] * width;
                bar.positions.emplace_back(x, yz.x() + aside, yz.y());
            }
        }
        const auto index = [around](int r, int k) {
            return static_cast<std::uint32_t>(r * around + k % around);
        };
        for (int r = 0; r + 1 < rings; ++r) {
            for (int k = 0; k < around; ++k) {
                add(index(r, k), index(r, k + 1), index(r + 1, k + 1));
                add(index(r, k), index(r + 1, k + 1), index(r + 1, k));
            }
        }
        if (closed) {
            const std::uint32_t front = index(rings, 0);
            bar.positions.emplace_back(0.0F, aside, 0.0F);
            bar.positions.emplace_back(length, aside, 0.0F);
            for (int k = 0; k < around; ++k) {
                add(front, index(0, k + 1), index(0, k));
                add(front + 1, index(rings - 1, k), index(rings - 1, k + 1));
            }
        }
    }
    data.vertexCount = static_cast<std::uint32_t>(bar.positions.size());
    bar.topology = std::make_shared<const Topology>(std::move(data));
    return bar;
}

inline std::vector<Vec3f> moved(const std::vector<Vec3f>& positions,
                                const std::function<Vec3d(const Vec3d&)>& move)
{
    std::vector<Vec3f> out;
    out.reserve(positions.size());
    for (const Vec3f& position : positions)
        out.push_back(move(position.cast<double>()).cast<float>());
    return out;
}

/// Bends a bar along x upwards (z) to an arc of an angle; its middle line keeps its length.
inline std::vector<Vec3f> bent(const std::vector<Vec3f>& positions, double length, double angle)
{
    const double radius = length / angle;
    return moved(positions, [&](const Vec3d& p) -> Vec3d {
        const double phi = p.x() / radius;
        return {(radius - p.z()) * std::sin(phi), p.y(), radius - (radius - p.z()) * std::cos(phi)};
    });
}

/// Twists a bar about x, by an angle from end to end.
inline std::vector<Vec3f> twisted(const std::vector<Vec3f>& positions, double length, double angle)
{
    return moved(positions, [&](const Vec3d& p) -> Vec3d {
        const double phi = angle * p.x() / length;
        return {p.x(), std::cos(phi) * p.y() - std::sin(phi) * p.z(),
                std::sin(phi) * p.y() + std::cos(phi) * p.z()};
    });
}

/// Adds noise, so that no two triangles are alike.
inline std::vector<Vec3f> shaken(const std::vector<Vec3f>& positions, double size, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> real(-size, size);
    return moved(positions, [&](const Vec3d& p) -> Vec3d {
        const double x = real(random);
        const double y = real(random);
        return p + Vec3d(x, y, real(random));
    });
}

} // namespace quadrille
