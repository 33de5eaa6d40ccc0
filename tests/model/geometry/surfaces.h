// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <vector>

namespace quadrille::test {

/// A mesh in one pose.
struct Surface
{
    TopologyData data;
    std::vector<Vec3f> pose;

    std::shared_ptr<const Topology> topology() const { return std::make_shared<const Topology>(data); }
    std::shared_ptr<const SurfaceGraph> graph() const
    {
        return std::make_shared<const SurfaceGraph>(topology(), pose);
    }
};

inline Triangle corners(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    return {VertexIndex(a), VertexIndex(b), VertexIndex(c)};
}

/// Rings of `around` vertices along y, vertex k of ring r at r · around + k; open at both ends.
/// \param radius  of each ring, by its number.
inline Surface makeTube(std::uint32_t around, std::uint32_t rings, float step,
                        const std::function<float(std::uint32_t)>& radius)
{
    Surface tube;
    tube.data.vertexCount = around * rings;
    for (std::uint32_t r = 0; r < rings; ++r) {
        for (std::uint32_t k = 0; k < around; ++k) {
            const float angle =
                2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(around);
            tube.pose.emplace_back(radius(r) * std::cos(angle), step * static_cast<float>(r),
                                   -radius(r) * std::sin(angle));
            if (r + 1 == rings)
                continue;
            const std::uint32_t here = r * around + k;
            const std::uint32_t beside = r * around + (k + 1) % around;
            tube.data.triangles.push_back(corners(here, beside, here + around));
            tube.data.triangles.push_back(corners(beside, beside + around, here + around));
        }
    }
    return tube;
}

inline Surface makeTube(std::uint32_t around, std::uint32_t rings, float step, float radius)
{
    return makeTube(around, rings, step, [radius](std::uint32_t) { return radius; });
}

/// The same, closed with a tip at each end (vertices around · rings and the one after).
inline Surface withTips(Surface tube, std::uint32_t around, float length)
{
    const std::uint32_t bottom = tube.data.vertexCount;
    const auto top = static_cast<std::uint32_t>(tube.data.vertexCount - around);
    tube.data.vertexCount += 2;
    tube.pose.push_back(Vec3f(0, tube.pose.front().y() - length, 0));
    tube.pose.push_back(Vec3f(0, tube.pose[top].y() + length, 0));
    for (std::uint32_t k = 0; k < around; ++k) {
        const std::uint32_t beside = (k + 1) % around;
        tube.data.triangles.push_back(corners(beside, k, bottom));
        tube.data.triangles.push_back(corners(top + k, top + beside, bottom + 1));
    }
    return tube;
}

/// A closed limb: radius 1, rings a sixth of a turn's length apart.
inline Surface makeCapsule(std::uint32_t around, std::uint32_t rings)
{
    const float step = 2 * std::sin(std::numbers::pi_v<float> / static_cast<float>(around));
    return withTips(makeTube(around, rings, step, 1), around, 0.5F);
}

inline Surface makeTorus(std::uint32_t around, std::uint32_t along, float radius, float thickness)
{
    Surface torus;
    torus.data.vertexCount = around * along;
    const auto turn = [](std::uint32_t i, std::uint32_t of) {
        return 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(of);
    };
    for (std::uint32_t r = 0; r < along; ++r) {
        for (std::uint32_t k = 0; k < around; ++k) {
            const float out = radius + thickness * std::cos(turn(k, around));
            torus.pose.emplace_back(out * std::cos(turn(r, along)), thickness * std::sin(turn(k, around)),
                                    out * std::sin(turn(r, along)));
            const std::uint32_t here = r * around + k;
            const std::uint32_t beside = r * around + (k + 1) % around;
            const std::uint32_t next = (r + 1) % along * around + k;
            const std::uint32_t both = (r + 1) % along * around + (k + 1) % around;
            torus.data.triangles.push_back(corners(here, beside, next));
            torus.data.triangles.push_back(corners(beside, both, next));
        }
    }
    return torus;
}

/// Vertices side by side in rows, vertex k of row r at r · columns + k; unit squares in the plane y = 0.
inline Surface makeSheet(std::uint32_t columns, std::uint32_t rows)
{
    Surface sheet;
    sheet.data.vertexCount = columns * rows;
    for (std::uint32_t r = 0; r < rows; ++r) {
        for (std::uint32_t k = 0; k < columns; ++k) {
            sheet.pose.emplace_back(static_cast<float>(k), 0.0F, -static_cast<float>(r));
            if (r + 1 == rows || k + 1 == columns)
                continue;
            const std::uint32_t here = r * columns + k;
            sheet.data.triangles.push_back(corners(here, here + 1, here + columns));
            sheet.data.triangles.push_back(corners(here + 1, here + columns + 1, here + columns));
        }
    }
    return sheet;
}

/// Moves every vertex by a random way within a box, so that no two ways are equally long.
inline Surface jittered(Surface surface, float most, std::uint32_t seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> way(-most, most);
    for (Vec3f& p : surface.pose)
        p += Vec3f(way(engine), way(engine), way(engine));
    return surface;
}

/// Both side by side, the second's vertices after the first's.
inline Surface together(Surface one, const Surface& other)
{
    for (Triangle t : other.data.triangles) {
        for (VertexIndex& v : t)
            v.value += one.data.vertexCount;
        one.data.triangles.push_back(t);
    }
    one.data.vertexCount += other.data.vertexCount;
    one.pose.insert(one.pose.end(), other.pose.begin(), other.pose.end());
    return one;
}

/// The same surface with other numbers. \param places  per vertex its new number.
inline Surface renumbered(const Surface& surface, const std::vector<std::uint32_t>& places)
{
    Surface other = surface;
    for (std::size_t v = 0; v < places.size(); ++v)
        other.pose[places[v]] = surface.pose[v];
    for (Triangle& t : other.data.triangles) {
        for (VertexIndex& v : t)
            v = VertexIndex(places[v.value]);
    }
    return other;
}

inline std::vector<std::uint32_t> shuffledPlaces(std::uint32_t count, std::uint32_t seed)
{
    std::vector<std::uint32_t> places(count);
    for (std::uint32_t v = 0; v < count; ++v)
        places[v] = v;
    std::mt19937 engine(seed);
    for (std::uint32_t v = count; v > 1; --v)
        std::swap(places[v - 1], places[engine() % v]);
    return places;
}

/// Ring `r` of a tube, in its order.
inline std::vector<VertexIndex> ring(std::uint32_t around, std::uint32_t r)
{
    std::vector<VertexIndex> vertices;
    for (std::uint32_t k = 0; k < around; ++k)
        vertices.emplace_back(r * around + k);
    return vertices;
}

inline std::set<VertexIndex> setOf(const std::vector<VertexIndex>& vertices)
{
    return {vertices.begin(), vertices.end()};
}

} // namespace quadrille::test
