// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm/gpdm.h"

#include <tbb/cache_aligned_allocator.h>
#include <vector>

namespace quadrille {

/// The rows of a matrix in single precision, in panels of 16 columns that lie together, for sums of rows.
class RowPanels
{
public:
    static constexpr Eigen::Index width = 16;

    explicit RowPanels(const Eigen::Ref<const RowMatrix>& rows);

    Eigen::Index rows() const { return m_rows; }
    Eigen::Index columns() const { return m_columns; }

    /// Coefficients · rows + offset, the columns of every sum.
    /// \param coefficients  sums × rows. \param out  sums × columns, row after row.
    void combine(const RowMatrix& coefficients, const Eigen::RowVectorXd& offset, double* out) const;

private:
    Eigen::Index m_rows;
    Eigen::Index m_columns;
    std::vector<float, tbb::cache_aligned_allocator<float>> m_values; ///< panels × rows × width
};

} // namespace quadrille
