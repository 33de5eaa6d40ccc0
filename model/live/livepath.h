// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/liveplan.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace quadrille {

/// Steers a player along a path over the ground, around obstacles (IA4D Fig. 8c): five times a second it
/// plays ahead what it could want, and wants what comes out nearest to the route. What is wanted next is
/// planned while the last is played, from where that leads, some at each tick.
///
/// A graph that cannot turn far enough goes as near to the route as it can. The same states give the same
/// inputs, to the bit: what was wanted is a recording. One thread at a time.
class LivePathFollower
{
public:
    /// \param live  of the player. \param path  metres; heights and spans do not count.
    /// \throws Error as routeAround, LivePlayer; BadArgument (a path without length, no space with a cycle,
    /// settings that make no sense).
    LivePathFollower(const std::shared_ptr<const LiveGraph>& graph, const LiveSettings& live,
                     const PathConstraint& path, const LivePathSettings& settings = {});

    /// At the beginning of the route, going along it, in the space that stays on it best.
    LiveStart start() const { return m_plan.start(); }
    /// The path, around the obstacles, metres.
    const PathCourse& route() const { return m_plan.route(); }
    const std::vector<Obstacle>& obstacles() const { return m_plan.obstacles(); }

    /// What is wanted at the next tick of a player in this state; to be asked at every tick. Once it is done,
    /// the same as before. Allocates nothing. Cost: a share of a plan, some hundred microseconds.
    LiveInput next(const LiveState& state);
    /// Goes on from a state that does not follow the last one, with what was wanted there. \param walked  how
    /// far it was then, or a little less.
    void resume(const LiveState& state, double walked);

    /// Whether there is no further to go: the end was passed, or nothing leads nearer to it.
    bool isDone() const { return m_isDone; }
    bool hasReachedEnd() const { return m_hasReachedEnd; } ///< done, and near the end
    /// How far along the route the body is, metres.
    double walked() const { return m_place.along; }
    /// How far beside it the body's centre is, metres.
    double deviation() const { return m_place.off; }

private:
    void move(const LiveState& state);

    LivePathSettings m_settings;
    LivePlan m_plan;
    LiveInput m_input;
    RoutePlace m_place;
    int m_planFrames;        ///< from plan to plan
    int m_planTicks;         ///< the same
    double m_tickSeconds;    ///< of the player
    std::int64_t m_tick = 0; ///< since it began, or went on anew
    double m_furthest = 0;   ///< walked when patience began anew
    double m_waited = 0;     ///< seconds since then
    bool m_isDone = false;
    bool m_hasReachedEnd = false;
};

} // namespace quadrille
