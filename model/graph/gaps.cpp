// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/gaps.h"

#include <limits>

namespace quadrille {

namespace {

std::vector<bool> maskOf(const std::vector<NodeIndex>& nodes, NodeIndex count)
{
    std::vector<bool> mask(static_cast<std::size_t>(count));
    for (const NodeIndex node : nodes)
        mask[static_cast<std::size_t>(node)] = true;
    return mask;
}

class GapFinder
{
public:
    GapFinder(const Digraph& graph, const TransitionCosts& costs, TableView<float> distances, double alpha)
        : m_graph(graph), m_costs(costs), m_distances(distances), m_alpha(alpha)
    {
    }

    void find(GraphGap::Kind kind, const std::vector<NodeIndex>& cutOff, std::vector<GraphGap>& gaps) const
    {
        const FrameLayout& layout = m_costs.layout();
        const std::vector<bool> mask = maskOf(cutOff, layout.frameCount());
        for (std::size_t i = 0; i < cutOff.size();) {
            GraphGap gap{.kind = kind, .first = cutOff[i], .last = cutOff[i]};
            const NodeIndex end = layout.lastOf(layout.sequenceOf(gap.first));
            for (++i; i < cutOff.size() && cutOff[i] == gap.last + 1 && gap.last < end; ++i)
                ++gap.last;
            close(gap, mask, cutOff.size() == mask.size());
            gaps.push_back(gap);
        }
    }

private:
    void close(GraphGap& gap, const std::vector<bool>& cutOff, bool isAll) const
    {
        const bool leadsAway = gap.kind == GraphGap::Kind::DeadEnd;
        const FrameLayout& layout = m_costs.layout();
        gap.weight = unreachable;
        gap.distance = std::numeric_limits<float>::infinity();
        for (NodeIndex inside = gap.first; inside <= gap.last; ++inside) {
            for (NodeIndex other = 0; other < layout.frameCount(); ++other) {
                const FramePair pair = leadsAway ? FramePair{inside, other} : FramePair{other, inside};
                const bool isOneSequence =
                    layout.sequenceOf(pair.source) == layout.sequenceOf(pair.destination);
                if (isAll ? isOneSequence && pair.destination >= pair.source
                          : cutOff[static_cast<std::size_t>(other)])
                    continue;
                consider(gap, pair);
            }
        }
        if (!gap.transition)
            gap.weight = 0;
        if (!gap.take)
            gap.distance = 0;
    }

    void consider(GraphGap& gap, const FramePair& pair) const
    {
        const double weight = m_costs.hasTransition(pair.source, pair.destination)
                                  ? m_costs.weight(pair.source, pair.destination, m_alpha)
                                  : unreachable;
        if (weight < gap.weight && m_graph.find(pair.source, pair.destination) == nullptr) {
            gap.weight = weight;
            gap.transition = pair;
        }
        const float distance = m_distances(pair.source, pair.destination);
        if (distance < gap.distance) {
            gap.distance = distance;
            gap.take = pair;
        }
    }

    const Digraph& m_graph;
    const TransitionCosts& m_costs;
    TableView<float> m_distances;
    double m_alpha;
};

} // namespace

std::vector<GraphGap> findGaps(const Digraph& graph, const Connectivity& connectivity,
                               const TransitionCosts& costs, TableView<float> distances, double alpha)
{
    std::vector<GraphGap> gaps;
    const GapFinder finder(graph, costs, distances, alpha);
    finder.find(GraphGap::Kind::Unreachable, connectivity.unreachable, gaps);
    finder.find(GraphGap::Kind::DeadEnd, connectivity.deadEnds, gaps);
    return gaps;
}

} // namespace quadrille
