// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace quadrille::widgets {

/// A cell that is marked; of several that fall together on the screen the one of the least weight is shown.
struct MatrixMark
{
    int row = 0;
    int column = 0;
    float weight = 0;
    bool operator==(const MatrixMark&) const = default;
};

/// One cell gives all back as they are. Cost: O(marks + (side / cells)²).
/// \param cells  how many cells along each side share one mark.
/// \return of every square of cells that has marks the lightest (of two alike the first), by rows of squares.
std::vector<MatrixMark> thinMarks(const std::vector<MatrixMark>& marks, int cells);

} // namespace quadrille::widgets
