// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/transitioncosts.h"

#include <random>

namespace quadrille {

/// Tables of random transitions for tests.
struct RandomTransitions
{
    std::uint32_t seed = 1;
    std::vector<std::int64_t> counts{5, 1, 7}; ///< frames of each sequence
    double missing = 0.2;                      ///< part of the pairs without a transition
    /// Costs are multiples of 1 / levels up to 1, so that few levels make many ties; 0: any number.
    int levels = 0;
    std::uint16_t shortest = 1; ///< least length of a transition; the greatest is 3 more
};

TransitionCosts makeTransitions(const RandomTransitions& random);

/// A graph whose weights are multiples of 1 / levels.
Digraph randomDigraph(std::uint32_t seed, NodeIndex nodes, double density, int levels);

/// Floyd–Warshall in three loops; 0 on the diagonal.
Table<double> plainPathCosts(const Table<double>& weights);

/// Costs of shortest paths from one node by Bellman and Ford, leaving one edge out.
std::vector<double> bellmanFord(const Table<double>& weights, NodeIndex from, NodeIndex leftOutTo);

} // namespace quadrille
