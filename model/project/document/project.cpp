// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/project.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

GraphEntry GraphEntry::paper()
{
    GraphEntry entry;
    entry.cost = TransitionCost::Sum;
    entry.costScale = CostScale::None;
    entry.length = TransitionLength::Path;
    entry.steps = {};
    entry.durations = {1.0 / 3, 2.0};
    return entry;
}

TransitionSettings transitionSettings(const GraphEntry& entry, double fps)
{
    TransitionSettings settings{.fps = fps, .slope = entry.slope, .cost = entry.cost, .length = entry.length};
    constexpr double rounding = 1e-9;
    const auto [shortest, longest] = entry.durations.value_or(usualDurations);
    settings.shortestWindow = std::max(1, static_cast<int>(std::ceil(fps * shortest - rounding)));
    settings.longestWindow =
        std::max(settings.shortest(), static_cast<int>(std::floor(fps * longest + rounding)));
    settings.shortensInShortTakes = !entry.durations;
    return settings;
}

} // namespace quadrille
