// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/walks/walkgraph.h"

#include <algorithm>
#include <map>
#include <optional>

namespace quadrille {

/// Lower bounds of what is left of a leg, exact distances in graphs whose weights count time (Lagrange
/// multipliers): for every |θ| ≤ β, Σ w + β·|T − Σ ℓ| ≥ Σ (w + θℓ) − θT.
class LegBounds
{
public:
    /// \param beta  cost of a frame of timing error, ≥ 0.
    LegBounds(const WalkGraph& graph, NodeIndex target, double beta);

    /// Of the cost from a node to the target, with the error of arriving after `time` frames more.
    double operator()(NodeIndex node, double time) const;
    /// The same with θ of one sign only: bounds of neighbouring legs of one sign may be added, where all
    /// keys count (the difference of their θ is at most β).
    double ofSign(bool isNegative, NodeIndex node, double time) const;
    /// The least of these wherever a leg may begin.
    double leastOfSign(bool isNegative, const std::vector<NodeIndex>& sources, double time) const
    {
        double least = unreachable;
        for (const NodeIndex source : sources)
            least = std::min(least, ofSign(isNegative, source, time));
        return least;
    }
    /// The ways that the bounds come from.
    struct Weighted
    {
        double theta = 0;
        WalkGraph::Ways ways;
    };
    const std::vector<Weighted>& all() const { return m_all; }
    NodeIndex target() const { return m_target; }

private:
    std::vector<Weighted> m_all;
    NodeIndex m_target;
};

/// The walks of one leg, from where walks may begin to a key: the cheapest to every frame for every time,
/// in layers of equal time.
class LegSearch
{
public:
    LegSearch(const WalkGraph& graph, std::vector<NodeIndex> sources, NodeIndex target);

    /// Looks at all states whose cost and bound are below a limit, and calls back for each arrival.
    /// \param bound  (node, elapsed, cost) → lower bound of the whole. \param limit  states whose bound is
    /// not below it are left out; the callback may lower it. \param arrive  (elapsed, cost). \param isStart
    /// an arrival after no time counts. \return whether the budget was enough; what was used is taken from
    /// it.
    template <typename Bound, typename Arrive>
    bool run(const Bound& bound, const double& limit, const Arrive& arrive, bool isStart,
             std::int64_t& budget, const Progress& progress);

    /// The cheapest walk that arrives after some time. \pre There was such an arrival.
    WalkRoute route(std::int32_t elapsed) const;

private:
    struct Layer
    {
        std::vector<double> costs;
        std::vector<MoveIndex> moves; ///< that came here
    };
    Layer& layer(std::int32_t elapsed);
    void expand(NodeIndex node, std::int32_t elapsed, double cost);

    const WalkGraph& m_graph;
    std::vector<NodeIndex> m_sources;
    NodeIndex m_target;
    std::map<std::int32_t, Layer> m_layers;
};

template <typename Bound, typename Arrive>
bool LegSearch::run(const Bound& bound, const double& limit, const Arrive& arrive, bool isStart,
                    std::int64_t& budget, const Progress& progress)
{
    for (const NodeIndex source : m_sources)
        layer(0).costs[static_cast<std::size_t>(source)] = 0;
    // Layers behind this one come to be meanwhile, which a map allows.
    for (const auto& [elapsed, here] : m_layers) {
        progress.report(0);
        const std::vector<double>& costs = here.costs;
        const double reached = costs[static_cast<std::size_t>(m_target)];
        if (reached < unreachable && (elapsed > 0 || isStart))
            arrive(elapsed, reached);
        bool isCounted = false;
        for (NodeIndex node = 0; node < m_graph.nodeCount(); ++node) {
            const double cost = costs[static_cast<std::size_t>(node)];
            if (cost == unreachable || bound(node, elapsed, cost) >= limit)
                continue;
            if (!isCounted && budget-- <= 0)
                return false;
            isCounted = true;
            expand(node, elapsed, cost);
        }
    }
    return true;
}

} // namespace quadrille
