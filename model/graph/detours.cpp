// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/detours.h"

#include <limits>
#include <numeric>
#include <vector>

namespace quadrille {

Table<double> cheapestDetours(const Table<double>& weights, const Progress& progress)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    Table<double> detours = Table<double>::Constant(weights.rows(), weights.cols(), none);
    std::vector<NodeIndex> all(static_cast<std::size_t>(weights.rows()));
    std::iota(all.begin(), all.end(), 0);
    lowerDetours(weights, all, detours, progress);
    return detours;
}

void lowerDetours(const Table<double>& weights, std::span<const NodeIndex> junctions, Table<double>& detours,
                  const Progress& progress)
{
    // Graphs of takes are relaxed in some four sweeps, each edge a little slower than in the dense way.
    constexpr Eigen::Index sweeps = 5;
    const Eigen::Index edges = (weights < std::numeric_limits<double>::infinity()).count();
    if (edges * sweeps < std::ssize(junctions) * weights.cols())
        lowerDetoursSparsely(weights, detours, progress);
    else
        lowerDetoursDensely(weights, junctions, detours, progress);
}

} // namespace quadrille
