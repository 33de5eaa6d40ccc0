// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/keywalk.h"

#include "model/core/error.h"
#include "model/synthesis/walks/keylegs.h"
#include "model/synthesis/walks/reachableset.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

struct LegWalk
{
    WalkRoute route;
    std::int32_t elapsed = 0;
    double edges = 0;
    double total = unreachable; ///< with the timing error
};

/// One leg: from where it may begin to a key.
struct Leg
{
    std::vector<NodeIndex> sources;
    NodeIndex target = 0;
    double wanted = 0; ///< frames that it should take
    double tolerance = unreachable;
    bool isFirst = false; ///< may take no time

    bool accepts(std::int64_t elapsed) const
    {
        return std::abs(static_cast<double>(elapsed) - wanted) <= tolerance;
    }
    double errorOf(std::int64_t elapsed) const { return std::abs(static_cast<double>(elapsed) - wanted); }
};

/// The best of the walks that the bounds come from: cheapest ways that count time more or less.
LegWalk boundWalk(const WalkGraph& graph, const Leg& leg, const LegBounds& bounds, double beta)
{
    LegWalk best;
    for (const auto& [theta, ways] : bounds.all()) {
        const auto costOf = [&ways = ways](NodeIndex node) {
            return ways.costs[static_cast<std::size_t>(node)];
        };
        for (const NodeIndex source : leg.sources) {
            if (costOf(source) == unreachable)
                continue;
            LegWalk walk{.route = graph.route(ways, source)};
            if (walk.route.moves.empty() && !leg.isFirst) {
                // Back to the same pose: the cheapest round trip.
                MoveIndex first = noMove;
                double cheapest = unreachable;
                const auto [begin, end] = graph.from(source);
                for (MoveIndex index = begin; index < end; ++index) {
                    const WalkMove& move = graph.move(index);
                    const double cost = move.weight + theta * move.elapsed + costOf(move.to);
                    if (cost < cheapest) {
                        cheapest = cost;
                        first = index;
                    }
                }
                if (first == noMove)
                    continue;
                walk.route = graph.route(ways, graph.move(first).to);
                walk.route.start = source;
                walk.route.moves.insert(walk.route.moves.begin(), first);
            }
            for (const MoveIndex index : walk.route.moves) {
                walk.edges += graph.move(index).weight;
                walk.elapsed += graph.move(index).elapsed;
            }
            walk.total = walk.edges + beta * leg.errorOf(walk.elapsed);
            if (leg.accepts(walk.elapsed) && walk.total < best.total)
                best = std::move(walk);
        }
    }
    return best;
}

/// The cheapest walk of a leg; a total of `unreachable` where none keeps to the tolerance.
LegWalk cheapestLeg(const WalkGraph& graph, const Leg& leg, const LegBounds& bounds, double beta,
                    std::int64_t& budget, bool& isComplete, const Progress& progress)
{
    LegWalk best = boundWalk(graph, leg, bounds, beta);
    LegSearch search(graph, leg.sources, leg.target);
    double limit = best.total;
    // Without a walk to begin with, later arrivals than the tolerance allows are of no use.
    const auto bound = [&](NodeIndex node, std::int32_t elapsed, double cost) {
        if (elapsed > leg.wanted + leg.tolerance)
            return unreachable;
        return cost + bounds(node, leg.wanted - elapsed);
    };
    std::optional<std::int32_t> better;
    isComplete = search.run(
        bound, limit,
        [&](std::int32_t elapsed, double cost) {
            const double total = cost + beta * leg.errorOf(elapsed);
            if (leg.accepts(elapsed) && total < limit) {
                limit = total;
                better = elapsed;
                best.edges = cost;
            }
        },
        leg.isFirst, budget, progress);
    if (better) {
        best.route = search.route(*better);
        best.elapsed = *better;
        best.total = limit;
    }
    return best;
}

/// Whether some key is not reached, or not in time, and what would do.
[[noreturn]] void refuse(const WalkGraph& graph, const Leg& leg, std::size_t key, std::int64_t begun)
{
    const ReachableSet reach(graph, leg.sources, leg.isFirst);
    const std::string name = std::to_string(key + 1);
    if (!reach.contains(leg.target))
        throw Error(ErrorCode::WalkKeyUnreachable,
                    {.values = {{"key", name},
                                {"frame", std::to_string(leg.target)},
                                {"nearest", std::to_string(reach.nearest(leg.target, graph.layout()))}}});
    const std::int64_t nearest =
        begun + nearestArrival(graph, leg.sources, leg.target, leg.wanted, leg.isFirst);
    throw Error(ErrorCode::WalkKeyUntimely,
                {.values = {{"key", name},
                            {"time", shortNumber(static_cast<double>(begun) + leg.wanted)},
                            {"tolerance", shortNumber(leg.tolerance)},
                            {"nearest", std::to_string(nearest)}}});
}

/// Layers of all legs together stay within two gigabytes: what is looked at is limited by the budget, or by
/// this where the budget is greater.
std::int64_t withinMemory(std::int64_t budget, const WalkGraph& graph)
{
    constexpr std::int64_t mostBytes = std::int64_t{2} << 30;
    const std::int64_t ofLayer = std::max<std::int64_t>(graph.nodeCount(), 1) *
                                 static_cast<std::int64_t>(sizeof(double) + sizeof(MoveIndex));
    return std::min(budget, std::max(mostBytes / ofLayer, std::int64_t{1}));
}

void append(WalkRoute& route, const WalkRoute& leg)
{
    if (route.moves.empty())
        route.start = leg.start;
    route.moves.insert(route.moves.end(), leg.moves.begin(), leg.moves.end());
}

Leg legTo(const std::vector<PoseKey>& keys, std::size_t key, const std::vector<NodeIndex>& starts,
          double begun)
{
    return {.sources = key == 0 ? starts : std::vector{keys[key - 1].frame},
            .target = keys[key].frame,
            .wanted = keys[key].time - begun,
            .tolerance = keys[key].tolerance.value_or(unreachable),
            .isFirst = key == 0};
}

std::vector<LegBounds> boundsOf(const WalkGraph& graph, const std::vector<PoseKey>& keys, double beta)
{
    std::vector<LegBounds> bounds;
    bounds.reserve(keys.size());
    for (const PoseKey& key : keys)
        bounds.emplace_back(graph, key.frame, beta);
    return bounds;
}

KeyWalk fromKeyToKey(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                     const std::vector<PoseKey>& keys, const std::vector<LegBounds>& bounds, double beta,
                     std::int64_t& budget, const Progress& progress)
{
    KeyWalk result{.optimal = true};
    std::int64_t time = 0;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        progress.report(static_cast<std::int64_t>(k), static_cast<std::int64_t>(keys.size()));
        const Leg leg = legTo(keys, k, starts, static_cast<double>(time));
        bool isComplete = true;
        const LegWalk walk = cheapestLeg(graph, leg, bounds[k], beta, budget, isComplete, progress);
        if (walk.total == unreachable)
            refuse(graph, leg, k, time);
        append(result.route, walk.route);
        time += walk.elapsed;
        result.times.push_back(time);
        result.edges += walk.edges;
        result.timing += beta * leg.errorOf(walk.elapsed);
        result.optimal = result.optimal && isComplete;
    }
    return result;
}

/// A walk from key to key that is good over all of them: the dearer errors are to each pair, the less they
/// add up.
KeyWalk goodWalk(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                 const std::vector<PoseKey>& keys, double beta, std::int64_t& budget,
                 const Progress& progress)
{
    KeyWalk best{.edges = unreachable, .timing = unreachable};
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (best.timing == 0)
            break;
        KeyWalk walk = fromKeyToKey(graph, starts, keys, boundsOf(graph, keys, factor * beta), factor * beta,
                                    budget, progress);
        walk.timing /= factor;
        if (walk.edges + walk.timing < best.edges + best.timing)
            best = std::move(walk);
    }
    return best;
}

/// One programme over the times of all keys, from the costs of each leg for every time that it can take.
class KeyTimes
{
public:
    KeyTimes(const std::vector<PoseKey>& keys, double beta) : m_keys(keys), m_beta(beta)
    {
        m_states.push_back({{0, {}}});
    }

    void addLeg(const std::map<std::int32_t, double>& costs)
    {
        const PoseKey& key = m_keys[m_states.size() - 1];
        std::map<std::int64_t, State> next;
        for (const auto& [time, state] : m_states.back()) {
            for (const auto& [elapsed, cost] : costs) {
                const std::int64_t there = time + elapsed;
                const double error = std::abs(static_cast<double>(there) - key.time);
                if (error > key.tolerance.value_or(unreachable))
                    continue;
                const double total = state.cost + cost + m_beta * error;
                State& known = next.try_emplace(there, State{unreachable, 0}).first->second;
                if (total < known.cost)
                    known = {total, elapsed};
            }
        }
        m_states.push_back(std::move(next));
    }

    /// The frames that each leg takes on the cheapest way; empty where there is none.
    std::vector<std::int32_t> cheapest() const
    {
        const auto& last = m_states.back();
        const auto best = std::min_element(last.begin(), last.end(), [](const auto& a, const auto& b) {
            return a.second.cost < b.second.cost;
        });
        std::vector<std::int32_t> elapsed;
        if (best == last.end())
            return elapsed;
        std::int64_t time = best->first;
        for (std::size_t k = m_states.size() - 1; k > 0; --k) {
            elapsed.insert(elapsed.begin(), m_states[k].at(time).elapsed);
            time -= elapsed.front();
        }
        return elapsed;
    }

private:
    struct State
    {
        double cost = 0;
        std::int32_t elapsed = 0; ///< of the last leg
    };
    const std::vector<PoseKey>& m_keys;
    double m_beta;
    std::vector<std::map<std::int64_t, State>> m_states; ///< by the time of each key
};

/// Lower bounds of the cost of all legs together, from bounds of each alone.
class SumBounds
{
public:
    SumBounds(const WalkGraph& graph, const std::vector<PoseKey>& keys, const std::vector<Leg>& legs,
              const std::vector<LegBounds>& bounds, double beta, std::int64_t& budget,
              const Progress& progress)
        : m_legs(legs), m_bounds(bounds), m_half(boundsOf(graph, keys, beta / 2))
    {
        for (std::size_t k = 0; k < legs.size(); ++k) {
            std::array<double, 3> least{bounds[k].leastOfSign(true, legs[k].sources, legs[k].wanted),
                                        bounds[k].leastOfSign(false, legs[k].sources, legs[k].wanted),
                                        unreachable};
            for (const NodeIndex source : legs[k].sources)
                least[2] = std::min(least[2], m_half[k](source, legs[k].wanted));
            // The errors of two neighbouring keys are together at least that of the leg between them: each
            // leg alone, its error at half the cost, is another bound; this one is exact.
            Leg alone = legs[k];
            alone.tolerance = unreachable;
            bool isComplete = true;
            const LegWalk walk = cheapestLeg(graph, alone, m_half[k], beta / 2, budget, isComplete, progress);
            if (isComplete)
                least[2] = walk.total;
            m_least.push_back(least);
            for (std::size_t form = 0; form < least.size(); ++form)
                m_sum[form] += least[form];
        }
    }

    /// Where leg k has come to a node at some cost.
    double operator()(std::size_t k, NodeIndex node, std::int32_t elapsed, double cost) const
    {
        const double time = m_legs[k].wanted - elapsed;
        return cost + std::max({m_sum[0] - m_least[k][0] + m_bounds[k].ofSign(true, node, time),
                                m_sum[1] - m_least[k][1] + m_bounds[k].ofSign(false, node, time),
                                m_sum[2] - m_least[k][2] + m_half[k](node, time)});
    }

    /// Of all legs together.
    double whole() const { return std::ranges::max(m_sum); }

private:
    const std::vector<Leg>& m_legs;
    const std::vector<LegBounds>& m_bounds;
    std::vector<LegBounds> m_half;
    std::vector<std::array<double, 3>> m_least; ///< of each leg: both signs, and half the cost
    std::array<double, 3> m_sum{};
};

} // namespace

KeyWalk walkFromKeyToKey(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                         const std::vector<PoseKey>& keys, double beta, std::int64_t budget,
                         const Progress& progress)
{
    const std::int64_t allowed = withinMemory(budget, graph);
    std::int64_t left = allowed;
    const std::vector<LegBounds> bounds = boundsOf(graph, keys, beta);
    KeyWalk walk = fromKeyToKey(graph, starts, keys, bounds, beta, left, progress);
    walk.expansions = allowed - std::max(left, std::int64_t{0});
    for (const bool isNegative : {true, false}) {
        double sum = 0;
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const Leg leg = legTo(keys, k, starts, k == 0 ? 0 : keys[k - 1].time);
            sum += bounds[k].leastOfSign(isNegative, leg.sources, leg.wanted);
        }
        walk.bound = std::max(walk.bound, sum);
    }
    return walk;
}

KeyWalk walkOverAllKeys(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                        const std::vector<PoseKey>& keys, double beta, std::int64_t budget,
                        const Progress& progress)
{
    const std::int64_t allowed = withinMemory(budget, graph);
    std::int64_t left = allowed;
    const std::vector<LegBounds> bounds = boundsOf(graph, keys, beta);
    KeyWalk first = goodWalk(graph, starts, keys, beta, left, progress.part(0, 0.3));
    // A little above, so that rounding does not leave out the walk that is known.
    const double limit = (first.edges + first.timing) * (1 + 1e-9) + 1e-12;
    std::vector<Leg> legs;
    for (std::size_t k = 0; k < keys.size(); ++k)
        legs.push_back(legTo(keys, k, starts, k == 0 ? 0 : keys[k - 1].time));
    const SumBounds sum(graph, keys, legs, bounds, beta, left, progress.part(0.3, 0.5));
    KeyTimes times(keys, beta);
    std::vector<LegSearch> searches;
    first.optimal = false;
    first.bound = sum.whole();
    for (std::size_t k = 0; k < keys.size(); ++k) {
        std::map<std::int32_t, double> costs;
        const auto bound = [&](NodeIndex node, std::int32_t elapsed, double cost) {
            return sum(k, node, elapsed, cost);
        };
        searches.emplace_back(graph, legs[k].sources, legs[k].target);
        const auto part = static_cast<double>(k) / static_cast<double>(keys.size());
        const bool isComplete = searches.back().run(
            bound, limit,
            [&](std::int32_t elapsed, double cost) {
                if (bound(legs[k].target, elapsed, cost) < limit)
                    costs.emplace(elapsed, cost);
            },
            legs[k].isFirst, left, progress.part(0.5 + 0.5 * part, 1));
        if (!isComplete) {
            first.expansions = allowed;
            return first;
        }
        times.addLeg(costs);
    }
    KeyWalk best{.optimal = true, .expansions = allowed - left};
    const std::vector<std::int32_t> elapsed = times.cheapest();
    assert(elapsed.size() == keys.size());
    std::int64_t time = 0;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const WalkRoute route = searches[k].route(elapsed[k]);
        for (const MoveIndex index : route.moves)
            best.edges += graph.move(index).weight;
        append(best.route, route);
        time += elapsed[k];
        best.times.push_back(time);
        best.timing += beta * std::abs(static_cast<double>(time) - keys[k].time);
    }
    best.bound = best.edges + best.timing;
    return best;
}

} // namespace quadrille
