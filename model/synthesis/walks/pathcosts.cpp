// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathcosts.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

PathCosts::PathCosts(const PathCourse& course, const std::vector<PathSpan>& spans, NodeIndex nodes,
                     double beta, const PathCharging& charging, const SteeringLimits& steering)
    : m_course(course), m_beta(beta), m_charging(charging), m_steering(course, steering)
{
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const PathSpan& span = spans[i];
        if (span.duration)
            m_timed.push_back({span.from, span.to, *span.duration});
        if (!span.demanded)
            continue;
        Demand demand{.from = span.from, .to = span.to, .span = static_cast<int>(i)};
        demand.frames.assign(static_cast<std::size_t>(nodes), false);
        for (const WalkSpan& frames : span.demanded->spans) {
            for (NodeIndex node = frames.first; node <= frames.last; ++node)
                demand.frames[static_cast<std::size_t>(node)] = true;
        }
        m_demands.push_back(std::move(demand));
    }
    std::sort(m_timed.begin(), m_timed.end(), [](const Timed& a, const Timed& b) { return a.from < b.from; });
}

int PathCosts::missedSpan(double walked, NodeIndex source, NodeIndex destination) const
{
    for (const Demand& demand : m_demands) {
        if (walked >= demand.from && walked <= demand.to &&
            !demand.frames[static_cast<std::size_t>(source)] &&
            !demand.frames[static_cast<std::size_t>(destination)])
            return demand.span;
    }
    return -1;
}

std::optional<PathFailure> PathCosts::obstruction(const Vec3d& point, double walked, NodeIndex source,
                                                  NodeIndex destination) const
{
    const int span = missedSpan(walked, source, destination);
    if (span >= 0)
        return PathFailure{.reached = walked, .span = span};
    const int obstacle = m_course.obstacleAt(point.head<2>());
    if (obstacle >= 0)
        return PathFailure{.reached = walked, .obstacle = obstacle};
    return std::nullopt;
}

bool PathCosts::admit(const Shown& frame, PathPlace& place, PathCharge& charge, PathFailure& failure) const
{
    const double walked = frame.walked;
    if (const auto why = obstruction(frame.point, walked, frame.source, frame.destination)) {
        if (walked > failure.reached)
            failure = *why;
        return false;
    }
    charge.deviation += deviation(frame.point, walked, frame.step);
    for (; needsTime(place); ++place.timed, place.timedFrames = 0) {
        const Timed& timed = m_timed[static_cast<std::size_t>(place.timed)];
        if (walked <= timed.to) {
            place.timedFrames += walked >= timed.from ? 1 : 0;
            break;
        }
        charge.timing += m_beta * std::abs(place.timedFrames - timed.duration);
    }
    return true;
}

bool PathCosts::begin(const MoveMotions& motions, NodeIndex node, PathPlace& place, PathCharge& charge) const
{
    place = {.placement = motions.placedOnStart(node)};
    PathFailure failure;
    const Vec3d& point = motions.point(node);
    const Vec2d ground = place.placement(Vec2d(point.head<2>()));
    const Shown first{.point = {ground.x(), ground.y(), point.z()}, .source = node, .destination = node};
    return admit(first, place, charge, failure);
}

double PathCosts::turnOf(const MoveMotions::Motion& motion, const Eigen::Matrix2d& rotation,
                         const PathPlace& place) const
{
    if (!m_steering.doesTurn())
        return 0;
    const MoveMotions::Step& last = motion.steps.back();
    const auto length = static_cast<double>(last.arcLength);
    return m_steering.turnOf({.end = rotation * last.point.head<2>().cast<double>() + place.placement.shift,
                              .heading = place.placement.turn + motion.heading,
                              .walked = place.walked + length,
                              .length = length,
                              .frames = static_cast<double>(motion.steps.size())});
}

bool PathCosts::follow(const MoveMotions::Motion& motion, const Eigen::Matrix2d& rotation, PathPlace& place,
                       PathCharge& charge, PathFailure& failure, std::vector<Vec3d>* points) const
{
    const double begun = place.walked;
    const auto length = static_cast<double>(motion.steps.back().arcLength);
    const double turn = turnOf(motion, rotation, place);
    Eigen::Matrix2d turned = rotation;
    Vec2d shift = place.placement.shift;
    Vec2d here = turned * motion.begin + shift;
    double before = 0;
    for (const MoveMotions::Step& step : motion.steps) {
        const auto along = static_cast<double>(step.arcLength);
        if (turn != 0) {
            const Eigen::Matrix2d part =
                Eigen::Rotation2Dd(turn * (along - before) / length).toRotationMatrix();
            turned = part * turned;
            shift = here + part * (shift - here);
        }
        here = turned * step.point.head<2>().cast<double>() + shift;
        const Vec3d point(here.x(), here.y(), static_cast<double>(step.point.z()));
        if (points != nullptr)
            points->push_back(point);
        // The last frame of a transition is captured, too: only what it shows counts.
        const NodeIndex source = &step == &motion.steps.back() ? step.destination : step.source;
        if (!admit({.point = point,
                    .walked = begun + along,
                    .step = along - before,
                    .source = source,
                    .destination = step.destination},
                   place, charge, failure))
            return false;
        before = along;
    }
    charge.edges += motion.weight;
    place.walked = begun + length;
    place.placement = {place.placement.turn + turn + motion.exit.turn, turned * motion.exit.shift + shift};
    return true;
}

double PathCosts::timingAtEnd(const PathPlace& place) const
{
    double timing = 0;
    for (auto i = static_cast<std::size_t>(place.timed); i < m_timed.size(); ++i) {
        const double frames = i == static_cast<std::size_t>(place.timed) ? place.timedFrames : 0;
        timing += m_beta * std::abs(frames - m_timed[i].duration);
    }
    return timing;
}

double PathCosts::lateness(const PathPlace& place) const
{
    if (!needsTime(place))
        return 0;
    const Timed& timed = m_timed[static_cast<std::size_t>(place.timed)];
    const double part = std::clamp((place.walked - timed.from) / (timed.to - timed.from), 0.0, 1.0);
    return place.timedFrames - part * timed.duration;
}

} // namespace quadrille
