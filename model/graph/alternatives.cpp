// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/alternatives.h"

#include <algorithm>
#include <cstdlib>

namespace quadrille {

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
            if (costs.hasTransition(i, j))
                candidates.push_back({costs.weight(i, j, alpha), {i, j}});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.weight < b.weight; });
    std::vector<FramePair> found{chosen};
    const auto wanted = static_cast<std::size_t>(settings.most) + 1;
    for (const Candidate& candidate : candidates) {
        if (found.size() == wanted)
            break;
        const auto isAlike = [&](const FramePair& other) {
            return std::abs(other.source - candidate.pair.source) < settings.apart &&
                   std::abs(other.destination - candidate.pair.destination) < settings.apart;
        };
        if (std::none_of(found.begin(), found.end(), isAlike))
            found.push_back(candidate.pair);
    }
    found.erase(found.begin());
    return found;
}

} // namespace quadrille
