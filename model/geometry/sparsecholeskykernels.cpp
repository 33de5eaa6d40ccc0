// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/simd.h"
#include "model/geometry/sparsecholesky.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

// Four numbers fit the registers of AVX2; wider vectors would lie in memory there.
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

#define QUADRILLE_INLINE __attribute__((always_inline)) inline

/// A column of the front of a supernode: its own columns lie in the panel, the others in working memory.
struct Front
{
    double* panel;
    double* trailing;
    int columns;
    int rows;
    std::ptrdiff_t stride;

    QUADRILLE_INLINE double* column(int index) const
    {
        return index < columns ? panel + index * stride : trailing + (index - columns) * stride;
    }
};

/// Factorises the columns of the panel; each then has the inverse of its pivot on the diagonal.
QUADRILLE_INLINE void factorisePanel(const Front& front, const double* diagonal)
{
    for (int k = 0; k < front.columns; ++k) {
        double* const column = front.panel + k * front.stride;
        const double pivot = std::max(column[k], 1e-13 * diagonal[k]);
        const double inverse = 1.0 / std::sqrt(pivot);
        for (int r = k / 4 * 4; r < front.stride; r += 4)
            *reinterpret_cast<Four*>(column + r) *= inverse;
        for (int j = k + 1; j < front.columns; ++j) {
            double* const other = front.panel + j * front.stride;
            const double factor = column[j];
            for (int r = j / 4 * 4; r < front.stride; r += 4)
                *reinterpret_cast<Four*>(other + r) -= *reinterpret_cast<const Four*>(column + r) * factor;
        }
        column[k] = inverse;
    }
}

QUADRILLE_INLINE void subtract(double* out, const Four& upper, const Four& lower)
{
    *reinterpret_cast<Four*>(out) -= upper;
    *reinterpret_cast<Four*>(out + 4) -= lower;
}

/// Subtracts the outer products of the panel's columns from the trailing columns, four at once.
QUADRILLE_INLINE void updateTrailing(const Front& front)
{
    for (std::ptrdiff_t j = front.columns; j < front.rows; j += 4) {
        const std::ptrdiff_t count = front.rows - j;
        for (std::ptrdiff_t r = j / 8 * 8; r < front.stride; r += 8) {
            Four upper0{};
            Four upper1{};
            Four upper2{};
            Four upper3{};
            Four lower0{};
            Four lower1{};
            Four lower2{};
            Four lower3{};
            const double* column = front.panel;
            for (int k = 0; k < front.columns; ++k, column += front.stride) {
                const Four upper = *reinterpret_cast<const Four*>(column + r);
                const Four lower = *reinterpret_cast<const Four*>(column + r + 4);
                upper0 += upper * column[j];
                lower0 += lower * column[j];
                upper1 += upper * column[j + 1];
                lower1 += lower * column[j + 1];
                upper2 += upper * column[j + 2];
                lower2 += lower * column[j + 2];
                upper3 += upper * column[j + 3];
                lower3 += lower * column[j + 3];
            }
            double* const out = front.trailing + (j - front.columns) * front.stride + r;
            subtract(out, upper0, lower0);
            if (count > 1)
                subtract(out + front.stride, upper1, lower1);
            if (count > 2)
                subtract(out + 2 * front.stride, upper2, lower2);
            if (count > 3)
                subtract(out + 3 * front.stride, upper3, lower3);
        }
    }
}

QUADRILLE_SIMD_CLONES void factoriseFronts(const CholeskyPattern& pattern, const double* values,
                                           double* panels, double* work, double* diagonal)
{
    const std::vector<Supernode>& nodes = pattern.supernodes();
    for (std::size_t s = 0; s + 1 < nodes.size(); ++s) {
        const Supernode& node = nodes[s];
        const Front front{panels + node.panelAt, work, node.columns, node.rows, node.stride};
        const int below = node.rows - node.columns;
        std::fill_n(front.panel, front.stride * node.columns, 0.0);
        std::fill_n(front.trailing, front.stride * below, 0.0);
        for (std::size_t e = node.entriesAt; e < nodes[s + 1].entriesAt; ++e) {
            const CholeskyPattern::Entry entry = pattern.entries()[e];
            front.panel[entry.place] = values[entry.value];
        }
        for (int k = 0; k < node.columns; ++k)
            diagonal[k] = front.panel[k * front.stride + k];
        for (std::size_t c = node.childrenAt; c < nodes[s + 1].childrenAt; ++c) {
            const Supernode& child = nodes[static_cast<std::size_t>(pattern.children()[c])];
            const int size = child.rows - child.columns;
            const int* const relative = pattern.relative().data() + child.relativeAt;
            const double* update = work + child.updateAt;
            for (int k = 0; k < size; ++k, update += size) {
                double* const column = front.column(relative[k]);
                for (int r = k; r < size; ++r)
                    column[relative[r]] += update[r];
            }
        }
        factorisePanel(front, diagonal);
        updateTrailing(front);
        double* update = work + node.updateAt;
        for (int k = 0; k < below; ++k, update += below) {
            const double* const column = front.trailing + k * front.stride + node.columns;
            for (int r = k; r < below; ++r)
                update[r] = column[r];
        }
    }
}

QUADRILLE_INLINE Four* row(double* x, int index)
{
    return reinterpret_cast<Four*>(x + std::ptrdiff_t{4} * index);
}

QUADRILLE_SIMD_CLONES void solveForward(const CholeskyPattern& pattern, const double* panels, double* x)
{
    const std::vector<Supernode>& nodes = pattern.supernodes();
    for (std::size_t s = 0; s + 1 < nodes.size(); ++s) {
        const Supernode& node = nodes[s];
        const double* const panel = panels + node.panelAt;
        const int* const rows = pattern.rows().data() + node.rowsAt;
        for (int k = 0; k < node.columns; ++k) {
            const double* const column = panel + std::ptrdiff_t{k} * node.stride;
            const Four value = *row(x, node.first + k) * column[k];
            *row(x, node.first + k) = value;
            for (int r = k + 1; r < node.columns; ++r)
                *row(x, node.first + r) -= value * column[r];
        }
        for (int r = node.columns; r < node.rows; r += 4) {
            Four sum0{};
            Four sum1{};
            Four sum2{};
            Four sum3{};
            const double* entry = panel + r;
            for (int k = 0; k < node.columns; ++k, entry += node.stride) {
                const Four value = *row(x, node.first + k);
                sum0 += value * entry[0];
                sum1 += value * entry[1];
                sum2 += value * entry[2];
                sum3 += value * entry[3];
            }
            const int count = node.rows - r;
            *row(x, rows[r]) -= sum0;
            if (count > 1)
                *row(x, rows[r + 1]) -= sum1;
            if (count > 2)
                *row(x, rows[r + 2]) -= sum2;
            if (count > 3)
                *row(x, rows[r + 3]) -= sum3;
        }
    }
}

QUADRILLE_SIMD_CLONES void solveBackward(const CholeskyPattern& pattern, const double* panels, double* x,
                                         double* gathered)
{
    const std::vector<Supernode>& nodes = pattern.supernodes();
    for (std::size_t s = nodes.size() - 1; s-- > 0;) {
        const Supernode& node = nodes[s];
        const double* const panel = panels + node.panelAt;
        const int* const rows = pattern.rows().data() + node.rowsAt;
        for (int r = node.columns; r < node.rows; ++r)
            *row(gathered, r) = *row(x, rows[r]);
        for (int k = 0; k < node.columns; k += 4) {
            const std::ptrdiff_t stride = node.stride;
            const int count = std::min(4, node.columns - k);
            // Columns past the last repeat it; their sums are not used.
            const double* const column0 = panel + k * stride;
            const double* const column1 = panel + std::min(k + 1, node.columns - 1) * stride;
            const double* const column2 = panel + std::min(k + 2, node.columns - 1) * stride;
            const double* const column3 = panel + std::min(k + 3, node.columns - 1) * stride;
            Four sum0{};
            Four sum1{};
            Four sum2{};
            Four sum3{};
            for (int r = node.columns; r < node.rows; ++r) {
                const Four value = *row(gathered, r);
                sum0 += value * column0[r];
                sum1 += value * column1[r];
                sum2 += value * column2[r];
                sum3 += value * column3[r];
            }
            *row(x, node.first + k) -= sum0;
            if (count > 1)
                *row(x, node.first + k + 1) -= sum1;
            if (count > 2)
                *row(x, node.first + k + 2) -= sum2;
            if (count > 3)
                *row(x, node.first + k + 3) -= sum3;
        }
        for (int k = node.columns; k-- > 0;) {
            const double* const column = panel + std::ptrdiff_t{k} * node.stride;
            Four value = *row(x, node.first + k);
            for (int r = k + 1; r < node.columns; ++r)
                value -= *row(x, node.first + r) * column[r];
            *row(x, node.first + k) = value * column[k];
        }
    }
}

#undef QUADRILLE_INLINE

} // namespace

void CholeskyFactor::factorise(const CholeskyPattern& pattern, std::span<const double> values)
{
    m_pattern = &pattern;
    // Vectors of a last column may be read past its end.
    m_panels.resize(pattern.panelSize() + 8);
    std::vector<double> work(pattern.workSize());
    std::vector<double> diagonal(static_cast<std::size_t>(pattern.longestRows()));
    factoriseFronts(pattern, values.data(), m_panels.data(), work.data(), diagonal.data());
}

void CholeskyFactor::solve(std::span<double> x) const
{
    std::vector<double> gathered(static_cast<std::size_t>(m_pattern->longestRows()) * lanes);
    solveForward(*m_pattern, m_panels.data(), x.data());
    solveBackward(*m_pattern, m_panels.data(), x.data(), gathered.data());
}

} // namespace quadrille
