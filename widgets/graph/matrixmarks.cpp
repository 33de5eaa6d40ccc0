// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/matrixmarks.h"

#include <algorithm>
#include <tuple>

namespace quadrille::widgets {

std::vector<MatrixMark> thinMarks(const std::vector<MatrixMark>& marks, int cells)
{
    if (cells <= 1)
        return marks;
    const auto square = [cells](const MatrixMark& mark) {
        return std::pair(mark.row / cells, mark.column / cells);
    };
    std::vector<MatrixMark> thinned = marks;
    std::stable_sort(thinned.begin(), thinned.end(), [&](const MatrixMark& a, const MatrixMark& b) {
        return std::tuple(square(a), a.weight) < std::tuple(square(b), b.weight);
    });
    const auto end =
        std::unique(thinned.begin(), thinned.end(),
                    [&](const MatrixMark& a, const MatrixMark& b) { return square(a) == square(b); });
    thinned.erase(end, thinned.end());
    return thinned;
}

} // namespace quadrille::widgets
