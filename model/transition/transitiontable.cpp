// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/transitiontable.h"

#include "model/core/executor.h"
#include "model/transition/costgrid.h"
#include "model/transition/windowkernel.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

namespace quadrille {

namespace {

using Entry = KnownTransition; ///< what a task computes for a pair of frames

/// Source frames of one sequence that are computed together.
struct Rows
{
    NodeIndex first;
    NodeIndex count;
};

constexpr NodeIndex rowsOfTask = 16;

std::vector<Rows> tasksOf(const FrameLayout& layout)
{
    std::vector<Rows> tasks;
    for (int s = 0; s < layout.sequenceCount(); ++s) {
        for (NodeIndex i = layout.firstOf(s); i <= layout.lastOf(s); i += rowsOfTask)
            tasks.push_back({.first = i, .count = std::min(rowsOfTask, layout.lastOf(s) - i + 1)});
    }
    return tasks;
}

float largestOf(TableView<float> distances)
{
    return distances.size() == 0 ? 0 : distances.maxCoeff();
}

/// All transitions from some source frames.
class RowSearch
{
public:
    RowSearch(TableView<float> distances, const FrameLayout& layout, const TransitionSettings& settings,
              const CostGrid& grid)
        : m_distances(distances), m_layout(layout), m_settings(settings), m_grid(grid)
    {
        m_search.longest = settings.longest();
        m_search.slope = settings.slope;
    }

    /// rows.count × frames.
    std::vector<Entry> run(Rows rows, const Progress& progress)
    {
        std::vector<Entry> entries(static_cast<std::size_t>(rows.count) *
                                   static_cast<std::size_t>(m_layout.frameCount()));
        const NodeIndex end = m_layout.lastOf(m_layout.sequenceOf(rows.first)) + 1;
        for (int s = 0; s < m_layout.sequenceCount(); ++s) {
            setKeys(rows, end, s);
            m_search.shortest = m_settings.shortestBetween(m_layout.countOf(m_layout.sequenceOf(rows.first)),
                                                           m_layout.countOf(s));
            for (NodeIndex r = 0; r < rows.count; ++r) {
                progress.report(static_cast<std::int64_t>(s) * rows.count + r,
                                static_cast<std::int64_t>(m_layout.sequenceCount()) * rows.count);
                m_search.keys = m_keys.data() + r * m_search.stride + m_search.margin();
                m_search.rows = std::min<int>(m_search.longest, end - rows.first - r);
                searchLeastSums(m_search, m_best, m_scratch);
                if (m_settings.cost == TransitionCost::Mean)
                    improveToLeastMeans(m_search, m_grid.lengthOne, r > 0 ? &m_before : nullptr, m_best,
                                        m_scratch);
                takeRow(rows.first + r, s,
                        entries.data() + static_cast<std::ptrdiff_t>(r) * m_layout.frameCount());
                std::swap(m_before, m_best);
            }
        }
        return entries;
    }

private:
    void setKeys(Rows rows, NodeIndex end, int destination)
    {
        m_search.columns = m_layout.countOf(destination);
        m_search.stride = m_search.columns + 2 * m_search.margin();
        const NodeIndex last = std::min<NodeIndex>(end, rows.first + rows.count - 1 + m_search.longest);
        m_keys.assign(static_cast<std::size_t>(last - rows.first) * static_cast<std::size_t>(m_search.stride),
                      CostGrid::outOfReach);
        for (NodeIndex i = rows.first; i < last; ++i) {
            const float* from = &m_distances.coeffRef(i, m_layout.firstOf(destination));
            double* to = m_keys.data() + (i - rows.first) * m_search.stride + m_search.margin();
            std::transform(from, from + m_search.columns, to,
                           [grid = m_grid](float distance) { return grid.keyOf(distance); });
        }
    }

    void takeRow(NodeIndex source, int destination, Entry* entries) const
    {
        for (NodeIndex c = 0; c < m_layout.countOf(destination); ++c) {
            const NodeIndex j = m_layout.firstOf(destination) + c;
            const auto b = static_cast<std::size_t>(c);
            if (j == source || m_best.key[b] >= CostGrid::unknown)
                continue;
            const int cells = m_grid.lengthOfKey(m_best.key[b]);
            const int length =
                m_settings.lengthOf(cells, m_best.sourceWindow[b], m_best.destinationWindow[b]);
            entries[j] = {.cost = m_grid.costOf(m_grid.stepsOfKey(m_best.key[b]), cells, m_settings.cost),
                          .length = static_cast<std::uint16_t>(length),
                          .sourceWindow = m_best.sourceWindow[b],
                          .destinationWindow = m_best.destinationWindow[b]};
        }
    }

    TableView<float> m_distances;
    const FrameLayout& m_layout;
    const TransitionSettings& m_settings;
    CostGrid m_grid;
    WindowSearch m_search;
    BestWindows m_best;
    BestWindows m_before; ///< of the source frame before
    WindowScratch m_scratch;
    std::vector<double> m_keys; ///< of some rows against one destination sequence, as WindowSearch has them
};

/// The tables while they are filled.
struct TableInWork
{
    explicit TableInWork(NodeIndex frames)
        : cost(Table<float>::Constant(frames, frames, TransitionTable::none))
        , length(Table<std::uint16_t>::Zero(frames, frames))
        , windows(Table<std::uint16_t>::Zero(frames, Eigen::Index{2} * frames))
    {
    }

    void set(NodeIndex i, Eigen::Index j, const Entry& entry)
    {
        cost(i, j) = entry.cost;
        length(i, j) = entry.length;
        windows(i, 2 * j) = entry.sourceWindow;
        windows(i, 2 * j + 1) = entry.destinationWindow;
    }

    TransitionTable done() &&
    {
        return {.cost = SharedTable<float>(std::move(cost)),
                .length = SharedTable<std::uint16_t>(std::move(length)),
                .windows = SharedTable<std::uint16_t>(std::move(windows))};
    }

    Table<float> cost;
    Table<std::uint16_t> length;
    Table<std::uint16_t> windows;
};

void store(TableInWork& table, Rows rows, std::span<const Entry> entries)
{
    const auto frames = table.cost.cols();
    for (NodeIndex r = 0; r < rows.count; ++r)
        for (Eigen::Index j = 0; j < frames; ++j)
            table.set(rows.first + r, j, entries[static_cast<std::size_t>(r * frames + j)]);
}

void checkTable(TableView<float> distances, const FrameLayout& layout)
{
    assert(distances.rows() == layout.frameCount() && distances.cols() == layout.frameCount());
    assert(distances.size() == 0 || (distances.isFinite().all() && distances.minCoeff() >= 0));
    (void)distances;
    (void)layout;
}

} // namespace

TransitionTable transitionTable(TableView<float> distances, const FrameLayout& layout,
                                const TransitionSettings& settings, const Progress& progress,
                                const Executor& executor)
{
    checkSettings(settings);
    checkTable(distances, layout);
    const CostGrid grid(largestOf(distances), settings);
    TableInWork table(layout.frameCount());
    const std::vector<Rows> tasks = tasksOf(layout);
    const auto rowsOf = [&tasks](std::int64_t task) { return tasks[static_cast<std::size_t>(task)]; };
    executor.run(
        makeTasks<Entry>(
            static_cast<std::int64_t>(tasks.size()),
            [&](std::int64_t task, const Progress& own) {
                return RowSearch(distances, layout, settings, grid).run(rowsOf(task), own);
            },
            [&](std::int64_t task, std::span<const Entry> entries) { store(table, rowsOf(task), entries); }),
        progress);
    return std::move(table).done();
}

TransitionTable linearTransitionTable(TableView<float> distances, const FrameLayout& layout,
                                      const TransitionSettings& settings, const Progress& progress)
{
    checkSettings(settings);
    checkTable(distances, layout);
    const bool mean = settings.cost == TransitionCost::Mean;
    TableInWork table(layout.frameCount());
    for (int s = 0; s < layout.sequenceCount(); ++s) {
        for (NodeIndex i = layout.firstOf(s); i <= layout.lastOf(s); ++i) {
            progress.report(i, layout.frameCount());
            for (int t = 0; t < layout.sequenceCount(); ++t) {
                const NodeIndex window = settings.shortestBetween(layout.countOf(s), layout.countOf(t));
                if (i + window - 1 > layout.lastOf(s))
                    continue;
                for (NodeIndex j = layout.firstOf(t) + window - 1; j <= layout.lastOf(t); ++j) {
                    if (i == j)
                        continue;
                    double sum = 0;
                    for (NodeIndex k = 0; k < window; ++k)
                        sum += static_cast<double>(distances(i + k, j - window + 1 + k));
                    const auto both = static_cast<std::uint16_t>(window);
                    table.set(i, j,
                              {.cost = static_cast<float>(mean ? sum / window : sum),
                               .length = both,
                               .sourceWindow = both,
                               .destinationWindow = both});
                }
            }
        }
    }
    progress.report(1);
    return std::move(table).done();
}

} // namespace quadrille
