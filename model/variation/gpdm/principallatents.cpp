// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/symmetriceigen.h"
#include "model/variation/gpdm/gpdm.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

RowMatrix gramMatrix(const Eigen::Ref<const RowMatrix>& rows, const Progress& progress)
{
    constexpr Eigen::Index slice = 256;
    RowMatrix gram = RowMatrix::Zero(rows.rows(), rows.rows());
    for (Eigen::Index first = 0; first < rows.cols(); first += slice) {
        progress.report(first, rows.cols());
        const auto columns = rows.middleCols(first, std::min(slice, rows.cols() - first));
        gram.selfadjointView<Eigen::Lower>().rankUpdate(columns);
    }
    gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
    return gram;
}

RowMatrix principalLatents(const RowMatrix& gram, int dimensions)
{
    const Eigen::Index frames = gram.rows();
    const SymmetricEigen solved = symmetricEigen(gram);
    const double greatest = solved.values(frames - 1);
    RowMatrix latents = RowMatrix::Zero(frames, dimensions);
    if (!(greatest > 0))
        return latents;
    const Eigen::Index count = std::min<Eigen::Index>(dimensions, frames);
    for (Eigen::Index c = 0; c < count; ++c) {
        const double share = std::max(solved.values(frames - 1 - c), 0.0) / greatest;
        const auto vector = solved.vectors.col(frames - 1 - c);
        Eigen::Index largest = 0;
        vector.cwiseAbs().maxCoeff(&largest);
        latents.col(c) =
            vector * std::copysign(std::sqrt(share * static_cast<double>(frames)), vector(largest));
    }
    return latents;
}

} // namespace quadrille
