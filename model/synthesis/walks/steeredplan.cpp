// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/steeredplan.h"

#include "model/synthesis/walks/travel.h"

#include <cassert>

namespace quadrille {

namespace {

/// Goes along a plan and puts each frame where the walk has turned to.
class Steerer
{
public:
    Steerer(ClipPlan& plan, const PathCourse& course, const SteeringLimits& limits)
        : m_plan(plan), m_course(course), m_ground(plan.up), m_steering(course, limits)
    {
        m_end = course.pointOf(plan.frames.front().centre);
        m_here = m_end.head<2>();
    }

    /// Goes on to a frame. \param heading  of what it shows as captured.
    void goTo(std::int64_t last, double heading)
    {
        std::vector<double> lengths; // walked at each frame on the way
        for (std::int64_t f = m_frame + 1; f <= last; ++f) {
            const Vec3d point = m_course.pointOf(frame(f).centre);
            lengths.push_back((lengths.empty() ? 0 : lengths.back()) + (point - m_end).norm());
            m_end = point;
        }
        const double length = lengths.back();
        m_walked += length;
        const double turn =
            m_steering.turnOf({.end = m_motion(Vec2d(m_end.head<2>())),
                               .heading = m_motion.turn + frame(last).placeDestination.turn + heading,
                               .walked = m_walked,
                               .length = length,
                               .frames = static_cast<double>(lengths.size())});
        double before = 0;
        for (const double walked : lengths) {
            const double part = length > 0 ? turn * (walked - before) / length : 0;
            before = walked;
            m_motion = GroundMotion::taking(m_here, m_here, part) * m_motion;
            ++m_frame;
            m_here = m_motion(Vec2d(m_course.pointOf(frame(m_frame).centre).head<2>()));
            move(frame(m_frame));
        }
    }

private:
    PlannedFrame& frame(std::int64_t index) { return m_plan.frames[static_cast<std::size_t>(index)]; }

    void move(PlannedFrame& frame) const
    {
        const GroundMotion motion{m_motion.turn, m_motion.shift / m_course.metresPerUnit()};
        frame.placeSource = motion * frame.placeSource;
        frame.placeDestination = motion * frame.placeDestination;
        frame.centre = motion(frame.centre, m_ground);
    }

    ClipPlan& m_plan;
    const PathCourse& m_course;
    Ground m_ground;
    PathSteering m_steering;
    GroundMotion m_motion;    ///< from where a frame would be without turns, metres
    std::int64_t m_frame = 0; ///< that it has come to
    Vec3d m_end;              ///< its point without turns
    Vec2d m_here;             ///< and with them
    double m_walked = 0;      ///< metres
};

} // namespace

ClipPlan steeredPlan(ClipPlan plan, const RootPoses& roots, const FrameLayout& layout,
                     const PathCourse& course, const SteeringLimits& limits)
{
    assert(!plan.frames.empty());
    if (course.length() <= 0 || !PathSteering(course, limits).doesTurn())
        return plan;
    std::vector<Vec3d> points;
    points.reserve(roots.centres.size());
    for (const Vec3d& centre : roots.centres)
        points.push_back(course.pointOf(centre));
    Steerer steerer(plan, course, limits);
    auto junction = plan.junctions.begin();
    for (std::int64_t f = 1; f < plan.frameCount(); ++f) {
        while (junction != plan.junctions.end() && junction->first < f - 1)
            ++junction;
        if (junction != plan.junctions.end() && junction->first == f - 1)
            f = std::max(f, junction->last);
        steerer.goTo(f,
                     headingAt(points, layout, plan.frames[static_cast<std::size_t>(f)].origin.destination));
    }
    return plan;
}

} // namespace quadrille
