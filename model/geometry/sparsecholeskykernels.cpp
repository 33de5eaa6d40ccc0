// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/simd.h"
#include "model/geometry/sparsecholesky.h"

#include <algorithm>
#include <array>
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

/// A row of some groups of four right-hand sides.
template <int groups>
struct Row
{
    struct Group
    {
        Four four{};
    };
    std::array<Group, groups> values;

    QUADRILLE_INLINE static Row* at(double* x, int index)
    {
        return reinterpret_cast<Row*>(x + std::ptrdiff_t{4} * groups * index);
    }
    QUADRILLE_INLINE void add(const Row& other, double factor)
    {
        for (std::size_t g = 0; g < groups; ++g)
            values[g].four += other.values[g].four * factor;
    }
    QUADRILLE_INLINE void subtract(const Row& other)
    {
        for (std::size_t g = 0; g < groups; ++g)
            values[g].four -= other.values[g].four;
    }
    QUADRILLE_INLINE void scale(double factor)
    {
        for (std::size_t g = 0; g < groups; ++g)
            values[g].four *= factor;
    }
};

template <int groups>
QUADRILLE_INLINE void forward(const CholeskyPattern& pattern, const double* panels, double* x)
{
    using Own = Row<groups>;
    const std::vector<Supernode>& nodes = pattern.supernodes();
    for (std::size_t s = 0; s + 1 < nodes.size(); ++s) {
        const Supernode& node = nodes[s];
        const double* const panel = panels + node.panelAt;
        const int* const rows = pattern.rows().data() + node.rowsAt;
        for (int k = 0; k < node.columns; ++k) {
            const double* const column = panel + std::ptrdiff_t{k} * node.stride;
            Own value = *Own::at(x, node.first + k);
            value.scale(column[k]);
            *Own::at(x, node.first + k) = value;
            for (int r = k + 1; r < node.columns; ++r)
                Own::at(x, node.first + r)->add(value, -column[r]);
        }
        for (int r = node.columns; r < node.rows; r += 4) {
            Own sum0;
            Own sum1;
            Own sum2;
            Own sum3;
            const double* entry = panel + r;
            for (int k = 0; k < node.columns; ++k, entry += node.stride) {
                const Own value = *Own::at(x, node.first + k);
                sum0.add(value, entry[0]);
                sum1.add(value, entry[1]);
                sum2.add(value, entry[2]);
                sum3.add(value, entry[3]);
            }
            const int count = node.rows - r;
            Own::at(x, rows[r])->subtract(sum0);
            if (count > 1)
                Own::at(x, rows[r + 1])->subtract(sum1);
            if (count > 2)
                Own::at(x, rows[r + 2])->subtract(sum2);
            if (count > 3)
                Own::at(x, rows[r + 3])->subtract(sum3);
        }
    }
}

template <int groups>
QUADRILLE_INLINE void backward(const CholeskyPattern& pattern, const double* panels, double* x,
                               double* gathered)
{
    using Own = Row<groups>;
    const std::vector<Supernode>& nodes = pattern.supernodes();
    for (std::size_t s = nodes.size() - 1; s-- > 0;) {
        const Supernode& node = nodes[s];
        const double* const panel = panels + node.panelAt;
        const int* const rows = pattern.rows().data() + node.rowsAt;
        for (int r = node.columns; r < node.rows; ++r)
            *Own::at(gathered, r) = *Own::at(x, rows[r]);
        for (int k = 0; k < node.columns; k += 4) {
            const std::ptrdiff_t stride = node.stride;
            const int count = std::min(4, node.columns - k);
            // Columns past the last repeat it; their sums are not used.
            const double* const column0 = panel + k * stride;
            const double* const column1 = panel + std::min(k + 1, node.columns - 1) * stride;
            const double* const column2 = panel + std::min(k + 2, node.columns - 1) * stride;
            const double* const column3 = panel + std::min(k + 3, node.columns - 1) * stride;
            Own sum0;
            Own sum1;
            Own sum2;
            Own sum3;
            for (int r = node.columns; r < node.rows; ++r) {
                const Own value = *Own::at(gathered, r);
                sum0.add(value, column0[r]);
                sum1.add(value, column1[r]);
                sum2.add(value, column2[r]);
                sum3.add(value, column3[r]);
            }
            Own::at(x, node.first + k)->subtract(sum0);
            if (count > 1)
                Own::at(x, node.first + k + 1)->subtract(sum1);
            if (count > 2)
                Own::at(x, node.first + k + 2)->subtract(sum2);
            if (count > 3)
                Own::at(x, node.first + k + 3)->subtract(sum3);
        }
        for (int k = node.columns; k-- > 0;) {
            const double* const column = panel + std::ptrdiff_t{k} * node.stride;
            Own value = *Own::at(x, node.first + k);
            for (int r = k + 1; r < node.columns; ++r)
                value.add(*Own::at(x, node.first + r), -column[r]);
            value.scale(column[k]);
            *Own::at(x, node.first + k) = value;
        }
    }
}

// Clones cannot be templates.
QUADRILLE_SIMD_CLONES void solveFour(const CholeskyPattern& pattern, const double* panels, double* x,
                                     double* gathered)
{
    forward<1>(pattern, panels, x);
    backward<1>(pattern, panels, x, gathered);
}

QUADRILLE_SIMD_CLONES void solveTwelve(const CholeskyPattern& pattern, const double* panels, double* x,
                                       double* gathered)
{
    forward<3>(pattern, panels, x);
    backward<3>(pattern, panels, x, gathered);
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

void CholeskyFactor::solve(std::span<double> x, std::size_t groups) const
{
    std::vector<double> gathered(static_cast<std::size_t>(m_pattern->longestRows()) * lanes * groups);
    (groups == 1 ? solveFour : solveTwelve)(*m_pattern, m_panels.data(), x.data(), gathered.data());
}

} // namespace quadrille
