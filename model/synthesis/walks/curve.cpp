// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/constraints.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Points between the ends of a curve of which the length is known, and its last one.
template <typename Point>
void appendSampled(std::vector<Vec3d>& points, double length, double spacing, const Point& at)
{
    const auto steps = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    for (int i = 1; i <= steps; ++i)
        points.push_back(at(static_cast<double>(i) / steps));
}

Vec3d bezier(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, double t)
{
    const double u = 1 - t;
    return u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d;
}

void appendBezier(std::vector<Vec3d>& points, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                  double spacing)
{
    // No part of a cubic curve is passed faster than three times its longest handle.
    const double fastest = 3 * std::max({(b - a).norm(), (c - b).norm(), (d - c).norm()});
    appendSampled(points, fastest, spacing, [&](double t) { return bezier(a, b, c, d, t); });
}

/// The derivative at the middle of three points of a centripetal Catmull–Rom curve.
Vec3d tangent(const Vec3d& before, const Vec3d& here, const Vec3d& after)
{
    const double first = std::sqrt((here - before).norm());
    const double second = std::sqrt((after - here).norm());
    if (first == 0 || second == 0)
        return Vec3d::Zero();
    return (here - before) / first - (after - before) / (first + second) + (after - here) / second;
}

} // namespace

std::vector<Vec3d> sampleCurve(const std::vector<Vec3d>& through, double spacing, bool closed)
{
    assert(spacing > 0);
    std::vector<Vec3d> knots;
    for (const Vec3d& point : through) {
        if (knots.empty() || point != knots.back())
            knots.push_back(point);
    }
    if (closed && knots.size() > 1 && knots.front() != knots.back())
        knots.push_back(knots.front());
    if (knots.size() < 2)
        return knots;
    // Ends go on as they began: a point mirrored at the end, or the neighbour across the seam.
    const bool seam = closed && knots.size() > 3;
    const Vec3d before = seam ? knots[knots.size() - 2] : Vec3d(2 * knots[0] - knots[1]);
    const Vec3d after = seam ? knots[1] : Vec3d(2 * knots.back() - knots[knots.size() - 2]);
    std::vector<Vec3d> points{knots.front()};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const Vec3d& a = knots[i];
        const Vec3d& b = knots[i + 1];
        const double interval = std::sqrt((b - a).norm()) / 3;
        const Vec3d& previous = i > 0 ? knots[i - 1] : before;
        const Vec3d& next = i + 2 < knots.size() ? knots[i + 2] : after;
        appendBezier(points, a, a + interval * tangent(previous, a, b), b - interval * tangent(a, b, next), b,
                     spacing);
    }
    return points;
}

std::vector<Vec3d> sampleBezier(const Vec3d& from, const Vec3d& handleFrom, const Vec3d& handleTo,
                                const Vec3d& to, double spacing)
{
    assert(spacing > 0);
    std::vector<Vec3d> points{from};
    appendBezier(points, from, handleFrom, handleTo, to, spacing);
    return points;
}

} // namespace quadrille
