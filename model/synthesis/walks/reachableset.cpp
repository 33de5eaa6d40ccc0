// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/reachableset.h"

#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

namespace quadrille {

ReachableSet::ReachableSet(const WalkGraph& graph, const std::vector<NodeIndex>& sources, bool isStart)
    : m_isReached(static_cast<std::size_t>(graph.nodeCount()), false)
{
    std::vector<NodeIndex> open = sources;
    for (const NodeIndex source : sources)
        m_isReached[static_cast<std::size_t>(source)] = isStart;
    while (!open.empty()) {
        const auto [begin, end] = graph.from(open.back());
        open.pop_back();
        for (MoveIndex index = begin; index < end; ++index) {
            const auto to = static_cast<std::size_t>(graph.move(index).to);
            if (!m_isReached[to]) {
                m_isReached[to] = true;
                open.push_back(graph.move(index).to);
            }
        }
    }
}

NodeIndex ReachableSet::nearest(NodeIndex node, const FrameLayout& layout) const
{
    std::optional<NodeIndex> best;
    const int sequence = layout.sequenceOf(node);
    const auto distance = [&](NodeIndex other) {
        // Frames of other sequences are farther than any of the same one.
        return std::abs(other - node) + (layout.sequenceOf(other) == sequence ? 0 : layout.frameCount());
    };
    for (NodeIndex other = 0; other < layout.frameCount(); ++other) {
        if (contains(other) && (!best || distance(other) < distance(*best)))
            best = other;
    }
    return best.value_or(node);
}

std::int64_t nearestArrival(const WalkGraph& graph, const std::vector<NodeIndex>& sources, NodeIndex target,
                            double wanted, bool isStart)
{
    const auto nodes = static_cast<std::size_t>(graph.nodeCount());
    std::map<std::int64_t, std::vector<bool>> layers;
    layers[0].assign(nodes, false);
    for (const NodeIndex source : sources)
        layers[0][static_cast<std::size_t>(source)] = true;
    std::optional<std::int64_t> best;
    const auto error = [wanted](std::int64_t time) { return std::abs(static_cast<double>(time) - wanted); };
    for (; !layers.empty(); layers.erase(layers.begin())) {
        const auto& [time, isReached] = *layers.begin();
        if (best && static_cast<double>(time) > wanted && error(time) >= error(*best))
            break;
        if (isReached[static_cast<std::size_t>(target)] && (time > 0 || isStart) &&
            (!best || error(time) < error(*best)))
            best = time;
        for (std::size_t node = 0; node < nodes; ++node) {
            if (!isReached[node])
                continue;
            const auto [begin, end] = graph.from(static_cast<NodeIndex>(node));
            for (MoveIndex index = begin; index < end; ++index) {
                std::vector<bool>& there = layers[time + graph.move(index).elapsed];
                there.resize(nodes, false);
                there[static_cast<std::size_t>(graph.move(index).to)] = true;
            }
        }
    }
    assert(best);
    return *best;
}

std::string shortNumber(double value)
{
    std::ostringstream text;
    text << std::round(value * 1000) / 1000;
    return text.str();
}

} // namespace quadrille
