// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/smoothdeviations.h"

#include "model/core/symmetriceigen.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

/// Waves hold this share of the squares of the learned trajectory …
constexpr double shareOfTrajectory = 0.95;
/// … and are at least so many: the shortest then has a third of the trajectory's length.
constexpr Eigen::Index leastWaves = 6;
/// Of the largest curvature; flatter directions, and those in which the energy falls, count as so curved.
constexpr double leastCurvature = 1e-4;

/// Where each of so many frames is between the first one and the last, 0 … frames − 1.
std::vector<double> placesIn(const std::vector<double>& times, Eigen::Index frames)
{
    std::vector<double> places;
    const double last = static_cast<double>(frames) - 1;
    for (Eigen::Index f = 0; f < frames; ++f) {
        const auto i = static_cast<std::size_t>(f);
        places.push_back(times.empty() ? static_cast<double>(f)
                                       : last * (times[i] - times.front()) / (times.back() - times.front()));
    }
    return places;
}

/// Waves as columns, as many as can be told apart, orthonormal in their order.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& waves)
{
    constexpr double leastOwn = 1e-6; // of a wave's length that those before leave
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(waves);
    Eigen::Index own = 0;
    while (own < waves.cols() && std::abs(qr.matrixQR()(own, own)) > leastOwn)
        ++own;
    Eigen::MatrixXd result = qr.householderQ() * Eigen::MatrixXd::Identity(waves.rows(), own);
    result.row(0).setZero(); // but for rounding it is
    return result;
}

/// The longest first: a quarter of a period, then odd multiples of it. \return frames × waves.
Eigen::MatrixXd openWaves(const std::vector<double>& places)
{
    const std::ptrdiff_t frames = std::ssize(places);
    Eigen::MatrixXd waves(frames, frames - 1);
    const double span = static_cast<double>(frames) - 0.5;
    for (Eigen::Index f = 0; f < frames; ++f) {
        for (Eigen::Index w = 0; w < waves.cols(); ++w)
            waves(f, w) = std::sqrt(2 / span) * std::sin((static_cast<double>(w) + 0.5) * std::numbers::pi *
                                                         places[static_cast<std::size_t>(f)] / span);
    }
    return orthonormal(waves);
}

/// Of a cycle, which its first frame follows again: whole periods, sines and cosines less one in turn.
/// \return frames × waves.
Eigen::MatrixXd closedWaves(const std::vector<double>& places)
{
    const std::ptrdiff_t frames = std::ssize(places);
    Eigen::MatrixXd waves(frames, frames - 1);
    const double scale = std::sqrt(2 / static_cast<double>(frames));
    for (Eigen::Index f = 0; f < frames; ++f) {
        for (Eigen::Index w = 0; w < waves.cols(); ++w) {
            const Eigen::Index periods = w / 2 + 1;
            const double phase = 2 * std::numbers::pi * static_cast<double>(periods) *
                                 places[static_cast<std::size_t>(f)] / static_cast<double>(frames);
            waves(f, w) = scale * (w % 2 == 0 ? std::sin(phase) : 1 - std::cos(phase));
        }
    }
    return orthonormal(waves);
}

/// Second derivatives of an energy by central differences of its gradient, made positive definite: their
/// sizes count, and the flattest are raised. Cost: two energies for each coordinate.
Eigen::MatrixXd curvatureOf(const HmcEnergy& energy, const Eigen::VectorXd& at, double step)
{
    const Eigen::Index size = at.size();
    Eigen::MatrixXd second(size, size);
    Eigen::VectorXd above;
    Eigen::VectorXd below;
    for (Eigen::Index i = 0; i < size; ++i) {
        energy(at + step * Eigen::VectorXd::Unit(size, i), above);
        energy(at - step * Eigen::VectorXd::Unit(size, i), below);
        second.col(i) = (above - below) / (2 * step);
    }
    if (!second.allFinite())
        return Eigen::MatrixXd::Identity(size, size);
    const SymmetricEigen solved = symmetricEigen(0.5 * (second + second.transpose()));
    const Eigen::VectorXd sizes = solved.values.cwiseAbs();
    if (sizes.maxCoeff() <= 0)
        return Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd raised = sizes.cwiseMax(leastCurvature * sizes.maxCoeff());
    return solved.vectors * raised.asDiagonal() * solved.vectors.transpose();
}

} // namespace

SmoothDeviations::SmoothDeviations(const GpdmDynamics& dynamics, const LearnedTrajectory& trajectory)
    : m_dynamics(dynamics), m_trajectory(trajectory.positions)
{
    const std::vector<double> places = placesIn(trajectory.times, m_trajectory.rows());
    const Eigen::MatrixXd all = trajectory.closes ? closedWaves(places) : openWaves(places);
    const RowMatrix own = all.transpose() * (m_trajectory.rowwise() - m_trajectory.row(0));
    const double squares = own.squaredNorm();
    Eigen::Index count = std::min(leastWaves, all.cols());
    while (count < all.cols() && own.topRows(count).squaredNorm() < shareOfTrajectory * squares)
        ++count;
    m_waves = all.leftCols(count);
    m_size = std::sqrt(squares);
}

RowMatrix SmoothDeviations::deviation(const Eigen::VectorXd& amplitudes) const
{
    return m_waves * Eigen::Map<const RowMatrix>(amplitudes.data(), m_waves.cols(), m_trajectory.cols());
}

double SmoothDeviations::energy(const Eigen::VectorXd& amplitudes, Eigen::VectorXd& gradient) const
{
    RowMatrix byPositions;
    const double energy = m_dynamics.energy(m_trajectory + deviation(amplitudes), &byPositions);
    const RowMatrix byAmplitudes = m_waves.transpose() * byPositions;
    gradient = byAmplitudes.reshaped<Eigen::RowMajor>();
    return energy;
}

Eigen::MatrixXd SmoothDeviations::curvature() const
{
    // Far below the length scales of the kernel, far above rounding.
    const double step = m_size > 0 ? 1e-4 * m_size : 1e-6;
    return curvatureOf([this](const Eigen::VectorXd& amplitudes,
                              Eigen::VectorXd& gradient) { return energy(amplitudes, gradient); },
                       Eigen::VectorXd::Zero(size()), step);
}

} // namespace quadrille
