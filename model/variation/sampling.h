// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/densematrix.h"
#include "model/variation/gpdm.h"
#include "model/variation/hmc.h"
#include "model/variation/rowpanels.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// The Gaussian process of the latent dynamics of a learned model: what follows a latent position (CVS eq.
/// 8–10). Factorised once; immutable, safe from any thread.
class GpdmDynamics
{
public:
    GpdmDynamics(const GpdmState& state, std::span<const RowSpan> spans);

    /// The most probable next position (eq. 9).
    Eigen::RowVectorXd next(const Eigen::RowVectorXd& latent) const;
    /// Its variance in every dimension, with the noise (eq. 10).
    double variance(const Eigen::RowVectorXd& latent) const;
    /// Frame after frame by the mean. \return length × dimensions, the first row is `start`.
    RowMatrix meanPrediction(const Eigen::RowVectorXd& start, Eigen::Index length) const;

    /// Negative log density of a trajectory after its first position, without constants: the joint
    /// conditional of ALGORITHMS section 8, and its gradient by the trajectory (first row zero).
    /// Cost: O(length · inputs² + length³).
    double energy(const RowMatrix& trajectory, RowMatrix* gradient = nullptr) const;
    /// The trajectory whose steps depart from their means, given the training and all steps before them, by
    /// so many standard deviations. Zeros give the mean prediction; independent standard normals make the
    /// trajectory a draw from the joint conditional.
    /// \param innovations  steps × dimensions. \return one row more. Cost: O(steps · (inputs + steps)²).
    RowMatrix trajectory(const Eigen::RowVectorXd& start, const RowMatrix& innovations) const;
    /// Undoes trajectory().
    RowMatrix innovations(const RowMatrix& trajectory) const;

    /// How far the position of a trajectory that is furthest from all learned ones is from the nearest of
    /// them, in mean steps of the training.
    double furthestFromTraining(const RowMatrix& trajectory) const;

    const RowMatrix& inputs() const { return m_inputs; }
    const GpdmHyperparameters& hyperparameters() const { return m_hyperparameters; }

private:
    struct Steps;
    Steps steps(const RowMatrix& from) const;

    GpdmHyperparameters m_hyperparameters;
    RowMatrix m_latents;
    double m_meanStep = 0;
    RowMatrix m_inputs;   ///< all but the last latent of each sequence
    DenseMatrix m_factor; ///< lower Cholesky factor of K_X
    RowMatrix m_weights;  ///< K_X⁻¹·X′
};

/// How far variations may go. A model knows little of what lies between its training takes, and trajectories
/// that leave them give poses that nobody would take.
struct TrajectoryLimits
{
    double spread = 1; ///< scale of all innovations at most: 1 is what the model says
    /// Trajectories that go further from all training latents are rejected, in mean steps of the training.
    /// Where less than a quarter of them keep within it, the spread is made smaller.
    double reach = 1;

    bool operator==(const TrajectoryLimits&) const = default;
};

struct TrajectorySamples
{
    std::vector<RowMatrix> trajectories; ///< each frames × dimensions; the first row is the start
    std::vector<double> energies;        ///< of the trajectories (see GpdmDynamics::energy)
    HmcReport report;                    ///< of the chain; its energies are those of the innovations
    double spread = 1;                   ///< that was used
    int rejected = 0;                    ///< went beyond the reach
    int beyondReach = 0;                 ///< of the trajectories, where too few of all kept within it
};

/// Draws variations of a latent trajectory by Hybrid Monte Carlo, started at the mean prediction from its
/// first position, which stays (CVS §6). The chain moves in the innovations of the trajectory: there the
/// joint conditional is a standard normal distribution, while in the positions themselves it is so stiff that
/// a chain stays about where it began. The same seed gives the same samples. \param trajectory  of which the
/// first position and the length count: a learned one. \throws Error BadArgument (a trajectory without
/// positions, limits that are negative or no numbers), Cancelled.
TrajectorySamples sampleTrajectories(const GpdmDynamics& dynamics, const RowMatrix& trajectory, int count,
                                     std::uint64_t seed, const HmcSettings& settings = {},
                                     const Progress& progress = {}, const TrajectoryLimits& limits = {});

/// How a drawn pose deviates from the mean.
enum class PoseDeviation
{
    Coordinates, ///< each coordinate on its own, as CVS eq. 11 says: rough where the model is unsure
    /// Along combinations of the training poses with as much variance in each frame: as smooth as they are.
    TrainingSpan,
};

/// The Gaussian process from latent positions to poses of a learned model (CVS eq. 11–13). Factorised once;
/// immutable, safe from any thread.
class PoseReconstruction
{
public:
    /// \param rows  centred training rows. \param mean  that was subtracted.
    PoseReconstruction(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows,
                       Eigen::RowVectorXd mean);

    Eigen::Index coordinates() const { return m_mean.size(); }
    /// Most probable pose vector (eq. 12), with the mean added.
    void mean(const Eigen::Ref<const Eigen::RowVectorXd>& latent, std::span<double> out) const;
    /// Variance of a coordinate without the noise (eq. 13).
    double variance(const Eigen::Ref<const Eigen::RowVectorXd>& latent) const;
    /// Pose vectors of a trajectory by the mean, frames × coordinates.
    RowMatrix means(const RowMatrix& trajectory) const;
    /// One draw for the whole trajectory, jointly over its frames, so that it does not flicker, without the
    /// noise.
    RowMatrix draw(const RowMatrix& trajectory, std::uint64_t seed,
                   PoseDeviation deviation = PoseDeviation::TrainingSpan) const;

private:
    /// What training says about some latent positions.
    struct Prediction
    {
        DenseMatrix whitened;   ///< L⁻¹·k, training rows × positions
        RowMatrix coefficients; ///< of the training rows in the poses, positions × training rows
    };
    Prediction predict(const RowMatrix& latents) const;

    GpdmHyperparameters m_hyperparameters;
    RowMatrix m_latents;
    DenseMatrix m_factor; ///< lower Cholesky factor of K_Y
    Eigen::RowVectorXd m_mean;
    RowPanels m_rows;       ///< Y: sums of its rows are more precise than products with K_Y⁻¹·Y
    double m_spanScale = 0; ///< that gives draws in the training span their variance
};

} // namespace quadrille
