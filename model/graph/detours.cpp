// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/detours.h"

#include <limits>

namespace quadrille {

Table<double> cheapestDetours(const Table<double>& weights, const Progress& progress)
{
    // Graphs of takes are relaxed in some four sweeps over their edges, random ones in more.
    constexpr Eigen::Index sparseShare = 5;
    const Eigen::Index edges = (weights < std::numeric_limits<double>::infinity()).count();
    return edges * sparseShare < weights.size() ? sparseDetours(weights, progress)
                                                : denseDetours(weights, progress);
}

} // namespace quadrille
