// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/stagesearch.h"

#include "model/synthesis/fingerprints.h"

#include <queue>
#include <unordered_map>

namespace quadrille {

namespace {

struct Visit
{
    StageState stage;
    std::int32_t time = 0;
    std::int32_t parent = -1;
    MoveIndex move = noMove;
    double cost = 0;
};

/// What counts for the future (see WalkStages::future).
using Key = std::pair<StageState, std::int64_t>;

struct KeyHash
{
    std::size_t operator()(const Key& key) const
    {
        const StageState& stage = key.first;
        return fingerprintOf({stage.node, stage.key, stage.step, stage.span, stage.since, stage.required,
                              stage.isFollowing ? 1 : 0, key.second});
    }
};

class StagePass
{
public:
    /// \param trust  how much the bounds count; 1: exact. \param limit  cost of the best walk that is known.
    StagePass(const WalkGraph& graph, const WalkStages& stages, double trust, double limit)
        : m_graph(graph), m_stages(stages), m_trust(trust), m_limit(limit)
    {
    }

    std::optional<FoundRoute> run(const std::vector<NodeIndex>& starts, std::int64_t& budget,
                                  const Progress& progress)
    {
        for (const NodeIndex node : starts)
            offer({.stage = m_stages.begin(node)}, 0);
        while (!m_open.empty()) {
            const Entry best = m_open.top();
            m_open.pop();
            const Visit visit = m_visits[best.visit];
            if (m_costs.at(keyOf(visit)) < visit.cost)
                continue;
            if (m_stages.isDone(visit.stage))
                return routeTo(visit, m_visits, visit.cost);
            if (budget-- <= 0) {
                m_isComplete = false;
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

    Key keyOf(const Visit& visit) const { return m_stages.future(visit.stage, visit.time); }

    void expand(const Visit& from, std::int32_t parent)
    {
        const auto [begin, end] = m_graph.from(from.stage.node);
        for (MoveIndex index = begin; index < end; ++index) {
            const WalkMove& move = m_graph.move(index);
            if (m_stages.allows(from.stage, move))
                offer({.stage = m_stages.after(from.stage, move),
                       .time = from.time + move.elapsed,
                       .parent = parent,
                       .move = index},
                      from.cost + move.weight);
        }
    }

    void offer(Visit visit, double cost)
    {
        m_stages.settle(visit.stage, visit.time, m_settled);
        for (const SettledStage& settled : m_settled) {
            visit.stage = settled.state;
            visit.cost = cost + settled.edges + settled.timing;
            const double left = m_stages.leastCost(visit.stage, visit.time);
            if (visit.cost + left >= m_limit)
                continue;
            double& known = m_costs.try_emplace(keyOf(visit), unreachable).first->second;
            if (visit.cost >= known)
                continue;
            known = visit.cost;
            m_open.push({visit.cost + m_trust * left, m_visits.size()});
            m_visits.push_back(visit);
        }
    }

    const WalkGraph& m_graph;
    const WalkStages& m_stages;
    double m_trust;
    double m_limit;
    std::vector<Visit> m_visits;
    std::unordered_map<Key, double, KeyHash> m_costs;
    std::priority_queue<Entry> m_open;
    std::vector<SettledStage> m_settled;
    bool m_isComplete = true;
};

} // namespace

std::optional<FoundRoute> searchStages(const WalkGraph& graph, const WalkStages& stages,
                                       const std::vector<NodeIndex>& starts, std::int64_t budget,
                                       const FoundCallback& found, std::int64_t& expansions,
                                       const Progress& progress)
{
    std::optional<FoundRoute> best;
    std::int64_t left = budget;
    for (const double trust : {3.0, 1.0}) {
        progress.report(budget - left, budget);
        StagePass pass(graph, stages, trust, best ? best->cost : unreachable);
        std::optional<FoundRoute> better = pass.run(starts, left, progress);
        expansions = budget - std::max(left, std::int64_t{0});
        if (better) {
            best = std::move(better);
            best->expansions = expansions;
            best->optimal = trust == 1.0;
            found(*best);
        } else if (best && pass.isComplete()) {
            best->optimal = true;
        }
    }
    return best;
}

} // namespace quadrille
