// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "latentloops.h"
#include "tests/model/plainalgebra.h"

#include <vector>

namespace quadrille::test {

/// CVS eq. 6 without the noise.
inline double plainKernel(const GpdmHyperparameters& p, const Eigen::RowVectorXd& a,
                          const Eigen::RowVectorXd& b)
{
    return p.beta1 * std::exp(-p.beta2 / 2 * (a - b).squaredNorm()) + p.beta3 * a.dot(b);
}

/// The joint conditional as its formulas are printed, by inverses and determinants.
struct PlainDynamics
{
    GpdmHyperparameters p;
    std::vector<Eigen::RowVectorXd> inputs;
    std::vector<Eigen::RowVectorXd> outputs;

    explicit PlainDynamics(const LatentLoops& loops) : p(loops.state.hyperparameters)
    {
        for (const RowSpan& span : loops.spans)
            for (Eigen::Index i = span.first; i < span.last(); ++i) {
                inputs.emplace_back(loops.state.latents.row(i));
                outputs.emplace_back(loops.state.latents.row(i + 1));
            }
    }

    struct Joint
    {
        Eigen::MatrixXd mean;
        Eigen::MatrixXd covariance;
    };

    Joint joint(const RowMatrix& from) const
    {
        const auto n = std::ssize(inputs);
        const Eigen::Index m = from.rows();
        Eigen::MatrixXd K(n, n);
        Eigen::MatrixXd cross(n, m);
        Eigen::MatrixXd own(m, m);
        Eigen::MatrixXd next(n, from.cols());
        for (Eigen::Index i = 0; i < n; ++i) {
            next.row(i) = outputs[static_cast<std::size_t>(i)];
            const Eigen::RowVectorXd& a = inputs[static_cast<std::size_t>(i)];
            for (Eigen::Index j = 0; j < n; ++j)
                K(i, j) = plainKernel(p, a, inputs[static_cast<std::size_t>(j)]) + (i == j) / p.beta4;
            for (Eigen::Index j = 0; j < m; ++j)
                cross(i, j) = plainKernel(p, a, from.row(j));
        }
        for (Eigen::Index i = 0; i < m; ++i)
            for (Eigen::Index j = 0; j < m; ++j)
                own(i, j) = plainKernel(p, from.row(i), from.row(j)) + (i == j) / p.beta4;
        const Eigen::MatrixXd inverse = inverseOf(K);
        return {cross.transpose() * inverse * next, own - cross.transpose() * inverse * cross};
    }

    double energy(const RowMatrix& trajectory) const
    {
        const Eigen::Index m = trajectory.rows() - 1;
        const auto [mean, covariance] = joint(trajectory.topRows(m));
        const Eigen::MatrixXd residuals = trajectory.bottomRows(m) - mean;
        return 0.5 * static_cast<double>(trajectory.cols()) * std::log(determinantOf(covariance)) +
               0.5 * (residuals.transpose() * inverseOf(covariance) * residuals).trace();
    }
};

} // namespace quadrille::test
