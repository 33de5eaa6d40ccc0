// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathsteering.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

double PathSteering::turnOf(const Way& way) const
{
    constexpr double ahead = 0.8;   // metres
    constexpr double mending = 0.5; // metres in which an error of the heading would be gone
    const double limit = most(way.length, way.frames);
    if (limit <= 0)
        return 0;
    const Vec2d aim = m_course.at(way.walked + ahead).head<2>() - way.end;
    const double off = wrappedAngle(std::atan2(aim.y(), aim.x()) - way.heading);
    return std::clamp(off * std::min(1.0, way.length / mending), -limit, limit);
}

} // namespace quadrille
