// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/automatonsearch.h"

#include "model/synthesis/walks/beamlayers.h"
#include "model/synthesis/walks/fingerprints.h"
#include "model/synthesis/walks/searchmemory.h"

#include <map>
#include <queue>
#include <unordered_map>

namespace quadrille {

namespace {

struct Visit
{
    AutomatonState stage;
    std::int32_t time = 0;
    std::int32_t parent = -1;
    MoveIndex move = noMove;
    double cost = 0;
};

/// A*: what it finds is the cheapest.
class StepPass
{
public:
    /// \param limit  cost of the best walk that is known.
    StepPass(const WalkGraph& graph, const ConstraintAutomaton& automaton, double limit)
        : m_graph(graph), m_automaton(automaton), m_limit(limit)
    {
    }

    std::optional<FoundRoute> run(const std::vector<NodeIndex>& starts, std::int64_t& budget,
                                  const Progress& progress)
    {
        for (const NodeIndex node : starts)
            offer({.stage = m_automaton.begin(node)}, 0);
        while (!m_open.empty()) {
            const Entry best = m_open.top();
            m_open.pop();
            const Visit visit = m_visits[best.visit];
            if (m_costs.at(keyOf(visit)) < visit.cost)
                continue;
            if (m_automaton.isDone(visit.stage))
                return routeTo(visit, m_visits, visit.cost);
            if (m_visits.size() >= mostVisits || budget-- <= 0) {
                m_isComplete = false;
                m_bound = best.rank;
                return std::nullopt;
            }
            if (budget % 256 == 0)
                progress.report(0);
            expand(visit, static_cast<std::int32_t>(best.visit));
        }
        return std::nullopt;
    }

    /// Whether nothing better can be left, once run has returned.
    bool isComplete() const { return m_isComplete; }
    /// What no walk costs less than, where it is not complete.
    double bound() const { return m_bound; }

private:
    struct Entry
    {
        double rank = 0;
        std::size_t visit = 0;
        /// The better one comes first; of two alike the later, which has come farther.
        bool operator<(const Entry& other) const
        {
            return rank != other.rank ? rank > other.rank : visit < other.visit;
        }
    };

    AutomatonFuture keyOf(const Visit& visit) const { return m_automaton.future(visit.stage, visit.time); }

    void expand(const Visit& from, std::int32_t parent)
    {
        const auto [begin, end] = m_graph.from(from.stage.node);
        for (MoveIndex index = begin; index < end; ++index) {
            const WalkMove& move = m_graph.move(index);
            if (m_automaton.allows(from.stage, move))
                offer({.stage = m_automaton.after(from.stage, move),
                       .time = from.time + move.elapsed,
                       .parent = parent,
                       .move = index},
                      from.cost + move.weight);
        }
    }

    void offer(Visit visit, double cost)
    {
        m_automaton.settle(visit.stage, visit.time, m_settled);
        for (const SettledState& settled : m_settled) {
            visit.stage = settled.state;
            visit.cost = cost + settled.edges + settled.timing;
            const double left = m_automaton.leastCost(visit.stage, visit.time);
            if (visit.cost + left >= m_limit)
                continue;
            double& known = m_costs.try_emplace(keyOf(visit), unreachable).first->second;
            if (visit.cost >= known)
                continue;
            known = visit.cost;
            m_open.push({visit.cost + left, m_visits.size()});
            m_visits.push_back(visit);
        }
    }

    const WalkGraph& m_graph;
    const ConstraintAutomaton& m_automaton;
    double m_limit;
    std::vector<Visit> m_visits;
    std::unordered_map<AutomatonFuture, double, AutomatonFutureHash> m_costs;
    std::priority_queue<Entry> m_open;
    std::vector<SettledState> m_settled;
    bool m_isComplete = true;
    double m_bound = 0;
};

/// Looks at the most promising states of every output frame only, so that there is a walk soon.
class NarrowPass
{
public:
    NarrowPass(const WalkGraph& graph, const ConstraintAutomaton& automaton, std::int64_t width, double limit)
        : m_graph(graph), m_automaton(automaton), m_width(width), m_limit(limit)
    {
    }

    std::optional<FoundRoute> run(const std::vector<NodeIndex>& starts, std::int64_t& budget,
                                  const Progress& progress)
    {
        for (const NodeIndex node : starts)
            offer({.visit = {.stage = m_automaton.begin(node)}}, 0);
        for (; !m_layers.empty() && budget > 0 && hasMemory(); m_layers.erase(m_layers.begin())) {
            progress.report(0);
            BeamFront<Candidate>& layer = m_layers.begin()->second;
            for (std::int64_t taken = 0; taken < layer.width(m_width) && budget > 0 && hasMemory();) {
                const std::optional<Candidate> next = layer.take();
                if (!next)
                    break;
                if (next->rank >= m_limit || m_known.isWorse(fingerprint(next->visit), next->visit.cost))
                    continue;
                ++taken;
                --budget;
                expand(next->visit);
            }
        }
        return std::move(m_found);
    }

private:
    struct Candidate
    {
        Visit visit;
        double rank = 0;
        std::uint32_t order = 0;
    };

    bool hasMemory() const { return m_seen.size() < mostVisits && m_known.count() < mostKnownStates; }

    std::uint64_t fingerprint(const Visit& visit) const
    {
        return AutomatonFutureHash()(m_automaton.future(visit.stage, visit.time));
    }

    void expand(const Visit& from)
    {
        const auto parent = static_cast<std::int32_t>(m_seen.size());
        m_seen.push_back(from);
        const auto [begin, end] = m_graph.from(from.stage.node);
        for (MoveIndex index = begin; index < end; ++index) {
            const WalkMove& move = m_graph.move(index);
            if (m_automaton.allows(from.stage, move))
                offer({.visit = {.stage = m_automaton.after(from.stage, move),
                                 .time = from.time + move.elapsed,
                                 .parent = parent,
                                 .move = index}},
                      from.cost + move.weight);
        }
    }

    void offer(Candidate candidate, double cost)
    {
        Visit& visit = candidate.visit;
        m_automaton.settle(visit.stage, visit.time, m_settled);
        for (const SettledState& settled : m_settled) {
            visit.stage = settled.state;
            visit.cost = cost + settled.edges + settled.timing;
            candidate.rank = visit.cost + m_automaton.leastCost(visit.stage, visit.time);
            if (candidate.rank >= m_limit)
                continue;
            if (m_automaton.isDone(visit.stage)) {
                m_limit = visit.cost;
                m_found = routeTo(visit, m_seen, visit.cost);
                continue;
            }
            BeamLayer<Candidate>& layer =
                m_layers[visit.time].layer(visit.stage, m_automaton.quartersDone(visit.stage, visit.time));
            if (!layer.takes(candidate.rank) || !m_known.improves(fingerprint(visit), visit.cost))
                continue;
            candidate.order = m_order++;
            layer.add(candidate, m_width);
        }
    }

    const WalkGraph& m_graph;
    const ConstraintAutomaton& m_automaton;
    std::int64_t m_width;
    double m_limit;
    std::map<std::int32_t, BeamFront<Candidate>> m_layers;
    std::vector<Visit> m_seen;
    std::vector<SettledState> m_settled;
    CheapestKnown m_known;
    std::uint32_t m_order = 0;
    std::optional<FoundRoute> m_found;
};

} // namespace

std::optional<FoundRoute> searchAutomaton(const WalkGraph& graph, const ConstraintAutomaton& automaton,
                                          const std::vector<NodeIndex>& starts, std::int64_t budget,
                                          const FoundCallback& found, SearchEffort& effort,
                                          const Progress& progress)
{
    std::optional<FoundRoute> best;
    std::int64_t left = budget;
    const auto limit = [&best] { return best ? best->cost : unreachable; };
    const auto keep = [&](std::optional<FoundRoute> better) {
        effort.expansions = budget - std::max(left, std::int64_t{0});
        if (!better)
            return;
        best = std::move(better);
        best->expansions = effort.expansions;
        found(*best);
    };
    // Narrow passes may use half of the budget.
    for (std::int64_t width = 8; 2 * left > budget; width *= 4) {
        progress.report(budget - left, budget);
        std::int64_t part = left - budget / 2;
        const std::int64_t before = part;
        std::optional<FoundRoute> better =
            NarrowPass(graph, automaton, width, limit()).run(starts, part, progress);
        left -= before - part;
        keep(std::move(better));
        constexpr std::int64_t widest = 128;
        if (width >= widest)
            break;
    }
    StepPass exact(graph, automaton, limit());
    std::optional<FoundRoute> cheapest = exact.run(starts, left, progress);
    effort.isComplete = exact.isComplete();
    if (cheapest)
        cheapest->optimal = true;
    else if (best && exact.isComplete())
        best->optimal = true;
    keep(std::move(cheapest));
    if (best)
        best->bound = best->optimal ? best->cost : std::min(exact.bound(), best->cost);
    return best;
}

} // namespace quadrille
