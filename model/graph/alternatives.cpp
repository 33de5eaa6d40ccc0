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

} // namespace

std::vector<FramePair> alternatives(const TransitionCosts& costs, double alpha, const FramePair& chosen,
                                    const AlternativeSettings& settings)
{
    struct Candidate
    {
        double weight = 0;
        FramePair pair;
    };
    const FrameLayout& layout = costs.layout();
    const int sequence = layout.sequenceOf(chosen.source);
    const NodeIndex first = std::max(chosen.source - settings.reach, layout.firstOf(sequence));
    const NodeIndex last = std::min(chosen.source + settings.reach, layout.lastOf(sequence));
    std::vector<Candidate> candidates;
    for (NodeIndex i = first; i <= last; ++i)
        for (NodeIndex j = 0; j < layout.frameCount(); ++j)
            if (costs.hasTransition(i, j) && !playsOn(costs, alpha, {i, j}))
                candidates.push_back({costs.weight(i, j, alpha), {i, j}});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.weight < b.weight; });
    std::vector<FramePair> found{chosen};
    const auto wanted = static_cast<std::size_t>(settings.most) + 1;
    for (const Candidate& candidate : candidates) {
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
