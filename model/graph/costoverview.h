// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/transition/framelayout.h"

namespace quadrille {

/// The ends of the colours that costs of transitions are shown in, unit of the costs.
struct CostRange
{
    double minimum = 0;
    double maximum = 1;
};
/// From the least cost to one that nine tenths of the transitions stay below, judged by some 200,000 of them.
/// \param cost  infinite where there is no transition. Cost: O(1) in the size of the table.
CostRange costRange(TableView<float> cost);

/// Costs of transitions as they are seen from afar.
struct CostOverview
{
    FrameLayout layout;
    int framesOfCell = 1; ///< that a cell stands for along each side, a power of two
    Table<float> least;   ///< least cost in each square of frames; infinite where there is no transition
    CostRange range;      ///< of all of them
};
/// \param cost  frames × frames, infinite where there is no transition. \param side  at most so many cells
/// along each side, at least 1. Cost: O(frames²).
CostOverview costOverview(TableView<float> cost, const FrameLayout& layout, int side = 1000);

} // namespace quadrille
