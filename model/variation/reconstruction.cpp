// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/densekernels.h"
#include "model/core/random.h"
#include "model/variation/gpdm/covariancefactor.h"
#include "model/variation/sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// CVS eq. 4 without the noise, between the rows of two matrices.
DenseMatrix poseKernel(const RowMatrix& a, const RowMatrix& b, const GpdmHyperparameters& p)
{
    DenseMatrix kernel(a.rows(), b.rows());
    const Eigen::VectorXd squaresA = a.rowwise().squaredNorm();
    const Eigen::RowVectorXd squaresB = b.rowwise().squaredNorm();
    DenseMatrix::View view = kernel.view();
    view.noalias() = a * b.transpose();
    view = (-0.5 * p.alpha2) * ((-2 * view).colwise() + squaresA).rowwise().operator+(squaresB).cwiseMax(0.0);
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        exponentials({kernel.row(i), static_cast<std::size_t>(b.rows())});
    view *= p.alpha1;
    return kernel;
}

} // namespace

PoseReconstruction::PoseReconstruction(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows,
                                       Eigen::RowVectorXd mean)
    : m_hyperparameters(state.hyperparameters)
    , m_latents(state.latents)
    , m_mean(std::move(mean))
    , m_rows(rows)
{
    assert(rows.rows() == state.latents.rows() && rows.cols() == m_mean.size());
    DenseMatrix covariance = poseKernel(m_latents, m_latents, m_hyperparameters);
    covariance.view().diagonal().array() += 1 / m_hyperparameters.alpha3;
    m_factor = covarianceFactor(covariance, m_hyperparameters.alpha1);
    const double squares = rows.squaredNorm();
    m_spanScale = squares > 0 ? std::sqrt(static_cast<double>(rows.cols()) / squares) : 0;
}

PoseReconstruction::Prediction PoseReconstruction::predict(const RowMatrix& latents) const
{
    Prediction prediction;
    DenseMatrix solved = poseKernel(m_latents, latents, m_hyperparameters);
    solveLower(m_factor, solved);
    prediction.whitened = solved;
    solveLowerTransposed(m_factor, solved);
    prediction.coefficients = solved.view().transpose();
    return prediction;
}

void PoseReconstruction::mean(const Eigen::Ref<const Eigen::RowVectorXd>& latent, std::span<double> out) const
{
    assert(std::ssize(out) == coordinates());
    m_rows.combine(predict(latent).coefficients, m_mean, out.data());
}

double PoseReconstruction::variance(const Eigen::Ref<const Eigen::RowVectorXd>& latent) const
{
    return combination(latent).variances[0];
}

PoseCombination PoseReconstruction::combination(const RowMatrix& trajectory) const
{
    Prediction prediction = predict(trajectory);
    const Eigen::VectorXd explained = prediction.whitened.view().colwise().squaredNorm();
    return {.coefficients = std::move(prediction.coefficients),
            .variances = (m_hyperparameters.alpha1 - explained.array()).cwiseMax(0.0)};
}

RowMatrix PoseReconstruction::means(const RowMatrix& trajectory) const
{
    RowMatrix poses(trajectory.rows(), coordinates());
    m_rows.combine(predict(trajectory).coefficients, m_mean, poses.data());
    return poses;
}

RowMatrix PoseReconstruction::draw(const RowMatrix& trajectory, std::uint64_t seed,
                                   PoseDeviation deviation) const
{
    const Eigen::Index frames = trajectory.rows();
    Prediction prediction = predict(trajectory);
    DenseMatrix covariance = poseKernel(trajectory, trajectory, m_hyperparameters);
    covariance.view().noalias() -= prediction.whitened.view().transpose() * prediction.whitened.view();
    const DenseMatrix factor = covarianceFactor(covariance, m_hyperparameters.alpha1);
    const bool inSpan = deviation == PoseDeviation::TrainingSpan;
    Random random(seed);
    RowMatrix normals(frames, inSpan ? m_latents.rows() : coordinates());
    for (double& value : normals.reshaped<Eigen::RowMajor>())
        value = random.normal();
    const RowMatrix deviations = factor.view().triangularView<Eigen::Lower>() * normals;
    RowMatrix poses(frames, coordinates());
    if (inSpan)
        prediction.coefficients += m_spanScale * deviations;
    m_rows.combine(prediction.coefficients, m_mean, poses.data());
    if (!inSpan)
        poses += deviations;
    return poses;
}

} // namespace quadrille
