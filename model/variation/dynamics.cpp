// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/densekernels.h"
#include "model/variation/gpdm/covariancefactor.h"
#include "model/variation/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// All but the last row of each sequence, or all but the first.
/// \param offset  0 or 1.
RowMatrix rowsFrom(const RowMatrix& latents, std::span<const RowSpan> spans, Eigen::Index offset)
{
    Eigen::Index count = 0;
    for (const RowSpan& span : spans)
        count += span.count - 1;
    RowMatrix rows(count, latents.cols());
    Eigen::Index row = 0;
    for (const RowSpan& span : spans) {
        rows.middleRows(row, span.count - 1) = latents.middleRows(span.first + offset, span.count - 1);
        row += span.count - 1;
    }
    return rows;
}

/// CVS eq. 6 without the noise, between the rows of two matrices.
struct DynamicsKernel
{
    DenseMatrix radial;
    DenseMatrix sum; ///< radial and linear

    DynamicsKernel() = default;
    DynamicsKernel(const RowMatrix& a, const RowMatrix& b, const GpdmHyperparameters& p)
        : radial(a.rows(), b.rows()), sum(a.rows(), b.rows())
    {
        DenseMatrix::View products = sum.view();
        DenseMatrix::View exponents = radial.view();
        products.noalias() = a * b.transpose();
        const Eigen::VectorXd squaresA = a.rowwise().squaredNorm();
        const Eigen::RowVectorXd squaresB = b.rowwise().squaredNorm();
        for (Eigen::Index i = 0; i < a.rows(); ++i) {
            exponents.row(i) =
                p.beta2 * (products.row(i) - 0.5 * (squaresB.array() + squaresA[i]).matrix()).cwiseMin(0.0);
            exponentials({radial.row(i), static_cast<std::size_t>(b.rows())});
            exponents.row(i) *= p.beta1;
            products.row(i) = exponents.row(i) + p.beta3 * products.row(i);
        }
    }
};

/// Adds Σ_i H(i, j) · ∂k(a_i, b_j)/∂b_j for each j.
void addKernelGradient(const RowMatrix& h, const DenseMatrix& radial, const RowMatrix& a, const RowMatrix& b,
                       const GpdmHyperparameters& p, Eigen::Ref<RowMatrix> gradient)
{
    const RowMatrix pull = p.beta2 * h.cwiseProduct(radial.view());
    gradient.noalias() += (pull + p.beta3 * h).transpose() * a;
    gradient -= pull.colwise().sum().asDiagonal() * b;
}

} // namespace

GpdmDynamics::GpdmDynamics(const GpdmState& state, std::span<const RowSpan> spans)
    : m_hyperparameters(state.hyperparameters), m_inputs(rowsFrom(state.latents, spans, 0))
{
    const RowMatrix outputs = rowsFrom(state.latents, spans, 1);
    DynamicsKernel kernel(m_inputs, m_inputs, m_hyperparameters);
    kernel.sum.view().diagonal().array() += 1 / m_hyperparameters.beta4;
    m_factor = covarianceFactor(kernel.sum, kernel.sum.view().diagonal().mean());
    DenseMatrix weights(outputs);
    solveLower(m_factor, weights);
    solveLowerTransposed(m_factor, weights);
    m_weights = weights.view();
}

/// What training says about the steps that start at some positions.
struct GpdmDynamics::Steps
{
    DynamicsKernel cross;   ///< inputs × steps
    DynamicsKernel own;     ///< steps × steps
    DenseMatrix solved;     ///< L⁻¹·K*
    RowMatrix means;        ///< steps × dimensions
    DenseMatrix covariance; ///< of the steps, with the noise
};

GpdmDynamics::Steps GpdmDynamics::steps(const RowMatrix& from) const
{
    Steps s{.cross = {m_inputs, from, m_hyperparameters}, .own = {from, from, m_hyperparameters}};
    s.solved = s.cross.sum;
    solveLower(m_factor, s.solved);
    s.means.noalias() = s.cross.sum.view().transpose() * m_weights;
    s.covariance = s.own.sum;
    s.covariance.view().noalias() -= s.solved.view().transpose() * s.solved.view();
    s.covariance.view().diagonal().array() += 1 / m_hyperparameters.beta4;
    return s;
}

Eigen::RowVectorXd GpdmDynamics::next(const Eigen::RowVectorXd& latent) const
{
    return DynamicsKernel(m_inputs, latent, m_hyperparameters).sum.view().transpose() * m_weights;
}

double GpdmDynamics::variance(const Eigen::RowVectorXd& latent) const
{
    return steps(latent).covariance(0, 0);
}

RowMatrix GpdmDynamics::meanPrediction(const Eigen::RowVectorXd& start, Eigen::Index length) const
{
    RowMatrix trajectory(length, start.size());
    for (Eigen::Index i = 0; i < length; ++i)
        trajectory.row(i) = i > 0 ? next(trajectory.row(i - 1)) : start;
    return trajectory;
}

RowMatrix GpdmDynamics::trajectory(const Eigen::RowVectorXd& start, const RowMatrix& innovations) const
{
    const Eigen::Index count = innovations.rows();
    const double noise = 1 / m_hyperparameters.beta4;
    RowMatrix positions(count + 1, start.size());
    positions.row(0) = start;
    RowMatrix solved(count, m_inputs.rows());                     // L⁻¹·k of each position
    Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(count, count); // of the steps' covariance
    for (Eigen::Index t = 0; t < count; ++t) {
        const RowMatrix here = positions.row(t);
        const DynamicsKernel cross(m_inputs, here, m_hyperparameters);
        DenseMatrix own = cross.sum;
        solveLower(m_factor, own);
        solved.row(t) = own.view().transpose();
        const DynamicsKernel steps(positions.topRows(t + 1), here, m_hyperparameters);
        Eigen::VectorXd covariance = steps.sum.view() - solved.topRows(t + 1) * solved.row(t).transpose();
        covariance[t] += noise;
        factor.row(t).head(t) =
            factor.topLeftCorner(t, t).triangularView<Eigen::Lower>().solve(covariance.head(t)).transpose();
        // At least a share of the noise, whatever rounding leaves.
        factor(t, t) = std::sqrt(std::max(covariance[t] - factor.row(t).head(t).squaredNorm(), 1e-9 * noise));
        positions.row(t + 1) =
            cross.sum.view().transpose() * m_weights + factor.row(t).head(t + 1) * innovations.topRows(t + 1);
    }
    return positions;
}

double GpdmDynamics::energy(const RowMatrix& trajectory, RowMatrix* gradient) const
{
    const Eigen::Index count = std::max<Eigen::Index>(trajectory.rows() - 1, 0);
    if (gradient)
        gradient->setZero(trajectory.rows(), trajectory.cols());
    if (count == 0)
        return 0;
    const RowMatrix from = trajectory.topRows(count);
    Steps s = steps(from);
    if (!factoriseCholesky(s.covariance))
        return std::numeric_limits<double>::infinity();
    const auto dimensions = static_cast<double>(trajectory.cols());
    const RowMatrix residuals = trajectory.bottomRows(count) - s.means;
    DenseMatrix pulls(residuals);
    solveLower(s.covariance, pulls);
    const double value = 0.5 * (dimensions * logDeterminant(s.covariance) + pulls.view().squaredNorm());
    if (!gradient)
        return value;
    // E = d/2·log|C| + ½·tr(RᵀC⁻¹R), R = X̃′ − K*ᵀW, C = K** − K*ᵀK⁻¹K*
    solveLowerTransposed(s.covariance, pulls);
    const DenseMatrix::View pull = pulls.view();
    DenseMatrix inverse(RowMatrix::Identity(count, count));
    solveLower(s.covariance, inverse);
    solveLowerTransposed(s.covariance, inverse);
    const RowMatrix byCovariance = dimensions * inverse.view() - pull * pull.transpose(); // twice
    solveLowerTransposed(m_factor, s.solved);
    RowMatrix byCross = -m_weights * pull.transpose();
    byCross.noalias() -= s.solved.view() * byCovariance;
    gradient->bottomRows(count) = pull;
    addKernelGradient(byCross, s.cross.radial, m_inputs, from, m_hyperparameters, gradient->topRows(count));
    addKernelGradient(byCovariance, s.own.radial, from, from, m_hyperparameters, gradient->topRows(count));
    gradient->row(0).setZero();
    return value;
}

} // namespace quadrille
