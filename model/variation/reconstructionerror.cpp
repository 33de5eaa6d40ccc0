// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/reconstructionerror.h"

#include "model/core/symmetriceigen.h"
#include "model/variation/sampling.h"

#include <algorithm>

namespace quadrille {

namespace {

double meanVertexDistance(const Eigen::Ref<const RowMatrix>& a, const Eigen::Ref<const RowMatrix>& b,
                          Eigen::Index vertices)
{
    if (a.rows() == 0 || vertices == 0)
        return 0;
    double sum = 0;
    for (Eigen::Index f = 0; f < a.rows(); ++f)
        for (Eigen::Index v = 0; v < vertices; ++v)
            sum += (a.block<1, 3>(f, 3 * v) - b.block<1, 3>(f, 3 * v)).norm();
    return sum / static_cast<double>(a.rows() * vertices);
}

} // namespace

double modelError(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows, Eigen::Index vertices)
{
    const PoseReconstruction reconstruction(state, rows, Eigen::RowVectorXd::Zero(rows.cols()));
    return meanVertexDistance(reconstruction.means(state.latents), rows, vertices);
}

double principalError(const Eigen::Ref<const RowMatrix>& rows, int dimensions, Eigen::Index vertices)
{
    const Eigen::MatrixXd gram = rows * rows.transpose();
    const SymmetricEigen solved = symmetricEigen(gram);
    const Eigen::Index count = std::min<Eigen::Index>(dimensions, rows.rows());
    const Eigen::MatrixXd components = solved.vectors.rightCols(count);
    const RowMatrix rebuilt = components * (components.transpose() * rows);
    return meanVertexDistance(rebuilt, rows, vertices);
}

} // namespace quadrille
