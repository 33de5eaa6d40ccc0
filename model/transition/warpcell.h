// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/costgrid.h"
#include "model/transition/windowkernel.h"

#include <algorithm>

namespace quadrille {

/// A minimum that becomes one instruction, where numbers are known to be finite.
template <typename T>
[[gnu::always_inline]] inline T lesser(T a, T b)
{
    return a < b ? a : b;
}

/// A number for each of the destination frames that are computed together. It stays in registers: two vectors
/// of a width that most machines have, as the compiler takes wider ones apart number by number where it does
/// not know them.
struct Lanes
{
    using Four = double __attribute__((vector_size(32), aligned(8), may_alias));
    static_assert(windowLanes == 8);

    Four low;
    Four high;

    [[gnu::always_inline]] static inline Lanes load(const double* from)
    {
        return {*reinterpret_cast<const Four*>(from), *reinterpret_cast<const Four*>(from + 4)};
    }
    /// The same number everywhere.
    [[gnu::always_inline]] static inline Lanes all(double value)
    {
        const Four four{value, value, value, value};
        return {four, four};
    }
    [[gnu::always_inline]] inline void store(double* to) const
    {
        *reinterpret_cast<Four*>(to) = low;
        *reinterpret_cast<Four*>(to + 4) = high;
    }
};

[[gnu::always_inline]] inline Lanes operator+(const Lanes& a, const Lanes& b)
{
    return {a.low + b.low, a.high + b.high};
}

[[gnu::always_inline]] inline Lanes operator*(const Lanes& a, const Lanes& b)
{
    return {a.low * b.low, a.high * b.high};
}

[[gnu::always_inline]] inline Lanes lesser(const Lanes& a, const Lanes& b)
{
    return {a.low < b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}

/// What a cell of the dynamic programme hands to the row below it: least sums of the paths that end in it,
/// Lanes each.
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
    Lanes diagonal = Lanes::all(CostGrid::outOfReach); ///< `all` of the cell above the last one
    Lanes notRight = Lanes::all(CostGrid::outOfReach); ///< of the last cell
    Lanes right[Slope - 1];                            ///< of the last cell, after 1, 2, … steps

    [[gnu::always_inline]] inline WarpRow()
    {
        std::fill_n(right, Slope - 1, Lanes::all(CostGrid::outOfReach));
    }

    /// The first cell of paths. \param cell  out of reach so far.
    [[gnu::always_inline]] inline void start(const Lanes& key, double* cell)
    {
        key.store(cell + WarpCell<Slope>::all);
        key.store(cell + WarpCell<Slope>::notDown);
        notRight = key;
    }

    /// Goes to the next cell. \param cell  that of the row above, becomes that of this row.
    [[gnu::always_inline]] inline void step(const Lanes& key, double* cell)
    {
        const Lanes straight = diagonal + key;
        diagonal = Lanes::load(cell + WarpCell<Slope>::all);
        Lanes downs = Lanes::load(cell + WarpCell<Slope>::notDown) + key;
        Lanes rights = notRight + key;
        Lanes previousDown = downs;
        Lanes previousRight = rights;
        for (int s = 0; s < Slope - 1; ++s) {
            double* const down = cell + WarpCell<Slope>::down + s * windowLanes;
            const Lanes oneDown = Lanes::load(down) + key;
            previousDown.store(down);
            previousDown = oneDown;
            downs = lesser(downs, oneDown);
            const Lanes oneRight = right[s] + key;
            right[s] = previousRight;
            previousRight = oneRight;
            rights = lesser(rights, oneRight);
        }
        notRight = lesser(straight, downs);
        lesser(straight, rights).store(cell + WarpCell<Slope>::notDown);
        lesser(notRight, rights).store(cell + WarpCell<Slope>::all);
    }
};

} // namespace quadrille
