// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
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

/// Adds the marks of a row to others: they stay where they are, as there may be millions.
using MatrixMarkRow = std::function<void(int row, std::vector<MatrixMark>& marks)>;

/// Some rows and columns of a table; both ends belong to it.
struct MatrixPart
{
    int firstRow = 0;
    int lastRow = -1;
    int firstColumn = 0;
    int lastColumn = -1;

    bool contains(const MatrixPart& other) const
    {
        return firstRow <= other.firstRow && other.lastRow <= lastRow && firstColumn <= other.firstColumn &&
               other.lastColumn <= lastColumn;
    }
    /// With as much again around it, inside a table of so many rows and columns.
    MatrixPart grown(int side) const;
};

/// Of every square of cells that has marks the lightest (of two alike the first), by rows of squares.
/// Cost: O(marks of these rows + squares of the part).
/// \param part  of a table with `side` rows; is made larger to whole squares. \param cells  along each side
/// of a square; one gives all marks.
std::vector<MatrixMark> thinMarks(const MatrixMarkRow& marks, int side, const MatrixPart& part, int cells);

} // namespace quadrille::widgets
