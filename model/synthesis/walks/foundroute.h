// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/constraintautomaton.h"

#include <algorithm>
#include <functional>

namespace quadrille {

/// A walk that a search found, with its stage at every frame that it comes to.
struct FoundRoute
{
    WalkRoute route;
    std::vector<AutomatonState> states; ///< at the start and after each move, settled
    double cost = 0;                    ///< total
    std::int64_t expansions = 0;        ///< until it was found
    bool optimal = false;
    double bound = 0; ///< no walk of the graph costs less; 0 where nothing is known
};

/// What a search has done.
struct SearchEffort
{
    std::int64_t expansions = 0;
    bool isComplete = false; ///< every way was tried: there is nothing better, or nothing at all
};

/// Receives each walk that is better than those before it.
using FoundCallback = std::function<void(const FoundRoute&)>;

/// The route to the last of states that know the one before them.
/// \param seen  states with `stage`, `parent` (−1: none) and `move`.
template <typename State>
FoundRoute routeTo(const State& last, const std::vector<State>& seen, double cost)
{
    FoundRoute found{.cost = cost};
    const State* state = &last;
    found.states.push_back(state->stage);
    while (state->parent >= 0) {
        found.route.moves.push_back(state->move);
        state = &seen[static_cast<std::size_t>(state->parent)];
        found.states.push_back(state->stage);
    }
    found.route.start = state->stage.node;
    std::reverse(found.states.begin(), found.states.end());
    std::reverse(found.route.moves.begin(), found.route.moves.end());
    return found;
}

} // namespace quadrille
