// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/executor.h"

#include <Eigen/Core>
#include <cstdint>
#include <span>

namespace quadrille {

/// How a regression counts what it was given.
struct RegressionScale
{
    double length = 1; ///< of the kernel exp(−d² / 2 length²), in the unit of distances
    /// How much of the values' variance places explain, in variances of what they do not; 0: nothing, all
    /// values are the mean.
    double trust = 0;

    bool operator==(const RegressionScale&) const = default;
};

/// Values at places, from values at others that are known only by how far they are away: the mean of a
/// Gaussian process about the mean of the known values, which it comes back to where none of them is near.
/// It is smooth: as places move, so do values. Source: Rasmussen & Williams, Gaussian Processes for Machine
/// Learning, 2006, eq. 2.25.
class KernelRegression
{
public:
    /// \param squaredDistances  n × n, symmetric, of places in a Euclidean space. \param values  n × m.
    /// \pre n ≥ 1, length > 0, trust ≥ 0. Cost: O(n³).
    KernelRegression(const Eigen::MatrixXd& squaredDistances, const Eigen::MatrixXd& values,
                     const RegressionScale& scale);

    /// \param squaredDistances  of a place from the n known ones. Cost: O(n · m).
    Eigen::VectorXd at(const Eigen::VectorXd& squaredDistances) const;

private:
    RegressionScale m_scale;
    Eigen::VectorXd m_mean;
    Eigen::MatrixXd m_weights; ///< m × n
};

/// The scale by which values are predicted best that are left out, one group after the other; the plain mean
/// where nothing predicts them better. Where there is only one group, quarters of it are left out; where
/// there are many, several at once.
/// \param squaredDistances,values  as above. \param groups  of each row, from 0 on, in ascending order.
/// \return the same for any number of threads. \throws Error Cancelled.
/// Cost: O(n³) for each of some 170 scales and at most 8 groups: 2 s on two cores for 400 rows of 3 groups.
RegressionScale foundScale(const Eigen::MatrixXd& squaredDistances, const Eigen::MatrixXd& values,
                           std::span<const std::int64_t> groups, const Progress& progress = {},
                           const Executor& executor = localExecutor());

} // namespace quadrille
