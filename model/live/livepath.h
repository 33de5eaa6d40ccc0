// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/liveplayer.h"
#include "model/synthesis/walks/pathcourse.h"

#include <memory>
#include <vector>

namespace quadrille {

struct LivePathSettings
{
    double planSeconds = 0.1;    ///< between decisions
    double aheadSeconds = 1.2;   ///< that each way is played ahead
    double deviation = 0.1;      ///< metres beside the route that cost 1
    double headingCost = 0.5;    ///< of looking away from where the route leads, at the end of a way
    double progressGain = 0.3;   ///< of a metre along the route
    double spaceCost = 0.15;     ///< of going over to another space
    double parameterCost = 0.05; ///< of another parameter, for all of its range
    double obstacleCost = 3;     ///< of being where an obstacle is
    double margin = 0.1;         ///< that the route keeps from obstacles beyond their clearance, metres
    double patience = 3;         ///< seconds without progress after which it gives up
};

/// Steers a player along a path over the ground, around obstacles (IA4D Fig. 8c): tells at each tick what is
/// wanted. Again and again it plays some seconds ahead what the spaces with a cycle can do – each with its
/// parameters from least to greatest, and near those that are wanted by now – and takes what stays nearest to
/// the route, makes way along it, and keeps clear of obstacles (the dynamic window of Fox, Burgard & Thrun
/// 1997, over motion spaces in place of velocities). It knows nothing of what spaces are for.
///
/// The same states give the same inputs. One thread at a time.
class LivePathFollower
{
public:
    /// \param path  metres; spans and heights do not count. \throws Error as routeAround, LivePlayer;
    /// BadArgument (a path without length, no space with a cycle).
    LivePathFollower(const std::shared_ptr<const LiveGraph>& graph, const LiveSettings& settings,
                     const PathConstraint& path, const LivePathSettings& pathSettings = {});

    /// At the beginning of the route, looking along it, in the first space with a cycle.
    LiveStart start() const;
    /// Along it, metres.
    const PathCourse& route() const { return m_course; }
    const std::vector<Obstacle>& obstacles() const { return m_obstacles; }

    /// What is wanted at the next tick of a player in this state. Cost: some microseconds; a decision plays
    /// each way ahead, in some milliseconds.
    const LiveInput& next(const LiveState& state);
    /// Goes on from a state that does not follow the last one: at the place of the route that is nearest.
    void resume(const LiveState& state);

    /// Whether there is no further to go: the end was reached, or nothing leads nearer to it.
    bool isDone() const { return m_isDone; }
    bool hasReachedEnd() const { return m_walked >= m_course.length() - arrival; }
    /// How far along the route the body is, metres.
    double walked() const { return m_walked; }
    /// How far beside it, metres.
    double deviation() const { return m_deviation; }

private:
    static constexpr double arrival = 0.15; ///< metres before the end that count as the end

    struct Place
    {
        double walked = 0;
        double deviation = 0;
    };

    /// The place of the route that a point is nearest to, not before another one.
    Place placeOf(const Vec2d& point, double from, double to) const;
    void decide(const LiveState& state);
    /// The cost of wanting an input from a state on.
    double costOf(const LiveState& state, const LiveInput& input);
    double costOfObstacles(const Vec2d& point) const;
    void improve(const LiveState& state, std::size_t space);
    void consider(const LiveState& state, const LiveInput& input);

    std::shared_ptr<const LiveGraph> m_graph;
    LivePathSettings m_settings;
    std::vector<Obstacle> m_obstacles;
    PathCourse m_course;
    LivePlayer m_ahead; ///< plays ahead, a tick a frame
    std::int64_t m_planTicks = 1;
    std::int64_t m_patienceTicks = 1;
    std::int64_t m_nextPlan = 0;
    std::int64_t m_lastProgress = 0;
    double m_walked = 0;
    double m_deviation = 0;
    bool m_isDone = false;
    LiveInput m_input;
    LiveInput m_best;
    double m_bestCost = 0;
};

} // namespace quadrille
