// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/motiongraph.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {
namespace {

/// The rows or columns of one sequence.
struct Range
{
    NodeIndex first;
    NodeIndex last;
};

/// Of the cells of [first, last] that are no more than `reach` from `center`.
Range around(NodeIndex center, int reach, Range within)
{
    return {std::max(center - reach, within.first), std::min(center + reach, within.last)};
}

/// Calls `handle(row, sequence of the row, …of the column)` for the part of each row in each sequence, rows
/// in parallel.
template <typename Handle>
void forEachRowPart(const FrameLayout& layout, const Progress& progress, const Handle& handle)
{
    std::atomic<NodeIndex> done = 0;
    const NodeIndex frames = layout.frameCount();
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        const int source = layout.sequenceOf(i);
        for (int target = 0; target < layout.sequenceCount(); ++target)
            handle(i, Range{layout.firstOf(source), layout.lastOf(source)},
                   Range{layout.firstOf(target), layout.lastOf(target)});
        progress.report(++done, frames);
    });
}

double meanAround(TableView<float> cost, NodeIndex i, NodeIndex j, int reach, Range rows, Range columns)
{
    const Range near = around(i, reach, rows);
    const Range beside = around(j, reach, columns);
    double sum = 0;
    int count = 0;
    for (NodeIndex a = near.first; a <= near.last; ++a) {
        for (NodeIndex b = beside.first; b <= beside.last; ++b) {
            if (std::isfinite(cost(a, b))) {
                sum += cost(a, b);
                ++count;
            }
        }
    }
    return sum / count;
}

Table<float> smoothed(const TransitionCosts& costs, int reach, const Progress& progress)
{
    Table<float> result = costs.cost();
    forEachRowPart(costs.layout(), progress, [&](NodeIndex i, Range rows, Range columns) {
        for (NodeIndex j = columns.first; j <= columns.last; ++j)
            if (costs.hasTransition(i, j))
                result(i, j) = static_cast<float>(meanAround(costs.cost(), i, j, reach, rows, columns));
    });
    return result;
}

bool isStrictMinimum(TableView<float> cost, NodeIndex i, NodeIndex j, Range rows, Range columns)
{
    const Range near = around(i, 1, rows);
    const Range beside = around(j, 1, columns);
    for (NodeIndex a = near.first; a <= near.last; ++a)
        for (NodeIndex b = beside.first; b <= beside.last; ++b)
            if ((a != i || b != j) && cost(a, b) <= cost(i, j))
                return false;
    return true;
}

} // namespace

std::vector<FramePair> costMinima(const TransitionCosts& costs, CostSmoothing smoothing,
                                  const Progress& progress)
{
    const int reach = smoothing == CostSmoothing::Mean5 ? 2 : 1;
    const bool isSmoothed = smoothing != CostSmoothing::None;
    const Table<float> means = isSmoothed ? smoothed(costs, reach, progress.part(0, 0.5)) : Table<float>();
    const TableView<float> cost = isSmoothed ? TableView<float>(means) : costs.cost();
    std::vector<std::vector<FramePair>> found(static_cast<std::size_t>(cost.rows()));
    forEachRowPart(costs.layout(), isSmoothed ? progress.part(0.5, 1) : progress,
                   [&](NodeIndex i, Range rows, Range columns) {
                       for (NodeIndex j = columns.first; j <= columns.last; ++j)
                           if (i != j && costs.hasTransition(i, j) &&
                               isStrictMinimum(cost, i, j, rows, columns))
                               found[static_cast<std::size_t>(i)].push_back({i, j});
                   });
    std::vector<FramePair> minima;
    for (const auto& row : found)
        minima.insert(minima.end(), row.begin(), row.end());
    return minima;
}

Digraph motionGraph(const TransitionCosts& costs, std::span<const FramePair> minima, double alpha)
{
    requireAlpha(alpha);
    const FrameLayout& layout = costs.layout();
    std::vector<Edge> edges;
    edges.reserve(minima.size() + static_cast<std::size_t>(layout.frameCount()));
    auto minimum = minima.begin();
    for (int sequence = 0; sequence < layout.sequenceCount(); ++sequence) {
        for (NodeIndex i = layout.firstOf(sequence); i <= layout.lastOf(sequence); ++i) {
            const auto addMinima = [&](NodeIndex end) {
                for (; minimum != minima.end() && minimum->source == i && minimum->destination < end;
                     ++minimum)
                    edges.push_back({i, minimum->destination, costs.weight(i, minimum->destination, alpha)});
            };
            addMinima(i + 1);
            if (i < layout.lastOf(sequence)) {
                edges.push_back({i, i + 1, alpha, EdgeKind::Original});
                if (minimum != minima.end() && *minimum == FramePair{i, i + 1})
                    ++minimum;
            }
            addMinima(layout.frameCount());
        }
    }
    return {layout.frameCount(), std::move(edges)};
}

} // namespace quadrille
