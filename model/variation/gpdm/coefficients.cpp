// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/coefficients.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

RowMatrix blockValues(const Eigen::Ref<const RowMatrix>& poseVectors, const BlockColumns& block)
{
    assert(block.scale > 0 && block.first + block.count <= poseVectors.cols());
    return poseVectors.middleCols(block.first, block.count) / block.scale;
}

RowMatrix valuesAt(const RowMatrix& values, std::span<const double> positions)
{
    assert(values.rows() > 0);
    RowMatrix found(static_cast<Eigen::Index>(positions.size()), values.cols());
    for (Eigen::Index row = 0; row < found.rows(); ++row) {
        const double position =
            std::clamp(positions[static_cast<std::size_t>(row)], 0.0, static_cast<double>(values.rows() - 1));
        const auto before = static_cast<Eigen::Index>(position);
        const Eigen::Index after = std::min(before + 1, values.rows() - 1);
        const double share = position - static_cast<double>(before);
        found.row(row) = (1 - share) * values.row(before) + share * values.row(after);
    }
    return found;
}

} // namespace quadrille
