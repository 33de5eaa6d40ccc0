// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/livegraph.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

LiveGraph makeLiveGraph(std::vector<std::shared_ptr<const MotionSpace>> spaces, double fps,
                        const SimilaritySettings& settings, const Progress& progress)
{
    if (spaces.empty())
        refuse("There is no motion space to play", "Make one of some takes.");
    if (!(fps > 0) || !std::isfinite(fps))
        refuse("The rate of a live graph is not positive", "Set the rate of the project.");
    for (const auto& space : spaces) {
        if (space->vertexCount() != spaces.front()->vertexCount() || space->up != spaces.front()->up)
            refuse("The motion spaces “" + spaces.front()->name + "” and “" + space->name +
                       "” are of different characters",
                   "Play those of one character together.");
    }
    LiveGraph graph{.fps = fps, .spaces = std::move(spaces), .tables = {}};
    const std::size_t count = graph.spaces.size();
    graph.tables.resize(count, std::vector<std::shared_ptr<const SimilarityTable>>(count));
    const auto links = static_cast<double>(std::max<std::size_t>(count * (count - 1), 1));
    double done = 0;
    for (std::size_t source = 0; source < count; ++source) {
        for (std::size_t target = 0; target < count; ++target) {
            if (source == target)
                continue;
            graph.tables[source][target] = std::make_shared<const SimilarityTable>(
                similarities(*graph.spaces[source], *graph.spaces[target], settings,
                             progress.part(done / links, (done + 1) / links)));
            ++done;
        }
    }
    return graph;
}

} // namespace quadrille
