// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/livepath.h"

#include "model/core/badargument.h"
#include "model/live/liveroute.h"
#include "model/parametric/hybridblend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace quadrille {

namespace {

constexpr int valuesOfParameter = 7;                ///< that are tried over its range
constexpr std::array<double, 2> nearby{0.04, 0.12}; ///< shares of the range beside what is wanted by now
constexpr double lookAhead = 0.3;                   ///< metres along the route that a direction is taken over
constexpr double courseStep = 0.02;                 ///< metres
constexpr double within = 100; ///< how much more being in an obstacle costs than beside it

std::size_t firstCycle(const LiveGraph& graph)
{
    for (std::size_t space = 0; space < graph.spaces.size(); ++space) {
        if (graph.spaces[space]->isCyclic)
            return space;
    }
    refuse("No motion space goes on", "Add one with a cycle, such as walking.");
}

/// The curve that is walked: the path, around obstacles.
PathConstraint routed(const PathConstraint& path, UpAxis up, double margin)
{
    const Ground ground(up);
    std::vector<Vec2d> points;
    for (const Vec3d& point : path.points)
        points.push_back(ground.of(point));
    if (points.size() < 2 ||
        std::ranges::all_of(points, [&](const Vec2d& point) { return point == points.front(); }))
        refuse("The path has no length", "Give it two points.");
    PathConstraint route;
    for (const Vec2d& point : routeAround(points, path.obstacles, margin))
        route.points.push_back(ground.at(point, 0));
    return route;
}

LiveSettings aheadSettings(LiveSettings settings)
{
    settings.ticksPerFrame = 1;
    return settings;
}

SpacePoint middleOf(const MotionSpace& space)
{
    SpacePoint middle{};
    for (std::size_t p = 0; p < space.parameters.size(); ++p)
        middle[p] = std::midpoint(space.map.least[p], space.map.greatest[p]);
    return middle;
}

/// Where a space leads to at first, radians from where its poses look.
double directionOf(const MotionSpace& space, const SpacePoint& parameters)
{
    const NodeWeights weights = space.weights.at(space.map.placeOf(parameters));
    GroundMotion root;
    for (std::size_t frame = 0; frame <= space.frameCount() / 2; ++frame)
        root = root * blendedStep(space, frame, weights);
    return std::atan2(root.shift.y(), root.shift.x());
}

} // namespace

LivePathFollower::LivePathFollower(const std::shared_ptr<const LiveGraph>& graph,
                                   const LiveSettings& settings, const PathConstraint& path,
                                   const LivePathSettings& pathSettings)
    : m_graph(graph)
    , m_settings(pathSettings)
    , m_obstacles(path.obstacles)
    , m_course(routed(path, graph->up(), pathSettings.margin), graph->up())
    , m_ahead(graph, aheadSettings(settings), start())
{
    const double rate = graph->fps * settings.ticksPerFrame;
    m_planTicks = std::max<std::int64_t>(1, std::lround(m_settings.planSeconds * rate));
    m_patienceTicks = std::max<std::int64_t>(1, std::lround(m_settings.patience * rate));
    const LiveStart begin = start();
    m_input = {.space = begin.space, .parameters = begin.parameters, .isResponsive = true};
}

LiveStart LivePathFollower::start() const
{
    LiveStart start;
    start.space = firstCycle(*m_graph);
    start.parameters = middleOf(*m_graph->spaces[start.space]);
    start.root.turn =
        m_course.directionFrom(0, lookAhead) - directionOf(*m_graph->spaces[start.space], start.parameters);
    start.root.shift = m_course.at(0).head<2>();
    return start;
}

LivePathFollower::Place LivePathFollower::placeOf(const Vec2d& point, double from, double to) const
{
    Place nearest{from, std::numeric_limits<double>::infinity()};
    const double end = std::min(to, m_course.length());
    for (double s = from; s <= end + courseStep; s += courseStep) {
        const double walked = std::min(s, m_course.length());
        const double distance = (m_course.at(walked).head<2>() - point).norm();
        if (distance < nearest.deviation)
            nearest = {walked, distance};
    }
    return nearest;
}

void LivePathFollower::resume(const LiveState& state)
{
    const Place place = placeOf(state.track.root.shift, 0, m_course.length());
    m_walked = place.walked;
    m_deviation = place.deviation;
    m_lastProgress = state.tick;
    m_nextPlan = state.tick;
    m_isDone = hasReachedEnd();
}

const LiveInput& LivePathFollower::next(const LiveState& state)
{
    constexpr double window = 0.5; // metres that a tick can lead along the route at most
    const Place place = placeOf(state.track.root.shift, m_walked, m_walked + window);
    if (place.walked > m_walked)
        m_lastProgress = state.tick;
    m_walked = place.walked;
    m_deviation = place.deviation;
    m_isDone = hasReachedEnd() || state.tick - m_lastProgress > m_patienceTicks;
    if (!m_isDone && state.tick >= m_nextPlan) {
        m_nextPlan = state.tick + m_planTicks;
        decide(state);
    }
    return m_input;
}

double LivePathFollower::costOfObstacles(const Vec2d& point) const
{
    double cost = 0;
    for (const Obstacle& obstacle : m_obstacles) {
        const double distance = distanceFrom(obstacle, point);
        const double kept = obstacle.clearance + m_settings.margin;
        if (distance < kept)
            cost += m_settings.obstacleCost * (1 - distance / kept);
        if (distance <= 0 || distance < obstacle.clearance)
            cost += within * m_settings.obstacleCost;
    }
    return cost;
}

double LivePathFollower::costOf(const LiveState& state, const LiveInput& input)
{
    m_ahead.restore(state);
    const auto frames = static_cast<int>(std::ceil(m_settings.aheadSeconds * m_graph->fps));
    constexpr int each = 3;       // frames between places that count
    constexpr double reach = 0.6; // metres that so many frames lead along the route at most
    double cost = 0;
    int places = 0;
    double walked = m_walked;
    Vec2d before = m_ahead.root().shift;
    Vec2d way = Vec2d::Zero();
    for (int frame = 1; frame <= frames; ++frame) {
        m_ahead.tick(input);
        if (frame % each != 0)
            continue;
        const Vec2d point = m_ahead.root().shift;
        way = point - before;
        before = point;
        const Place place = placeOf(point, walked, walked + reach);
        walked = place.walked;
        const double share = place.deviation / m_settings.deviation;
        cost += share * share + costOfObstacles(point);
        ++places;
        if (walked >= m_course.length() - arrival)
            break; // what comes then does not count
    }
    cost /= places;
    const double away =
        std::atan2(way.y(), way.x()) - m_course.directionFrom(std::min(walked, m_course.length()), lookAhead);
    cost += m_settings.headingCost * (1 - std::cos(away));
    cost -= m_settings.progressGain * (walked - m_walked);
    if (input.space != m_input.space)
        return cost + m_settings.spaceCost;
    const ParameterMap& map = m_graph->spaces[input.space]->map;
    for (std::size_t p = 0; p < static_cast<std::size_t>(map.dimension); ++p)
        cost += m_settings.parameterCost * std::abs(input.parameters[p] - m_input.parameters[p]) /
                (map.greatest[p] - map.least[p]);
    return cost;
}

void LivePathFollower::consider(const LiveState& state, const LiveInput& input)
{
    const double cost = costOf(state, input);
    if (cost < m_bestCost) {
        m_bestCost = cost;
        m_best = input;
    }
}

/// Looks for the best parameters of a space, one after the other.
void LivePathFollower::improve(const LiveState& state, std::size_t space)
{
    const ParameterMap& map = m_graph->spaces[space]->map;
    LiveInput tried = m_input;
    if (space != m_input.space)
        tried = {.space = space, .parameters = middleOf(*m_graph->spaces[space]), .isResponsive = true};
    consider(state, tried);
    for (std::size_t p = 0; p < static_cast<std::size_t>(map.dimension); ++p) {
        if (m_best.space == space)
            tried = m_best;
        const double range = map.greatest[p] - map.least[p];
        const double present = tried.parameters[p];
        for (int value = 0; value < valuesOfParameter; ++value) {
            tried.parameters[p] = map.least[p] + range * value / (valuesOfParameter - 1);
            consider(state, tried);
        }
        for (const double share : nearby) {
            for (const double sign : {-1.0, 1.0}) {
                tried.parameters[p] =
                    std::clamp(present + sign * share * range, map.least[p], map.greatest[p]);
                consider(state, tried);
            }
        }
        tried.parameters[p] = present;
    }
}

void LivePathFollower::decide(const LiveState& state)
{
    m_bestCost = std::numeric_limits<double>::infinity();
    for (std::size_t space = 0; space < m_graph->spaces.size(); ++space) {
        const bool leads = space == state.track.space || m_graph->leads(state.track.space, space);
        if (m_graph->spaces[space]->isCyclic && leads)
            improve(state, space);
    }
    m_input = m_best;
}

} // namespace quadrille
