// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/alternatives.h"

#include <algorithm>
#include <cstdlib>

namespace quadrille {

namespace {

/// Whether playing on comes to the same frame for less.
bool playsOn(const TransitionCosts& costs, double alpha, const FramePair& pair)
{
    const FrameLayout& layout = costs.layout();
    return pair.destination > pair.source &&
           layout.sequenceOf(pair.source) == layout.sequenceOf(pair.destination) &&
           costs.weight(pair.source, pair.destination, alpha) > alpha * (pair.destination - pair.source);
}

struct WeightedPair
{
    double weight = 0;
    FramePair pair;
};

/// Transitions from some frames to others, the cheapest first.
std::vector<WeightedPair> candidatesOf(const TransitionCosts& costs, double alpha, NodeIndex firstSource,
                                       NodeIndex lastSource, NodeIndex firstDestination,
                                       NodeIndex lastDestination)
{
    std::vector<WeightedPair> candidates;
    for (NodeIndex i = firstSource; i <= lastSource; ++i)
        for (NodeIndex j = firstDestination; j <= lastDestination; ++j)
            if (costs.hasTransition(i, j) && !playsOn(costs, alpha, {i, j}))
                candidates.push_back({costs.weight(i, j, alpha), {i, j}});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const WeightedPair& a, const WeightedPair& b) { return a.weight < b.weight; });
    return candidates;
}

} // namespace

std::vector<FramePair> bestTransitions(const TransitionCosts& costs, double alpha, int from, int to,
                                       const AlternativeSettings& settings)
{
    const FrameLayout& layout = costs.layout();
    std::vector<FramePair> found;
    for (const WeightedPair& candidate : candidatesOf(costs, alpha, layout.firstOf(from), layout.lastOf(from),
                                                      layout.firstOf(to), layout.lastOf(to))) {
        if (std::ssize(found) >= settings.most)
            break;
        const auto isAlike = [&](const FramePair& other) {
            return std::abs(other.source - candidate.pair.source) < settings.apart &&
                   std::abs(other.destination - candidate.pair.destination) < settings.apart;
        };
        if (std::none_of(found.begin(), found.end(), isAlike))
            found.push_back(candidate.pair);
    }
    return found;
}

std::vector<FramePair> alternatives(const TransitionCosts& costs, double alpha, const FramePair& chosen,
                                    const AlternativeSettings& settings)
{
    const FrameLayout& layout = costs.layout();
    const int sequence = layout.sequenceOf(chosen.source);
    const NodeIndex first = std::max(chosen.source - settings.reach, layout.firstOf(sequence));
    const NodeIndex last = std::min(chosen.source + settings.reach, layout.lastOf(sequence));
    const std::vector<WeightedPair> candidates =
        candidatesOf(costs, alpha, first, last, 0, layout.frameCount() - 1);
    std::vector<FramePair> found{chosen};
    const auto wanted = static_cast<std::size_t>(settings.most) + 1;
    for (const WeightedPair& candidate : candidates) {
        if (found.size() == wanted)
            break;
        const auto isAlike = [&](const FramePair& other) {
            const NodeIndex shift = candidate.pair.destination - candidate.pair.source;
            return layout.sequenceOf(other.destination) == layout.sequenceOf(candidate.pair.destination) &&
                   std::abs(other.destination - other.source - shift) < settings.apart;
        };
        if (std::none_of(found.begin(), found.end(), isAlike))
            found.push_back(candidate.pair);
    }
    found.erase(found.begin());
    return found;
}

} // namespace quadrille
