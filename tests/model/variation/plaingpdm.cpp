// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/variation/plaingpdm.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace quadrille::test {

namespace {

RowMatrix squaredDistances(const RowMatrix& points)
{
    const Eigen::VectorXd squares = points.rowwise().squaredNorm();
    RowMatrix distances = -2 * points * points.transpose();
    distances.colwise() += squares;
    distances.rowwise() += squares.transpose();
    return distances.cwiseMax(0);
}

double logDeterminantOf(const Eigen::LLT<RowMatrix>& factor)
{
    return 2 * RowMatrix(factor.matrixL()).diagonal().array().log().sum();
}

/// Rows that start a sequence, rows that another one follows, rows that follow.
struct Rows
{
    std::vector<Eigen::Index> firsts;
    std::vector<Eigen::Index> inputs;
    std::vector<Eigen::Index> outputs;
};

Rows rowsOf(std::span<const RowSpan> spans)
{
    Rows rows;
    for (const RowSpan& span : spans) {
        rows.firsts.push_back(span.first);
        for (Eigen::Index i = span.first; i < span.last(); ++i) {
            rows.inputs.push_back(i);
            rows.outputs.push_back(i + 1);
        }
    }
    return rows;
}

/// Adds 2·Σ_j W_ij·∂k_ij/∂x_i for k = scale·exp(−½·precision·r²), whose values are given.
void addRadial(const RowMatrix& points, const RowMatrix& weighted, double precision,
               const std::vector<Eigen::Index>& places, RowMatrix& gradient)
{
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::RowVectorXd sum = weighted.row(i).sum() * points.row(i) - weighted.row(i) * points;
        gradient.row(places[static_cast<std::size_t>(i)]) -= 2 * precision * sum;
    }
}

} // namespace

RowMatrix plainPoseKernel(const RowMatrix& latents, const GpdmHyperparameters& parameters)
{
    RowMatrix kernel =
        parameters.alpha1 * (-0.5 * parameters.alpha2 * squaredDistances(latents)).array().exp();
    kernel.diagonal().array() += 1 / parameters.alpha3;
    return kernel;
}

RowMatrix plainDynamicsKernel(const RowMatrix& inputs, const GpdmHyperparameters& parameters)
{
    RowMatrix kernel = parameters.beta1 * (-0.5 * parameters.beta2 * squaredDistances(inputs)).array().exp();
    kernel += parameters.beta3 * inputs * inputs.transpose();
    kernel.diagonal().array() += 1 / parameters.beta4;
    return kernel;
}

double plainObjective(const RowMatrix& rows, std::span<const RowSpan> spans, const GpdmState& state,
                      GpdmObjective::Gradient* gradient)
{
    const GpdmHyperparameters& h = state.hyperparameters;
    const Rows which = rowsOf(spans);
    const RowMatrix& latents = state.latents;
    const RowMatrix inputs = latents(which.inputs, Eigen::all);
    const RowMatrix outputs = latents(which.outputs, Eigen::all);
    const RowMatrix poseKernel = plainPoseKernel(latents, h);
    const RowMatrix dynamicsKernel = plainDynamicsKernel(inputs, h);
    const Eigen::LLT<RowMatrix> poses(poseKernel);
    const Eigen::LLT<RowMatrix> dynamics(dynamicsKernel);
    const RowMatrix poseWeights = poses.solve(rows);
    const RowMatrix dynamicsWeights = dynamics.solve(outputs);
    const auto coordinates = static_cast<double>(rows.cols());
    const auto dimensions = static_cast<double>(latents.cols());
    double value = 0.5 * coordinates * logDeterminantOf(poses) + 0.5 * poseWeights.cwiseProduct(rows).sum() +
                   0.5 * dimensions * logDeterminantOf(dynamics) +
                   0.5 * dynamicsWeights.cwiseProduct(outputs).sum();
    value += 0.5 * latents(which.firsts, Eigen::all).squaredNorm();
    for (const double parameter : {h.alpha1, h.alpha2, h.alpha3, h.beta1, h.beta2, h.beta3, h.beta4})
        value += std::log(parameter);
    if (gradient == nullptr)
        return value;

    const Eigen::Index count = latents.rows();
    const Eigen::Index pairs = inputs.rows();
    const RowMatrix byPose = 0.5 * (coordinates * poses.solve(RowMatrix::Identity(count, count)) -
                                    poseWeights * poseWeights.transpose());
    const RowMatrix byDynamics = 0.5 * (dimensions * dynamics.solve(RowMatrix::Identity(pairs, pairs)) -
                                        dynamicsWeights * dynamicsWeights.transpose());
    RowMatrix poseRadial = poseKernel;
    poseRadial.diagonal().array() -= 1 / h.alpha3;
    RowMatrix dynamicsRadial = dynamicsKernel - h.beta3 * inputs * inputs.transpose();
    dynamicsRadial.diagonal().array() -= 1 / h.beta4;
    const RowMatrix poseProduct = byPose.cwiseProduct(poseRadial);
    const RowMatrix dynamicsProduct = byDynamics.cwiseProduct(dynamicsRadial);

    std::vector<Eigen::Index> all;
    for (Eigen::Index i = 0; i < count; ++i)
        all.push_back(i);
    RowMatrix& x = gradient->latents;
    x.setZero(count, latents.cols());
    addRadial(latents, poseProduct, h.alpha2, all, x);
    addRadial(inputs, dynamicsProduct, h.beta2, which.inputs, x);
    const RowMatrix linear = 2 * h.beta3 * byDynamics * inputs;
    for (Eigen::Index i = 0; i < pairs; ++i) {
        x.row(which.inputs[static_cast<std::size_t>(i)]) += linear.row(i);
        x.row(which.outputs[static_cast<std::size_t>(i)]) += dynamicsWeights.row(i);
    }
    for (const Eigen::Index first : which.firsts)
        x.row(first) += latents.row(first);
    GpdmHyperparameters& g = gradient->hyperparameters;
    g.alpha1 = poseProduct.sum() / h.alpha1 + 1 / h.alpha1;
    g.alpha2 = -0.5 * poseProduct.cwiseProduct(squaredDistances(latents)).sum() + 1 / h.alpha2;
    g.alpha3 = -byPose.trace() / (h.alpha3 * h.alpha3) + 1 / h.alpha3;
    g.beta1 = dynamicsProduct.sum() / h.beta1 + 1 / h.beta1;
    g.beta2 = -0.5 * dynamicsProduct.cwiseProduct(squaredDistances(inputs)).sum() + 1 / h.beta2;
    g.beta3 = byDynamics.cwiseProduct(inputs * inputs.transpose()).sum() + 1 / h.beta3;
    g.beta4 = -byDynamics.trace() / (h.beta4 * h.beta4) + 1 / h.beta4;
    return value;
}

} // namespace quadrille::test
