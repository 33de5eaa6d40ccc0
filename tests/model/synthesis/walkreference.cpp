// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/synthesis/walkreference.h"

#include <algorithm>
#include <cmath>

namespace quadrille::test {

namespace {

void extend(const WalkGraph& graph, WalkRoute& route, NodeIndex node, std::int32_t elapsed, double cost,
            std::int32_t longest, const std::function<void(const WalkRoute&, std::int32_t, double)>& found)
{
    found(route, elapsed, cost);
    const auto [begin, end] = graph.from(node);
    for (MoveIndex index = begin; index < end; ++index) {
        const WalkMove& move = graph.move(index);
        if (elapsed + move.elapsed > longest)
            continue;
        route.moves.push_back(index);
        extend(graph, route, move.to, elapsed + move.elapsed, cost + move.weight, longest, found);
        route.moves.pop_back();
    }
}

} // namespace

void everyWalk(const WalkGraph& graph, NodeIndex start, std::int32_t longest,
               const std::function<void(const WalkRoute&, std::int32_t, double)>& found)
{
    WalkRoute route{.start = start, .moves = {}};
    extend(graph, route, start, 0, 0, longest, found);
}

double exhaustiveLeg(const WalkGraph& graph, const std::vector<NodeIndex>& sources, NodeIndex target,
                     double wanted, bool isFirst, double beta, std::int32_t longest)
{
    double best = unreachable;
    for (const NodeIndex source : sources) {
        everyWalk(graph, source, longest, [&](const WalkRoute& route, std::int32_t elapsed, double cost) {
            const NodeIndex end = route.moves.empty() ? source : graph.move(route.moves.back()).to;
            if (end == target && (elapsed > 0 || isFirst))
                best = std::min(best, cost + beta * std::abs(elapsed - wanted));
        });
    }
    return best;
}

double exhaustiveOverAllKeys(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                             const std::vector<PoseKey>& keys, double beta, std::int32_t longest)
{
    double best = unreachable;
    const std::function<void(std::size_t, std::int32_t, double)> from = [&](std::size_t key,
                                                                            std::int32_t time, double cost) {
        if (key == keys.size()) {
            best = std::min(best, cost);
            return;
        }
        const std::vector<NodeIndex> sources = key == 0 ? starts : std::vector{keys[key - 1].frame};
        for (const NodeIndex source : sources) {
            everyWalk(graph, source, longest, [&](const WalkRoute& route, std::int32_t elapsed, double more) {
                const NodeIndex end = route.moves.empty() ? source : graph.move(route.moves.back()).to;
                if (end == keys[key].frame && (elapsed > 0 || key == 0))
                    from(key + 1, time + elapsed,
                         cost + more + beta * std::abs(time + elapsed - keys[key].time));
            });
        }
    };
    from(0, 0, 0);
    return best;
}

} // namespace quadrille::test
