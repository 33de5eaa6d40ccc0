// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace quadrille {

struct HmcSettings
{
    int leapfrogSteps = 8; ///< at most; each trajectory has a random number of them, against periods
    int burnIn = 100;      ///< trajectories before the first sample is taken, while the step size is tuned
    int thinning = 3;      ///< trajectories from one sample to the next; more where samples would depend
    double leastAcceptance = 0.6;
    double greatestAcceptance = 0.9;

    bool operator==(const HmcSettings&) const = default;
};

/// How well a chain ran.
struct HmcReport
{
    double acceptance = 0; ///< share of proposals after burn-in
    double stepSize = 0;
    int thinning = 0;             ///< that was used in the end
    std::vector<double> energies; ///< of each state after burn-in
    /// Of the chain after burn-in, from autocorrelations; the least of all coordinates. Less than the samples
    /// asked for where even the longest chain did not reach it.
    double effectiveSampleSize = 0;
    double lag1 = 0; ///< autocorrelation of the energies from one state to the next
};

/// Negative log of a density, without constants, and its gradient; infinite where the density is none.
using HmcEnergy = std::function<double(const Eigen::VectorXd& position, Eigen::VectorXd& gradient)>;

/// What a chain delivers whose positions are coordinates in which its density is simpler: samples, energies
/// and effective sizes are those of what it delivers.
struct HmcDelivery
{
    std::function<Eigen::VectorXd(const Eigen::VectorXd& position)> of; ///< as many numbers; empty: itself
    /// Negative log density of what is delivered, without constants.
    std::function<double(const Eigen::VectorXd& delivered)> energy;
};

struct HmcChain
{
    std::vector<Eigen::VectorXd> samples;
    HmcReport report;
};

/// Draws from a density by Hybrid Monte Carlo (Neal 2011): the step size is tuned during burn-in and stays
/// from then on; the chain grows up to 16-fold until its effective sample size reaches `count`. The same seed
/// gives the same samples.
/// \param mass  symmetric, positive definite; best near the second derivatives of the energy. Empty: one.
/// \throws Error Cancelled. Cost: O(burnIn + count · thinning) trajectories.
HmcChain drawByHmc(const HmcEnergy& energy, const Eigen::VectorXd& start, const Eigen::MatrixXd& mass,
                   int count, std::uint64_t seed, const HmcSettings& settings = {},
                   const Progress& progress = {}, const HmcDelivery& delivery = {});

/// How many independent values tell as much about the mean as a series of dependent ones: from the initial
/// monotone sequence of its autocovariances (Geyer 1992). At most as many as there are.
double effectiveSampleSize(const Eigen::Ref<const Eigen::VectorXd>& series);

/// Autocorrelation from one value of a series to the next; 0 where it does not vary.
double lag1Autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& series);

} // namespace quadrille
