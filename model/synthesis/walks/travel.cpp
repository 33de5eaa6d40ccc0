// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/travel.h"

#include <cmath>

namespace quadrille {

Vec2d travelAt(std::span<const Vec3d> points, const FrameLayout& layout, NodeIndex node)
{
    // Half a metre tells a direction; what was captured may have less to show.
    constexpr double enough = 0.5;
    const int sequence = layout.sequenceOf(node);
    const auto point = [&](NodeIndex frame) { return points[static_cast<std::size_t>(frame)]; };
    const auto wayTo = [&](NodeIndex step, NodeIndex end) {
        Vec2d way = Vec2d::Zero();
        for (NodeIndex other = node; other != end && way.norm() < enough; other += step)
            way = (point(other + step) - point(node)).head<2>();
        return way;
    };
    Vec2d way = wayTo(1, layout.lastOf(sequence));
    if (way.norm() >= leastTravel)
        return way;
    Vec2d back = -wayTo(-1, layout.firstOf(sequence));
    return back.norm() > way.norm() ? back : way;
}

double headingAt(std::span<const Vec3d> points, const FrameLayout& layout, NodeIndex node)
{
    const Vec2d way = travelAt(points, layout, node);
    return std::atan2(way.y(), way.x());
}

} // namespace quadrille
