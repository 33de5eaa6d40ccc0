// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/matrixmarks.h"

#include <algorithm>

namespace quadrille::widgets {

std::vector<MatrixMark> thinMarks(const std::vector<MatrixMark>& marks, int cells)
{
    if (cells <= 1)
        return marks;
    int last = 0;
    for (const MatrixMark& mark : marks)
        last = std::max({last, mark.row, mark.column});
    const auto across = static_cast<std::size_t>(last / cells) + 1;
    std::vector<const MatrixMark*> lightest(across * across);
    for (const MatrixMark& mark : marks) {
        const auto row = static_cast<std::size_t>(mark.row / cells);
        const MatrixMark*& kept = lightest[row * across + static_cast<std::size_t>(mark.column / cells)];
        if (kept == nullptr || mark.weight < kept->weight)
            kept = &mark;
    }
    std::vector<MatrixMark> thinned;
    for (const MatrixMark* mark : lightest)
        if (mark != nullptr)
            thinned.push_back(*mark);
    return thinned;
}

} // namespace quadrille::widgets
