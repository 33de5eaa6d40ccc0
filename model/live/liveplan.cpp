// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/liveplan.h"

#include "model/core/badargument.h"
#include "model/live/thinnedgraph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace quadrille {

namespace {

constexpr double sampleSeconds = 0.1;
constexpr std::size_t mostVertices = 400; ///< that tell where a transition leads
constexpr std::size_t refinements = 2;    ///< each with half the step of the one before

double square(double value)
{
    return value * value;
}

/// As the square of how many tolerances it is off; in proportion where it is lost anyway.
double deviationCost(double tolerances)
{
    constexpr double knee = 3;
    return tolerances < knee ? square(tolerances) : knee * (2 * tolerances - knee);
}

/// Ticks of whole frames: states mean the same, and looking ahead is half the work.
LiveSettings aheadOf(LiveSettings live)
{
    live.ticksPerFrame = 1;
    return live;
}

SpacePoint middleOf(const MotionSpace& space)
{
    SpacePoint middle{};
    for (std::size_t d = 0; d < middle.size(); ++d)
        middle[d] = std::midpoint(space.map.least[d], space.map.greatest[d]);
    return middle;
}

/// In the first space with a cycle, in the middle of its parameters.
LiveStart usualIn(const LiveGraph& graph)
{
    for (std::size_t space = 0; space < graph.spaces.size(); ++space) {
        if (graph.spaces[space]->isCyclic)
            return {.space = space, .parameters = middleOf(*graph.spaces[space]), .frame = 0, .root = {}};
    }
    refuse("No motion space goes on", "Add one with a cycle, such as walking.");
}

double fastestOf(const MotionSpace& space)
{
    double fastest = 0;
    for (const SpaceTake& take : space.takes) {
        double length = 0;
        double seconds = 0;
        for (std::size_t f = 0; f < take.steps.size(); ++f) {
            length += take.steps[f].shift.norm();
            seconds += take.seconds[f];
        }
        fastest = std::max(fastest, length / seconds);
    }
    return fastest;
}

double angleOf(const Vec2d& way)
{
    return std::atan2(way.y(), way.x());
}

} // namespace

RoutePlace placeOn(const PathCourse& route, const Vec2d& point, double from)
{
    constexpr double reach = 1;
    constexpr double step = 0.05;
    double nearest = from;
    double least = (route.at(from).head<2>() - point).squaredNorm();
    for (double s = from + step; s <= from + reach; s += step) {
        const double distance = (route.at(s).head<2>() - point).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = s;
        }
    }
    // Between the points that were looked at the route is nearly straight.
    const Vec2d way = (route.at(nearest + step / 2) - route.at(std::max(0.0, nearest - step / 2))).head<2>();
    const double length = way.norm();
    if (length > 0) {
        const double on = (point - route.at(nearest).head<2>()).dot(way) / length;
        nearest = std::max(from, nearest + std::clamp(on, -step / 2, step / 2));
    }
    return {nearest, (route.at(nearest).head<2>() - point).norm()};
}

LivePlan::LivePlan(const LiveGraph& graph, const LiveSettings& live, PathCourse route,
                   const std::vector<Obstacle>& obstacles, const LivePathSettings& settings)
    : m_graph(thinnedGraph(graph, mostVertices))
    , m_route(std::move(route))
    , m_settings(settings)
    , m_obstacles(obstacles)
    , m_player(m_graph, aheadOf(live), usualIn(*m_graph))
    , m_vertices(static_cast<double>(graph.vertexCount()))
{
    for (const Obstacle& obstacle : m_obstacles)
        m_kept.emplace_back(obstacle, obstacle.clearance + settings.margin);
    const auto countOf = [](double seconds, double each) {
        return std::max(1, static_cast<int>(std::lround(seconds / each)));
    };
    m_sampleFrames = countOf(sampleSeconds, 1 / m_graph->fps);
    m_sampleSeconds = m_sampleFrames / m_graph->fps;
    m_firstSamples = countOf(settings.firstSeconds, m_sampleSeconds);
    m_severalSamples = countOf(settings.severalSeconds, m_sampleSeconds);
    m_nextSamples = countOf(settings.nextSeconds, m_sampleSeconds);
    m_steps.resize(m_graph->spaces.size());
    for (std::size_t space = 0; space < m_graph->spaces.size(); ++space) {
        if (!m_graph->spaces[space]->isCyclic)
            continue;
        addCandidates(space);
        m_fastest = std::max(m_fastest, fastestOf(*m_graph->spaces[space]));
        m_dimension = std::max(m_dimension, dimensionOf(space));
    }
    // A tick's share has candidates of all spaces: those that ask for a transition take longer.
    std::ranges::stable_sort(m_coarse, {}, [&](const LiveInput& input) {
        const ParameterMap& map = m_graph->spaces[input.space]->map;
        const double range = map.greatest[0] - map.least[0];
        return range > 0 ? (input.parameters[0] - map.least[0]) / range : 0;
    });
    m_count = 1 + m_coarse.size() + refinements * 2 * m_dimension;
    m_begin = bestStart();
}

std::size_t LivePlan::dimensionOf(std::size_t space) const
{
    return static_cast<std::size_t>(m_graph->spaces[space]->map.dimension);
}

void LivePlan::addCandidates(std::size_t space)
{
    constexpr std::array<std::size_t, 4> coarse{1, 7, 4, 3}; // values of a parameter, by their count
    constexpr std::array<std::size_t, 4> following{1, 13, 4, 2};
    const std::size_t dimension = dimensionOf(space);
    const ParameterMap& map = m_graph->spaces[space]->map;
    const auto add = [&](std::size_t values, std::vector<LiveInput>& inputs) {
        SpacePoint step{};
        std::size_t count = 1;
        for (std::size_t d = 0; d < dimension; ++d) {
            step[d] = (map.greatest[d] - map.least[d]) / static_cast<double>(values - 1);
            count *= values;
        }
        for (std::size_t i = 0; i < count; ++i) {
            LiveInput input{.space = space, .parameters = {}, .isResponsive = true};
            for (std::size_t d = 0, rest = i; d < dimension; ++d, rest /= values)
                input.parameters[d] = map.least[d] + static_cast<double>(rest % values) * step[d];
            inputs.push_back(input);
        }
        return step;
    };
    m_steps[space] = add(coarse[dimension], m_coarse);
    add(following[dimension], m_next);
}

/// Going along the route, in the space that stays on it best with what may follow.
LiveStart LivePlan::bestStart()
{
    LiveStart best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t space = 0; space < m_graph->spaces.size(); ++space) {
        if (!m_graph->spaces[space]->isCyclic)
            continue;
        const LiveInput input{
            .space = space, .parameters = middleOf(*m_graph->spaces[space]), .isResponsive = true};
        LiveStart start{.space = space, .parameters = input.parameters};
        m_player.start(start);
        const Vec2d way =
            centreOf(after(m_player.state(), input, static_cast<int>(std::lround(m_graph->fps))));
        start.root.shift = m_route.at(0).head<2>();
        start.root.turn = m_route.directionFrom(0, 0.5) - angleOf(way);
        m_player.start(start);
        begin(m_player.state(), 0, input);
        if (const double cost = costOf(input, least); cost < least) {
            least = cost;
            best = start;
        }
    }
    return best;
}

int LivePlan::firstSamples(std::size_t space) const
{
    return dimensionOf(space) > 1 ? m_severalSamples : m_firstSamples;
}

LiveInput LivePlan::wantedIn(const LiveState& state) const
{
    return {.space = state.wanted,
            .parameters =
                state.wanted == state.home ? state.homeParameters : middleOf(*m_graph->spaces[state.wanted]),
            .isResponsive = true};
}

Vec2d LivePlan::centreOf(const LiveState& state)
{
    m_player.restore(state);
    return m_player.root().shift;
}

LiveState LivePlan::after(const LiveState& state, const LiveInput& input, int frames)
{
    m_player.restore(state);
    for (int f = 0; f < frames; ++f)
        m_player.tick(input);
    return m_player.state();
}

void LivePlan::begin(const LiveState& from, double walked, const LiveInput& present)
{
    const Vec2d centre = centreOf(from);
    m_start.state = from;
    m_start.along = placeOn(m_route, centre, walked).along;
    m_start.trail.fill(centre);
    m_present = present;
    m_best = present;
    m_bestCost = std::numeric_limits<double>::infinity();
    m_tried = 0;
}

void LivePlan::advance(int share, int shares)
{
    const std::size_t most = m_count * static_cast<std::size_t>(share + 1) / static_cast<std::size_t>(shares);
    while (m_tried < most) {
        const std::optional<LiveInput> tried = candidate();
        if (tried) {
            const double cost = costOf(*tried, m_bestCost);
            if (cost < m_bestCost) {
                m_bestCost = cost;
                m_best = *tried;
            }
        }
        ++m_tried;
    }
}

/// Whether a space is played where the plan begins, or can be next.
bool LivePlan::canPlay(std::size_t space) const
{
    const std::size_t played = m_start.state.track.space;
    return space == played || m_graph->leads(played, space);
}

/// The present one, the coarse ones, then ones around the best.
std::optional<LiveInput> LivePlan::candidate()
{
    if (m_tried == 0)
        return m_present;
    if (m_tried <= m_coarse.size()) {
        const LiveInput& coarse = m_coarse[m_tried - 1];
        return canPlay(coarse.space) ? std::optional(coarse) : std::nullopt;
    }
    const std::size_t index = m_tried - 1 - m_coarse.size();
    const std::size_t round = index / (2 * m_dimension);
    const std::size_t within = index % (2 * m_dimension);
    if (within == 0)
        m_base = m_best;
    const std::size_t d = within / 2;
    const ParameterMap& map = m_graph->spaces[m_base.space]->map;
    if (d >= dimensionOf(m_base.space))
        return std::nullopt;
    const double step = m_steps[m_base.space][d] / static_cast<double>(std::size_t{2} << round);
    LiveInput input = m_base;
    input.parameters[d] =
        std::clamp(input.parameters[d] + (within % 2 == 0 ? step : -step), map.least[d], map.greatest[d]);
    return input == m_base ? std::nullopt : std::optional(input);
}

double LivePlan::changeCost(const LiveInput& from, const LiveInput& to) const
{
    if (from.space != to.space)
        return m_settings.transitionWeight;
    const ParameterMap& map = m_graph->spaces[to.space]->map;
    double cost = 0;
    for (std::size_t d = 0; d < dimensionOf(to.space); ++d)
        cost += m_settings.changeWeight * std::abs(to.parameters[d] - from.parameters[d]) /
                (map.greatest[d] - map.least[d]);
    return cost;
}

/// \return what is no less than the bound where it is no less.
double LivePlan::costOf(const LiveInput& input, double bound)
{
    Walked first = m_start;
    first.cost = changeCost(m_present, input);
    first.allSamples = firstSamples(input.space) + m_nextSamples;
    if (!play(first, input, firstSamples(input.space), bound))
        return bound;
    const auto tryNext = [&](const LiveInput& next) {
        Walked on = first;
        on.cost += changeCost(input, next);
        if (play(on, next, m_nextSamples, bound))
            bound = std::min(bound, endCost(on));
    };
    tryNext(input);
    // Before it is on its way to a space, each of these would look for a transition of its own.
    if (first.state.track.space != input.space && first.state.way != LiveState::Way::Leaving)
        return bound;
    for (const LiveInput& next : m_next) {
        if (next.space == input.space)
            tryNext(next);
    }
    return bound;
}

/// \return whether it costs less than the bound.
bool LivePlan::play(Walked& walked, const LiveInput& input, int samples, double bound)
{
    const double share = 1.0 / walked.allSamples;
    if (walked.cost >= bound)
        return false;
    m_player.restore(walked.state);
    for (int i = 0; i < samples; ++i) {
        for (int f = 0; f < m_sampleFrames; ++f) {
            const std::int64_t decisions = m_player.state().decisions;
            m_player.tick(input);
            if (m_player.state().decisions != decisions)
                walked.cost += unlikenessCost();
        }
        const Vec2d centre = m_player.root().shift;
        const RoutePlace place = placeOn(m_route, centre, walked.along);
        walked.along = place.along;
        walked.cost += share * (deviationCost(place.off / m_settings.tolerance) + obstacleCost(centre));
        walked.trail[static_cast<std::size_t>(walked.samples++) % trailLength] = centre;
        if (walked.cost >= bound)
            return false;
    }
    walked.state = m_player.state();
    return true;
}

double LivePlan::unlikenessCost() const
{
    const LiveDecision& decision = m_player.decision();
    const SimilarityTable& table = *m_graph->tables[decision.source][decision.target];
    if (!(table.greatest > 0))
        return 0;
    const double distance = m_player.state().choice.dissimilarity / table.scale(); // see SimilarityTable
    const double beyond = square(distance) * m_vertices - square(m_settings.alike);
    return m_settings.unlikenessWeight * std::max(beyond, 0.0);
}

/// Grows within the margin; what is too close costs more than anything else.
double LivePlan::obstacleCost(const Vec2d& point) const
{
    constexpr double tooClose = 1e4;
    constexpr double deeper = 1e5; // for each metre
    double cost = 0;
    for (const KeptClear& each : m_kept) {
        if ((point - each.centre).norm() - each.radius >= each.keep)
            continue;
        const double clear = distanceFrom(*each.obstacle, point) - each.obstacle->clearance;
        if (clear < 0)
            cost += tooClose - deeper * clear;
        else if (clear < m_settings.margin)
            cost += square(1 - clear / m_settings.margin);
    }
    return cost;
}

/// With what will come of where it goes, and of how fast it was.
double LivePlan::endCost(const Walked& walked) const
{
    constexpr double ahead = 0.6;   // metres
    constexpr double leading = 0.4; // metres in which an error of the heading leads away
    const auto last = static_cast<std::size_t>(walked.samples - 1);
    const Vec2d& centre = walked.trail[last % trailLength];
    const Vec2d way = centre - walked.trail[(last + 1) % trailLength];
    const double off = (m_route.at(walked.along).head<2>() - centre).norm();
    // From farther off it comes back farther on: it may have no room to turn to what is near.
    const Vec2d aim = m_route.at(walked.along + ahead + 2 * off).head<2>() - centre;
    const double heading = wrappedAngle(angleOf(way) - angleOf(aim));
    const double speed = (walked.along - m_start.along) / (walked.samples * m_sampleSeconds);
    return walked.cost + square(leading * heading / m_settings.tolerance) +
           m_settings.speedWeight * std::max(0.0, 1 - speed / m_fastest);
}

} // namespace quadrille
