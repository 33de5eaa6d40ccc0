// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/groundfit.h"

#include "model/geometry/procrustes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr double nearGround = 0.12;  // metres
constexpr double weightAbove = 1e-3; // of vertices farther up, against those on the ground

/// 1 at the lowest height, 0 from a hand's breadth above it on.
double lowness(double height)
{
    const double below = std::max(1 - height / nearGround, 0.0);
    return below * below;
}

} // namespace

GroundMotion fitOverGround(Positions pose, Positions onto, const Ground& ground)
{
    const auto heightOf = [&](const Vec3f& point) { return ground.heightOf(point.cast<double>()); };
    double lowest = std::numeric_limits<double>::infinity();
    for (const Positions& each : {pose, onto}) {
        for (const Vec3f& point : each)
            lowest = std::min(lowest, heightOf(point));
    }
    const auto weightOf = [&](std::size_t v) {
        return weightAbove + lowness(heightOf(pose[v]) - lowest) * lowness(heightOf(onto[v]) - lowest);
    };
    double sum = 0;
    Vec2d from = Vec2d::Zero();
    Vec2d to = Vec2d::Zero();
    for (std::size_t v = 0; v < pose.size(); ++v) {
        const double weight = weightOf(v);
        sum += weight;
        from += weight * ground.of(pose[v].cast<double>());
        to += weight * ground.of(onto[v].cast<double>());
    }
    from /= sum;
    to /= sum;
    // A foot alone says little of where the body looks: all vertices count alike for that.
    const Vec2d middle = ground.of(centroid(pose));
    const Vec2d middleOnto = ground.of(centroid(onto));
    double cosine = 0;
    double sine = 0;
    for (std::size_t v = 0; v < pose.size(); ++v) {
        const Vec2d a = ground.of(pose[v].cast<double>()) - middle;
        const Vec2d b = ground.of(onto[v].cast<double>()) - middleOnto;
        cosine += a.dot(b);
        sine += a.x() * b.y() - a.y() * b.x();
    }
    return GroundMotion::taking(from, to, std::atan2(sine, cosine));
}

} // namespace quadrille
