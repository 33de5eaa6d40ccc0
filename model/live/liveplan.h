// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/keptclear.h"
#include "model/live/liveplayer.h"
#include "model/synthesis/walks/pathcourse.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

struct LivePathSettings
{
    double margin = 0.15;          ///< kept beyond clearances where there is room for it, metres
    double planSeconds = 0.2;      ///< from plan to plan
    double firstSeconds = 0.2;     ///< for which a candidate is played ahead
    double severalSeconds = 0.3;   ///< the same of several parameters, as fewer values of each may follow
    double nextSeconds = 0.8;      ///< and then each of what may follow
    double tolerance = 0.1;        ///< deviation that costs 1, metres
    double speedWeight = 0.3;      ///< of standing still
    double changeWeight = 0.05;    ///< of a parameter that goes over all of its range
    double transitionWeight = 0.3; ///< of wanting another space than before
    double alike = 0.1;            ///< poses that are so far apart on average are joined for nothing, metres
    double unlikenessWeight = 50;  ///< of a transition, by the mean square beyond that, 1/m²
    double patience = 4;           ///< seconds in which it gets 25 cm further, or gives up
    double endRadius = 0.5;        ///< from the end, where that counts as reached, metres

    bool operator==(const LivePathSettings&) const = default;
};

/// Where a point is beside a route.
struct RoutePlace
{
    double along = 0; ///< arc length of the nearest point of the route, metres
    double off = 0;   ///< distance from it, metres
};

/// The nearest point of a route that is no more than a metre on from an arc length.
RoutePlace placeOn(const PathCourse& route, const Vec2d& point, double from);

/// What a player should want to follow a route: candidates are all spaces with a cycle, with some values of
/// their parameters, then finer ones around the best. Each is played ahead, then what may follow; it costs
/// what the best of these does: the dynamic window of Fox, Burgard & Thrun 1997, over motion spaces in place
/// of velocities. It knows nothing of what spaces are for.
class LivePlan
{
public:
    /// \throws Error BadArgument as LivePlayer; no space with a cycle.
    LivePlan(const LiveGraph& graph, const LiveSettings& live, PathCourse route,
             const std::vector<Obstacle>& obstacles, const LivePathSettings& settings);

    const PathCourse& route() const { return m_route; }
    const std::vector<Obstacle>& obstacles() const { return m_obstacles; }
    /// Where a player best begins: at the start of the route, going along it, in the middle of the parameters
    /// of the space with a cycle that stays on it best.
    LiveStart start() const { return m_begin; }
    /// What was wanted last in a state, as far as it tells.
    LiveInput wantedIn(const LiveState& state) const;
    /// Where the body's centre is in a state.
    Vec2d centreOf(const LiveState& state);
    /// The state after some frames of an input.
    LiveState after(const LiveState& state, const LiveInput& input, int frames);

    /// A plan from a state. \param present  what is wanted there: other wishes cost more.
    void begin(const LiveState& from, double walked, const LiveInput& present);
    /// Tries the next candidates: a share of all. Allocates nothing.
    void advance(int share, int shares);
    /// The best of those that were tried.
    const LiveInput& best() const { return m_best; }

private:
    static constexpr std::size_t trailLength = 4; ///< samples

    struct Walked
    {
        LiveState state;
        double along = 0;
        double cost = 0;
        int samples = 0;
        int allSamples = 1;                   ///< until it ends
        std::array<Vec2d, trailLength> trail; ///< of the last samples
    };

    std::size_t dimensionOf(std::size_t space) const;
    bool canPlay(std::size_t space) const;
    /// For which a candidate is played ahead.
    int firstSamples(std::size_t space) const;
    std::optional<LiveInput> candidate();
    void addCandidates(std::size_t space);
    LiveStart bestStart();
    double costOf(const LiveInput& input, double bound);
    double changeCost(const LiveInput& from, const LiveInput& to) const;
    bool play(Walked& walked, const LiveInput& input, int samples, double bound);
    /// Of the transition that the player has decided on.
    double unlikenessCost() const;
    double obstacleCost(const Vec2d& point) const;
    double endCost(const Walked& walked) const;

    std::shared_ptr<const LiveGraph> m_graph; ///< with few vertices
    PathCourse m_route;
    LivePathSettings m_settings;
    std::vector<Obstacle> m_obstacles;
    std::vector<KeptClear> m_kept; ///< by their clearances and the margin
    LivePlayer m_player;
    double m_vertices; ///< of the meshes that are played
    int m_sampleFrames = 1;
    int m_firstSamples = 1;
    int m_severalSamples = 1; ///< in place of the first, of several parameters
    int m_nextSamples = 1;
    double m_sampleSeconds = 0;
    double m_fastest = 0; ///< of the spaces, metres a second
    std::vector<LiveInput> m_coarse;
    std::vector<SpacePoint> m_steps; ///< of each space: from one coarse value to the next
    std::vector<LiveInput> m_next;
    LiveStart m_begin;
    Walked m_start;
    LiveInput m_present;
    LiveInput m_best;
    LiveInput m_base; ///< around which a round refines
    double m_bestCost = 0;
    std::size_t m_tried = 0;
    std::size_t m_count = 0;
    std::size_t m_dimension = 0; ///< greatest of the spaces
};

} // namespace quadrille
