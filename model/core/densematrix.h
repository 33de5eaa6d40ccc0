// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <tbb/cache_aligned_allocator.h>
#include <vector>

namespace quadrille {

/// A matrix for the kernels of densekernels.h: row after row, double precision, both sizes filled up to
/// multiples of eight so that kernels need no remainders. What fills it up is zero unless a kernel says
/// otherwise, and is no part of view().
class DenseMatrix
{
public:
    using Plain = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    using View = Eigen::Map<Plain, 0, Eigen::OuterStride<>>;
    using ConstView = Eigen::Map<const Plain, 0, Eigen::OuterStride<>>;

    DenseMatrix() = default;
    /// Zero everywhere.
    DenseMatrix(Eigen::Index rows, Eigen::Index columns)
        : m_rows(rows)
        , m_columns(columns)
        , m_stride(strideOf(filled(columns)))
        , m_values(static_cast<std::size_t>(filled(rows) * m_stride))
    {
    }
    explicit DenseMatrix(const Eigen::Ref<const Plain>& values) : DenseMatrix(values.rows(), values.cols())
    {
        view() = values;
    }

    Eigen::Index rows() const { return m_rows; }
    Eigen::Index columns() const { return m_columns; }
    Eigen::Index filledRows() const { return filled(m_rows); }
    Eigen::Index filledColumns() const { return filled(m_columns); }
    /// From one row to the next, in numbers.
    std::ptrdiff_t stride() const { return m_stride; }
    double* row(Eigen::Index index) { return m_values.data() + index * m_stride; }
    const double* row(Eigen::Index index) const { return m_values.data() + index * m_stride; }
    double& operator()(Eigen::Index row, Eigen::Index column)
    {
        return m_values[static_cast<std::size_t>(row * m_stride + column)];
    }
    double operator()(Eigen::Index row, Eigen::Index column) const
    {
        return m_values[static_cast<std::size_t>(row * m_stride + column)];
    }
    View view() { return {m_values.data(), m_rows, m_columns, Eigen::OuterStride<>(m_stride)}; }
    ConstView view() const { return {m_values.data(), m_rows, m_columns, Eigen::OuterStride<>(m_stride)}; }

    static constexpr Eigen::Index filled(Eigen::Index size) { return (size + 7) / 8 * 8; }

private:
    /// An odd number of cache lines, so that a column does not fall into few sets of the cache.
    static constexpr std::ptrdiff_t strideOf(Eigen::Index columns) { return (columns / 8 | 1) * 8; }

    Eigen::Index m_rows = 0;
    Eigen::Index m_columns = 0;
    std::ptrdiff_t m_stride = 8;
    std::vector<double, tbb::cache_aligned_allocator<double>> m_values;
};

} // namespace quadrille
