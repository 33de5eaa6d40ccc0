// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/matrixmarks.h"

#include <algorithm>
#include <iterator>

namespace quadrille::widgets {

MatrixPart MatrixPart::grown(int side) const
{
    const int rows = lastRow - firstRow + 1;
    const int columns = lastColumn - firstColumn + 1;
    return {std::max(firstRow - rows, 0), std::min(lastRow + rows, side - 1),
            std::max(firstColumn - columns, 0), std::min(lastColumn + columns, side - 1)};
}

std::vector<MatrixMark> thinMarks(const MatrixMarkRow& marks, int side, const MatrixPart& part, int cells)
{
    const int first = part.firstColumn / cells;
    const int last = part.lastColumn / cells;
    const MatrixMark none{-1, -1, 0};
    std::vector<MatrixMark> lightest(static_cast<std::size_t>(std::max(last - first + 1, 0)), none);
    std::vector<MatrixMark> thinned;
    std::vector<MatrixMark> ofRow;
    for (int square = part.firstRow / cells; square * cells <= part.lastRow; ++square) {
        for (int row = square * cells; row < std::min((square + 1) * cells, side); ++row) {
            ofRow.clear();
            marks(row, ofRow);
            for (const MatrixMark& mark : ofRow) {
                const int column = mark.column / cells;
                if (column < first || column > last)
                    continue;
                MatrixMark& kept = lightest[static_cast<std::size_t>(column - first)];
                if (kept == none || mark.weight < kept.weight)
                    kept = mark;
            }
        }
        std::ranges::copy_if(lightest, std::back_inserter(thinned),
                             [&none](const MatrixMark& mark) { return mark != none; });
        std::ranges::fill(lightest, none);
    }
    return thinned;
}

} // namespace quadrille::widgets
