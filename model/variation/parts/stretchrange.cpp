// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/stretchrange.h"

#include "model/geometry/poseframes.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// A map of the plane as a similar one and a mirrored one: [e −h; h e] + [f g; g −f]. The lengths of both
/// sum up to the greater principal stretch, and differ by the smaller.
struct PlaneMap
{
    double e;
    double h;
    double f;
    double g;

    /// From edges (a11, 0), (a12, a22) to (b11, 0), (b12, b22).
    PlaneMap(double a11, double a12, double a22, double b11, double b12, double b22)
    {
        const double m11 = b11 / a11;
        const double m22 = b22 / a22;
        const double m12 = (b12 - m11 * a12) / a22;
        e = 0.5 * (m11 + m22);
        f = 0.5 * (m11 - m22);
        g = 0.5 * m12;
        h = -0.5 * m12;
    }
    double similar() const { return std::hypot(e, h); }
    double mirrored() const { return std::hypot(f, g); }
    Vec2d operator()(double x, double y) const
    {
        return {(e + f) * x + (g - h) * y, (h + g) * x + (e - f) * y};
    }
};

} // namespace

StretchRange::StretchRange(const Topology& topology, Positions rest, std::span<const Positions> poses)
    : m_bounds(topology.triangles().size())
{
    const PoseFrames frames = poseFrames(topology.triangles(), rest);
    for (std::size_t t = 0; t < frames.size(); ++t)
        m_rest.push_back({frames.b11[t], frames.b12[t], frames.b22[t]});
    for (const int t : frames.degenerate)
        m_rest[static_cast<std::size_t>(t)] = {0, 0, 0};
    for (const Positions& pose : poses) {
        const PoseFrames posed = poseFrames(topology.triangles(), pose);
        for (std::size_t t = 0; t < posed.size(); ++t) {
            const auto& [a11, a12, a22] = m_rest[t];
            if (a22 == 0 || std::ranges::binary_search(posed.degenerate, static_cast<int>(t)))
                continue;
            const PlaneMap map(a11, a12, a22, posed.b11[t], posed.b12[t], posed.b22[t]);
            Bounds& bounds = m_bounds[t];
            bounds.least = std::min(bounds.least, map.similar() - map.mirrored());
            bounds.greatest = std::max(bounds.greatest, map.similar() + map.mirrored());
        }
    }
}

void StretchRange::restrict(std::span<TriangleEdges> edges) const
{
    for (std::size_t t = 0; t < m_bounds.size(); ++t) {
        const auto& [a11, a12, a22] = m_rest[t];
        const Vec3d first = Vec3d::Map(edges[t].first.data());
        const Vec3d second = Vec3d::Map(edges[t].second.data());
        const double length = first.norm();
        if (a22 == 0 || length == 0)
            continue;
        const Vec3d x = first / length;
        const double along = x.dot(second);
        const Vec3d across = second - along * x;
        const double height = across.norm();
        if (height == 0)
            continue;
        PlaneMap map(a11, a12, a22, length, along, height);
        const double similar = map.similar();
        const double mirrored = map.mirrored();
        const auto& [least, greatest] = m_bounds[t];
        if (similar + mirrored <= greatest && similar - mirrored >= least)
            continue;
        const double larger = std::clamp(similar + mirrored, least, greatest);
        const double smaller = std::clamp(similar - mirrored, least, greatest);
        const double ofSimilar = 0.5 * (larger + smaller) / similar;
        const double ofMirrored = mirrored > 0 ? 0.5 * (larger - smaller) / mirrored : 0;
        map.e *= ofSimilar;
        map.h *= ofSimilar;
        map.f *= ofMirrored;
        map.g *= ofMirrored;
        const Vec3d y = across / height;
        const Vec2d newFirst = map(a11, 0);
        const Vec2d newSecond = map(a12, a22);
        Vec3d::Map(edges[t].first.data()) = newFirst.x() * x + newFirst.y() * y;
        Vec3d::Map(edges[t].second.data()) = newSecond.x() * x + newSecond.y() * y;
    }
}

} // namespace quadrille
