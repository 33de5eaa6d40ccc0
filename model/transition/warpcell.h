// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/costgrid.h"
#include "model/transition/windowkernel.h"

#include <algorithm>

namespace quadrille {

/// A minimum that becomes one instruction.
[[gnu::always_inline]] inline double lesser(double a, double b)
{
    return a < b ? a : b;
}

/// What a cell of the dynamic programme hands to the row below it: least sums of the paths that end in it, a
/// vector of windowLanes each.
template <int Slope>
struct WarpCell
{
    static constexpr int all = 0;                ///< by any step
    static constexpr int notDown = windowLanes;  ///< by a diagonal step or one to the right
    static constexpr int down = 2 * windowLanes; ///< after 1, 2, … Slope − 1 steps down
    static constexpr int size = (Slope + 1) * windowLanes;
};

/// A row of the dynamic programme on its way to the right: 7 states for a slope of 3 (diagonal; 1–3 down; 1–3
/// right), folded into those that the next cells need.
template <int Slope>
struct WarpRow
{
    alignas(64) double diagonal[windowLanes];            ///< `all` of the cell above the last one
    alignas(64) double notRight[windowLanes];            ///< of the last cell
    alignas(64) double right[(Slope - 1) * windowLanes]; ///< of the last cell, after 1, 2, … steps

    [[gnu::always_inline]] inline void begin()
    {
        std::fill_n(diagonal, windowLanes, CostGrid::outOfReach);
        std::fill_n(notRight, windowLanes, CostGrid::outOfReach);
        std::fill_n(right, (Slope - 1) * windowLanes, CostGrid::outOfReach);
    }

    /// The first cell of paths. \param cell  out of reach so far.
    [[gnu::always_inline]] inline void start(const double* key, double* cell)
    {
        std::copy_n(key, windowLanes, cell + WarpCell<Slope>::all);
        std::copy_n(key, windowLanes, cell + WarpCell<Slope>::notDown);
        std::copy_n(key, windowLanes, notRight);
    }

    /// Goes to the next cell. \param cell  that of the row above, becomes that of this row.
    [[gnu::always_inline]] inline void step(const double* key, double* cell)
    {
#pragma omp simd
        for (int l = 0; l < windowLanes; ++l) {
            const double here = key[l];
            const double straight = diagonal[l] + here;
            diagonal[l] = cell[WarpCell<Slope>::all + l];
            double downs = cell[WarpCell<Slope>::notDown + l] + here;
            double rights = notRight[l] + here;
            double previousDown = downs;
            double previousRight = rights;
            for (int s = 0; s < Slope - 1; ++s) {
                double& down = cell[WarpCell<Slope>::down + s * windowLanes + l];
                const double oneDown = down + here;
                down = previousDown;
                previousDown = oneDown;
                downs = lesser(downs, oneDown);
                double& more = right[s * windowLanes + l];
                const double oneRight = more + here;
                more = previousRight;
                previousRight = oneRight;
                rights = lesser(rights, oneRight);
            }
            notRight[l] = lesser(straight, downs);
            cell[WarpCell<Slope>::notDown + l] = lesser(straight, rights);
            cell[WarpCell<Slope>::all + l] = lesser(notRight[l], rights);
        }
    }
};

} // namespace quadrille
