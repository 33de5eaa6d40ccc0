// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/rowpanels.h"

#include "model/variation/gpdm/posekernel.h"

#include <algorithm>

namespace quadrille {

RowPanels::RowPanels(const Eigen::Ref<const RowMatrix>& rows)
    : m_rows(rows.rows())
    , m_columns(rows.cols())
    , m_values(static_cast<std::size_t>((rows.cols() + width - 1) / width * width * rows.rows()))
{
    for (Eigen::Index first = 0; first < m_columns; first += width) {
        const Eigen::Index count = std::min(width, m_columns - first);
        float* panel = m_values.data() + first * m_rows;
        for (Eigen::Index row = 0; row < m_rows; ++row)
            for (Eigen::Index c = 0; c < count; ++c)
                panel[row * width + c] = static_cast<float>(rows(row, first + c));
    }
}

void RowPanels::combine(const RowMatrix& coefficients, const Eigen::RowVectorXd& offset, double* out) const
{
    constexpr Eigen::Index group = 4;
    const Eigen::Index sums = coefficients.rows();
    const Eigen::Index groups = (sums + group - 1) / group;
    std::vector<float> grouped(static_cast<std::size_t>(groups * group * m_rows));
    for (Eigen::Index s = 0; s < sums; ++s)
        for (Eigen::Index row = 0; row < m_rows; ++row)
            grouped[static_cast<std::size_t>((s / group * m_rows + row) * group + s % group)] =
                static_cast<float>(coefficients(s, row));
    for (Eigen::Index first = 0; first < m_columns; first += width) {
        const Eigen::Index count = std::min(width, m_columns - first);
        for (Eigen::Index g = 0; g < groups; ++g) {
            float values[group * width];
            combinePanel(m_values.data() + first * m_rows, grouped.data() + g * group * m_rows, m_rows,
                         values);
            for (Eigen::Index s = g * group; s < std::min(sums, (g + 1) * group); ++s)
                for (Eigen::Index c = 0; c < count; ++c)
                    out[s * m_columns + first + c] =
                        offset[first + c] + double{values[(s - g * group) * width + c]};
        }
    }
}

} // namespace quadrille
