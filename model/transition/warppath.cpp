// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/warppath.h"

#include "model/core/badargument.h"
#include "model/core/error.h"
#include "model/transition/warpsolver.h"
#include "model/transition/windowkernel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace quadrille {

namespace {

/// Which of `cells` the t-th of `length` is, when they are spread from the first to the last.
std::size_t evenly(int t, int length, int cells)
{
    const int gaps = std::max(length - 1, 1);
    return static_cast<std::size_t>((2 * t * (cells - 1) + gaps) / (2 * gaps));
}

} // namespace

WarpPaths::WarpPaths(TableView<float> distances, FrameLayout layout, const TransitionSettings& settings)
    : WarpPaths(
          [distances](NodeIndex i, NodeIndex first, std::span<float> row) {
              std::copy_n(&distances.coeffRef(i, first), row.size(), row.begin());
          },
          distances.size() == 0 ? 0 : distances.maxCoeff(), std::move(layout), settings)
{
    assert(distances.rows() == m_layout.frameCount() && distances.cols() == m_layout.frameCount());
}

WarpPaths::WarpPaths(DistanceRows rows, float largest, FrameLayout layout, const TransitionSettings& settings)
    : m_rows(std::move(rows))
    , m_layout(std::move(layout))
    , m_settings((checkSettings(settings), settings))
    , m_grid(largest, settings)
{
}

int WarpPaths::framesFrom(NodeIndex source) const
{
    return m_layout.lastOf(m_layout.sequenceOf(source)) - source + 1;
}

int WarpPaths::framesTo(NodeIndex destination) const
{
    return destination - m_layout.firstOf(m_layout.sequenceOf(destination)) + 1;
}

std::optional<Transition> WarpPaths::solve(FramePair frames, int sourceWindow, int destinationWindow,
                                           Mean guess) const
{
    const NodeIndex firstDestination = frames.destination - destinationWindow + 1;
    WarpSolver programme(m_settings.slope, sourceWindow, destinationWindow);
    std::vector<float> row(static_cast<std::size_t>(destinationWindow));
    for (int r = 0; r < sourceWindow; ++r) {
        m_rows(frames.source + r, firstDestination, row);
        programme.setRow(r, row.data(), m_grid.unit);
    }
    const bool mean = m_settings.cost == TransitionCost::Mean;
    WarpSolver::Best best;
    double sum = 0;
    // For means, see improveToLeastMeans; without a guess the first path is the one of the least sum.
    for (double rest = -1; rest != 0;) {
        best = programme.solve(guess.length * m_grid.lengthOne, 1 - guess.steps * m_grid.lengthOne);
        if (best.path.empty())
            return std::nullopt;
        const auto length = static_cast<double>(best.path.size());
        rest = mean ? m_grid.stepsOfKey(best.key) : 0;
        sum = mean ? (rest + guess.steps * length) / guess.length : m_grid.stepsOfKey(best.key);
        guess = {.steps = sum, .length = length};
    }
    Transition found{.frames = frames,
                     .sourceWindow = sourceWindow,
                     .destinationWindow = destinationWindow,
                     .cost = m_grid.costOf(sum, static_cast<int>(best.path.size()), m_settings.cost),
                     .path = {}};
    const auto cells = static_cast<int>(best.path.size());
    const int length = m_settings.lengthOf(cells, sourceWindow, destinationWindow);
    found.path.reserve(static_cast<std::size_t>(length));
    for (int t = 0; t < length; ++t) {
        const WarpSolver::Cell& cell = best.path[evenly(t, length, cells)];
        found.path.push_back(
            {.source = frames.source + cell.row, .destination = firstDestination + cell.column});
    }
    return found;
}

int WarpPaths::shortestOf(FramePair frames) const
{
    return m_settings.shortestBetween(m_layout.countOf(m_layout.sequenceOf(frames.source)),
                                      m_layout.countOf(m_layout.sequenceOf(frames.destination)));
}

std::optional<Transition> WarpPaths::find(FramePair frames) const
{
    for (const NodeIndex frame : {frames.source, frames.destination}) {
        if (frame < 0 || frame >= m_layout.frameCount())
            refuse("There is no frame " + std::to_string(frame),
                   "Choose a frame from 0 to " + std::to_string(m_layout.frameCount() - 1) + ".");
    }
    const int rows = std::min(m_settings.longest(), framesFrom(frames.source));
    const int columns = std::min(m_settings.longest(), framesTo(frames.destination));
    const int shortest = shortestOf(frames);
    if (frames.source == frames.destination || std::min(rows, columns) < shortest)
        return std::nullopt;
    WindowSearch search{.rows = rows,
                        .columns = columns,
                        .shortest = shortest,
                        .longest = m_settings.longest(),
                        .slope = m_settings.slope};
    search.stride = columns + 2 * search.margin();
    std::vector<double> keys(static_cast<std::size_t>(rows * search.stride), CostGrid::outOfReach);
    search.keys = keys.data() + search.margin();
    std::vector<float> row(static_cast<std::size_t>(columns));
    for (int r = 0; r < rows; ++r) {
        m_rows(frames.source + r, frames.destination - columns + 1, row);
        std::transform(row.begin(), row.end(), keys.begin() + r * search.stride + search.margin(),
                       [this](float distance) { return m_grid.keyOf(distance); });
    }
    BestWindows best;
    WindowScratch scratch;
    searchLeastSums(search, best, scratch);
    if (m_settings.cost == TransitionCost::Mean)
        improveToLeastMeans(search, m_grid.lengthOne, nullptr, best, scratch);
    const double key = best.key[static_cast<std::size_t>(columns - 1)];
    if (key >= CostGrid::unknown)
        return std::nullopt;
    const Mean mean{.steps = m_grid.stepsOfKey(key), .length = static_cast<double>(m_grid.lengthOfKey(key))};
    return solve(frames, best.sourceWindow[static_cast<std::size_t>(columns - 1)],
                 best.destinationWindow[static_cast<std::size_t>(columns - 1)],
                 m_settings.cost == TransitionCost::Mean ? mean : Mean{});
}

Transition WarpPaths::get(FramePair frames) const
{
    std::optional<Transition> found = find(frames);
    if (frames.source == frames.destination)
        refuse("A transition needs two different frames", "Choose another destination.");
    if (!found)
        throw Error(ErrorCode::NoTransition,
                    {.file = {},
                     .place = {},
                     .values = {{"source", std::to_string(frames.source)},
                                {"destination", std::to_string(frames.destination)},
                                {"needed", std::to_string(shortestOf(frames))},
                                {"after", std::to_string(framesFrom(frames.source))},
                                {"before", std::to_string(framesTo(frames.destination))}}});
    return *std::move(found);
}

std::optional<Transition> WarpPaths::between(FramePair frames, int sourceWindow, int destinationWindow) const
{
    assert(sourceWindow >= 1 && sourceWindow <= std::min(m_settings.longest(), framesFrom(frames.source)));
    assert(destinationWindow >= 1 &&
           destinationWindow <= std::min(m_settings.longest(), framesTo(frames.destination)));
    return solve(frames, sourceWindow, destinationWindow, {});
}

std::optional<Transition> WarpPaths::of(const KnownTransition& known, FramePair frames) const
{
    if (known.sourceWindow == 0)
        return std::nullopt;
    Mean guess;
    if (m_settings.cost == TransitionCost::Mean) {
        guess.length = known.length;
        guess.steps = std::round(static_cast<double>(known.cost) * guess.length / m_grid.unit);
    }
    return solve(frames, known.sourceWindow, known.destinationWindow, guess);
}

std::optional<Transition> WarpPaths::linear(FramePair frames) const
{
    const int window = shortestOf(frames);
    if (frames.source == frames.destination || framesFrom(frames.source) < window ||
        framesTo(frames.destination) < window)
        return std::nullopt;
    Transition found{
        .frames = frames, .sourceWindow = window, .destinationWindow = window, .cost = 0, .path = {}};
    double sum = 0;
    for (int k = 0; k < window; ++k) {
        found.path.push_back(
            {.source = frames.source + k, .destination = frames.destination - window + 1 + k});
        float distance = 0;
        m_rows(found.path.back().source, found.path.back().destination, std::span(&distance, 1));
        sum += static_cast<double>(distance);
    }
    found.cost = static_cast<float>(m_settings.cost == TransitionCost::Mean ? sum / window : sum);
    return found;
}

} // namespace quadrille
