// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/livepath.h"

#include "model/core/badargument.h"
#include "model/live/routearound.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// The curve that is walked: the path, around obstacles.
PathCourse routeOf(const PathConstraint& path, UpAxis up, const LivePathSettings& settings)
{
    if (!(settings.planSeconds > 0) || !(settings.tolerance > 0))
        refuse("The time of a plan, or the tolerance of a path, is not positive", "Give it one that is.");
    const Ground ground(up);
    std::vector<Vec2d> points;
    for (const Vec3d& point : path.points)
        points.push_back(ground.of(point));
    if (std::ranges::all_of(points, [&](const Vec2d& point) { return point == points.front(); }))
        refuse("The path has no length", "Give it two points.");
    PathConstraint route;
    for (const Vec2d& point : routeAround(points, path.obstacles, {.margin = settings.margin}))
        route.points.push_back(ground.at(point, 0));
    return PathCourse(route, up);
}

} // namespace

LivePathFollower::LivePathFollower(const std::shared_ptr<const LiveGraph>& graph, const LiveSettings& live,
                                   const PathConstraint& path, const LivePathSettings& settings)
    : m_settings(settings)
    , m_plan(*graph, live, routeOf(path, graph->up(), settings), path.obstacles, settings)
    , m_input{.space = start().space, .parameters = start().parameters, .isResponsive = true}
    , m_planFrames(std::max(1, static_cast<int>(std::lround(settings.planSeconds * graph->fps))))
    , m_planTicks(m_planFrames * live.ticksPerFrame)
    , m_tickSeconds(1 / (graph->fps * live.ticksPerFrame))
{
}

void LivePathFollower::resume(const LiveState& state, double walked)
{
    m_input = m_plan.wantedIn(state);
    m_place = {walked, 0};
    m_tick = 0;
    m_furthest = walked;
    m_waited = 0;
    m_isDone = false;
    m_hasReachedEnd = false;
}

void LivePathFollower::move(const LiveState& state)
{
    constexpr double further = 0.25; // metres
    const Vec2d centre = m_plan.centreOf(state);
    m_place = placeOn(route(), centre, m_place.along);
    m_waited += m_tickSeconds;
    if (m_place.along >= m_furthest + further) {
        m_furthest = m_place.along;
        m_waited = 0;
    }
    m_isDone = m_place.along >= route().length() || m_waited > m_settings.patience;
    const Vec2d end = route().at(route().length()).head<2>();
    m_hasReachedEnd = m_isDone && (end - centre).norm() <= m_settings.endRadius;
}

LiveInput LivePathFollower::next(const LiveState& state)
{
    if (!m_isDone)
        move(state);
    if (m_isDone)
        return m_input;
    const int tick = static_cast<int>(m_tick % m_planTicks);
    if (tick == 0) {
        if (m_tick > 0)
            m_input = m_plan.best();
        m_plan.begin(m_plan.after(state, m_input, m_planFrames), m_place.along, m_input);
    }
    m_plan.advance(tick, m_planTicks);
    ++m_tick;
    return m_input;
}

} // namespace quadrille
