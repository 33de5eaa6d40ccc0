// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/besttransitions.h"

#include "model/core/error.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace quadrille {

namespace {

void check(const FrameLayout& layout, const AlternativesRequest& request)
{
    const auto refuse = [](std::string reason, std::string remedy) {
        throw Error(ErrorCode::BadArgument,
                    {.file = {},
                     .place = {},
                     .values = {{"reason", std::move(reason)}, {"remedy", std::move(remedy)}}});
    };
    for (const int sequence : {request.sourceSequence, request.destinationSequence}) {
        if (sequence < 0 || sequence >= layout.sequenceCount())
            refuse("There is no sequence " + std::to_string(sequence),
                   "Choose one of the " + std::to_string(layout.sequenceCount()) + " sequences.");
    }
    if (request.count < 0 || request.spacing < 0)
        refuse("The number of transitions or their spacing is negative", "Give numbers from 0 on.");
}

/// The block of costs between two sequences.
class Block
{
public:
    Block(const TransitionTable& table, const FrameLayout& layout, const AlternativesRequest& request)
        : m_table(table)
        , m_firstSource(layout.firstOf(request.sourceSequence))
        , m_lastSource(layout.lastOf(request.sourceSequence))
        , m_firstDestination(layout.firstOf(request.destinationSequence))
        , m_lastDestination(layout.lastOf(request.destinationSequence))
        , m_same(request.sourceSequence == request.destinationSequence)
    {
    }

    float cost(FramePair pair) const
    {
        const bool inside = pair.source >= m_firstSource && pair.source <= m_lastSource &&
                            pair.destination >= m_firstDestination && pair.destination <= m_lastDestination;
        if (!inside || isNoGain(pair))
            return TransitionTable::none;
        return m_table.cost(pair.source, pair.destination);
    }

    std::vector<FramePair> minima() const
    {
        std::vector<FramePair> found;
        for (NodeIndex i = m_firstSource; i <= m_lastSource; ++i) {
            for (NodeIndex j = m_firstDestination; j <= m_lastDestination; ++j) {
                if (isMinimum({.source = i, .destination = j}))
                    found.push_back({.source = i, .destination = j});
            }
        }
        return found;
    }

private:
    /// Forward in one sequence, where playing on takes no longer.
    bool isNoGain(FramePair pair) const
    {
        return m_same && pair.source < pair.destination &&
               m_table.length(pair.source, pair.destination) > pair.destination - pair.source;
    }

    bool isMinimum(FramePair pair) const
    {
        const float own = cost(pair);
        if (own == TransitionTable::none)
            return false;
        for (int di = -1; di <= 1; ++di) {
            for (int dj = -1; dj <= 1; ++dj) {
                if (cost({.source = pair.source + di, .destination = pair.destination + dj}) < own)
                    return false;
            }
        }
        return true;
    }

    const TransitionTable& m_table;
    NodeIndex m_firstSource;
    NodeIndex m_lastSource;
    NodeIndex m_firstDestination;
    NodeIndex m_lastDestination;
    bool m_same;
};

} // namespace

std::vector<FramePair> bestTransitions(const TransitionTable& table, const FrameLayout& layout,
                                       const AlternativesRequest& request)
{
    check(layout, request);
    const Block block(table, layout, request);
    std::vector<FramePair> minima = block.minima();
    std::stable_sort(minima.begin(), minima.end(),
                     [&](FramePair a, FramePair b) { return block.cost(a) < block.cost(b); });
    std::vector<FramePair> chosen;
    for (const FramePair pair : minima) {
        if (chosen.size() >= static_cast<std::size_t>(request.count))
            break;
        const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](FramePair other) {
            return std::abs(pair.source - other.source) >= request.spacing ||
                   std::abs(pair.destination - other.destination) >= request.spacing;
        });
        if (apart)
            chosen.push_back(pair);
    }
    return chosen;
}

} // namespace quadrille
