// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/covariancefactor.h"
#include "model/variation/sampling.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// The radial part of CVS eq. 6 between the rows of two matrices.
RowMatrix radial(const RowMatrix& a, const RowMatrix& b, const GpdmHyperparameters& p)
{
    RowMatrix kernel = a * b.transpose();
    const Eigen::VectorXd squaresA = a.rowwise().squaredNorm();
    const Eigen::VectorXd squaresB = b.rowwise().squaredNorm();
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        for (Eigen::Index j = 0; j < b.rows(); ++j)
            kernel(i, j) = p.beta1 * std::exp(-0.5 * p.beta2 *
                                              std::max(0.0, squaresA[i] + squaresB[j] - 2 * kernel(i, j)));
    return kernel;
}

/// Both parts without the noise.
RowMatrix withLinear(const RowMatrix& radialPart, const RowMatrix& a, const RowMatrix& b,
                     const GpdmHyperparameters& p)
{
    return radialPart + p.beta3 * a * b.transpose();
}

/// Adds Σ_i H(i, j) · ∂k(a_i, b_j)/∂b_j for each j.
void addKernelGradient(const RowMatrix& h, const RowMatrix& radialPart, const RowMatrix& a,
                       const RowMatrix& b, const GpdmHyperparameters& p, Eigen::Ref<RowMatrix> gradient)
{
    const RowMatrix pull = p.beta2 * h.cwiseProduct(radialPart);
    gradient += (pull + p.beta3 * h).transpose() * a;
    gradient -= pull.colwise().sum().asDiagonal() * b;
}

/// All but the last row of each sequence, and all but the first.
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

} // namespace

GpdmDynamics::GpdmDynamics(const GpdmState& state, std::span<const RowSpan> spans)
    : m_hyperparameters(state.hyperparameters), m_inputs(rowsFrom(state.latents, spans, 0))
{
    RowMatrix covariance =
        withLinear(radial(m_inputs, m_inputs, m_hyperparameters), m_inputs, m_inputs, m_hyperparameters);
    covariance.diagonal().array() += 1 / m_hyperparameters.beta4;
    m_factor = covarianceFactor(covariance);
    m_weights = rowsFrom(state.latents, spans, 1);
    m_factor.triangularView<Eigen::Lower>().solveInPlace(m_weights);
    m_factor.triangularView<Eigen::Lower>().transpose().solveInPlace(m_weights);
}

/// What training says about the steps that start at some positions.
struct GpdmDynamics::Steps
{
    RowMatrix radialCross; ///< inputs × steps
    RowMatrix radialOwn;   ///< steps × steps
    RowMatrix cross;       ///< K*, inputs × steps
    RowMatrix solved;      ///< L⁻¹·K*
    RowMatrix means;       ///< steps × dimensions
    RowMatrix covariance;  ///< of the steps, with the noise
};

GpdmDynamics::Steps GpdmDynamics::steps(const RowMatrix& from) const
{
    const GpdmHyperparameters& p = m_hyperparameters;
    Steps s;
    s.radialCross = radial(m_inputs, from, p);
    s.radialOwn = radial(from, from, p);
    s.cross = withLinear(s.radialCross, m_inputs, from, p);
    s.solved = s.cross;
    m_factor.triangularView<Eigen::Lower>().solveInPlace(s.solved);
    s.means = s.cross.transpose() * m_weights;
    s.covariance = withLinear(s.radialOwn, from, from, p) - s.solved.transpose() * s.solved;
    s.covariance.diagonal().array() += 1 / p.beta4;
    return s;
}

Eigen::RowVectorXd GpdmDynamics::next(const Eigen::RowVectorXd& latent) const
{
    const RowMatrix from = latent;
    return withLinear(radial(m_inputs, from, m_hyperparameters), m_inputs, from, m_hyperparameters)
               .transpose() *
           m_weights;
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

double GpdmDynamics::energy(const RowMatrix& trajectory, RowMatrix* gradient) const
{
    const Eigen::Index count = std::max<Eigen::Index>(trajectory.rows() - 1, 0);
    if (gradient)
        gradient->setZero(trajectory.rows(), trajectory.cols());
    if (count == 0)
        return 0;
    const GpdmHyperparameters& p = m_hyperparameters;
    const RowMatrix from = trajectory.topRows(count);
    const Steps s = steps(from);
    const Eigen::LLT<RowMatrix> factor(s.covariance);
    if (factor.info() != Eigen::Success)
        return std::numeric_limits<double>::infinity();
    const auto dimensions = static_cast<double>(trajectory.cols());
    const RowMatrix residuals = trajectory.bottomRows(count) - s.means;
    const RowMatrix pull = factor.solve(residuals);
    const double value = dimensions * factor.matrixLLT().diagonal().array().log().sum() +
                         0.5 * residuals.cwiseProduct(pull).sum();
    if (!gradient)
        return value;
    // E = d/2·log|C| + ½·tr(RᵀC⁻¹R), R = X̃′ − K*ᵀW, C = K** − K*ᵀK⁻¹K*
    const RowMatrix byCovariance =
        0.5 * (dimensions * factor.solve(RowMatrix::Identity(count, count)) - pull * pull.transpose());
    RowMatrix solvedTwice = s.solved;
    m_factor.triangularView<Eigen::Lower>().transpose().solveInPlace(solvedTwice);
    const RowMatrix byCross = -m_weights * pull.transpose() - 2 * solvedTwice * byCovariance;
    gradient->bottomRows(count) = pull;
    addKernelGradient(byCross, s.radialCross, m_inputs, from, p, gradient->topRows(count));
    addKernelGradient(2 * byCovariance, s.radialOwn, from, from, p, gradient->topRows(count));
    gradient->row(0).setZero();
    return value;
}

RowMatrix GpdmDynamics::curvature(const RowMatrix& trajectory) const
{
    const Eigen::Index count = std::max<Eigen::Index>(trajectory.rows() - 1, 0);
    const Eigen::Index d = trajectory.cols();
    const GpdmHyperparameters& p = m_hyperparameters;
    const RowMatrix from = trajectory.topRows(count);
    const Steps s = steps(from);
    const RowMatrix factor = covarianceFactor(s.covariance);
    // The residuals' derivatives: 1 by the position a step leads to, −∂mean/∂z by the one it starts from.
    RowMatrix jacobian = RowMatrix::Zero(count * d, count * d);
    for (Eigen::Index step = 0; step < count; ++step) {
        jacobian.block(step * d, step * d, d, d).setIdentity();
        if (step == 0)
            continue;
        // ∂k(x_i, z)/∂z = β₃·x_i − β₂·radial·(z − x_i)
        const Eigen::VectorXd pull = p.beta2 * s.radialCross.col(step);
        const RowMatrix kernel =
            pull.asDiagonal() * (m_inputs.rowwise() - from.row(step)) + p.beta3 * m_inputs;
        jacobian.block(step * d, (step - 1) * d, d, d) = -(m_weights.transpose() * kernel);
    }
    // Whitened: L_C⁻¹ acts on the steps of each dimension alike.
    Eigen::Map<RowMatrix> bySteps(jacobian.data(), count, d * count * d);
    factor.triangularView<Eigen::Lower>().solveInPlace(bySteps);
    return jacobian.transpose() * jacobian;
}

} // namespace quadrille
