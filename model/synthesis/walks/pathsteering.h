// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/pathcourse.h"
#include "model/synthesis/walks/searchsettings.h"

#include <algorithm>

namespace quadrille {

/// How a walker who sees the path turns towards it beyond what was captured: always to where the path is a
/// little farther on, half a metre long, never by more than the limits (pure pursuit: Coulter 1992, with the
/// error of the heading in place of the arc). Refers to the course.
class PathSteering
{
public:
    /// Some frames of a walk as they would be walked without turning.
    struct Way
    {
        Vec2d end;          ///< where they lead to, metres
        double heading = 0; ///< of the way at their end, radians counter-clockwise from the first axis
        double walked = 0;  ///< metres of the walk, at their end
        double length = 0;  ///< metres of them
        double frames = 0;  ///< output frames of them
    };

    PathSteering(const PathCourse& course, const SteeringLimits& limits) : m_course(course), m_limits(limits)
    {
    }

    bool doesTurn() const { return m_limits.perMetre > 0 && m_limits.perFrame > 0; }
    /// How far a way turns at most, radians.
    double most(double length, double frames) const
    {
        return std::min(m_limits.perMetre * length, m_limits.perFrame * frames);
    }
    /// By how much a way turns, to the left; evenly by its length, around the centre of the body.
    double turnOf(const Way& way) const;

private:
    const PathCourse& m_course;
    SteeringLimits m_limits;
};

} // namespace quadrille
