// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/densematrix.h"
#include "model/variation/gpdm/gpdm.h"
#include "model/variation/gpdm/hmc.h"
#include "model/variation/gpdm/rowpanels.h"
#include "model/variation/trajectorylimits.h"

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

    /// The trajectory that innovations of a standard normal density make, position after position, each from
    /// all before it and from what was learned: such trajectories have the density of `energy`. Without
    /// innovations it is the mean prediction. \param innovations  (length − 1) × dimensions.
    /// Cost: O(length · inputs² + length³).
    RowMatrix trajectory(const Eigen::RowVectorXd& start, const RowMatrix& innovations) const;

    /// Negative log density of a trajectory after its first position, without constants: the joint
    /// conditional of the dynamics, and its gradient by the trajectory (first row zero).
    /// Cost: O(length · inputs² + length³).
    double energy(const RowMatrix& trajectory, RowMatrix* gradient = nullptr) const;

    const RowMatrix& inputs() const { return m_inputs; }
    const GpdmHyperparameters& hyperparameters() const { return m_hyperparameters; }

private:
    struct Steps;
    Steps steps(const RowMatrix& from) const;

    GpdmHyperparameters m_hyperparameters;
    RowMatrix m_inputs;   ///< all but the last latent of each sequence
    DenseMatrix m_factor; ///< lower Cholesky factor of K_X
    RowMatrix m_weights;  ///< K_X⁻¹·X′
};

/// How variations are drawn.
struct SamplingSettings
{
    HmcSettings chain;
    TrajectoryLimits limits;
};

/// How one learned trajectory was varied.
struct SampleReport
{
    HmcReport chain;
    /// What the deviations that the chain drew were multiplied by; 1 is what the model says.
    double scale = 1;
    /// How far the samples are apart, as a share of PoseSpread::reference.
    double spread = 0;
    bool isGuess = false; ///< PoseSpread::isGuess: how far takes of the movement are apart is not known
    int rejected = 0;     ///< more uncertain than the limit
    int uncertain = 0;    ///< of the samples, where too few of all were sure
};

struct TrajectorySamples
{
    std::vector<RowMatrix> trajectories; ///< each frames × dimensions; the first row is the start
    SampleReport report;
};

class PoseSpread;

/// A learned latent trajectory that is varied.
struct LearnedTrajectory
{
    RowMatrix positions; ///< frames × dimensions
    /// When each frame is played, in any unit, ascending, the last one after the first: deviations are smooth
    /// in it. Empty: one after the other.
    std::vector<double> times = {};
    bool closes = false; ///< a cycle: its first position follows its last one
};

/// Draws variations of a learned latent trajectory by Hybrid Monte Carlo (CVS §6). The chain's target is the
/// joint conditional of the dynamics, given the first position, which stays. By TrajectoryDraw:
/// - smooth: on trajectories that deviate smoothly from the learned one (see SmoothDeviations), where it
///   starts. What it draws is centred, so that variations lie around what they vary; what of it runs along
///   the learned trajectory is left out, as parts of a body that hurry or lag each on its own fall out of
///   step (see inTempo); it is scaled until poses are as far apart as `limits.spread` says, or bend by a
///   tenth more than the take. Of innovations that were scaled instead, noise became jitter, and errors grew
///   along the trajectory until it left all that was learned.
/// - model: on all positions, from the mean prediction on (CVS §6). What is drawn is given as it is. The
///   chain goes over innovations (GpdmDynamics::trajectory), in which that density is a standard normal one:
///   over positions, of which each pulls at all behind it, some thousand states are worth three.
/// The same seed gives the same samples, for any number of threads.
/// \param poses  of the same model. \throws Error BadArgument (a trajectory without positions, limits that
/// are negative or no numbers), Cancelled.
TrajectorySamples sampleTrajectories(const GpdmDynamics& dynamics, const PoseSpread& poses,
                                     const LearnedTrajectory& trajectory, int count, std::uint64_t seed,
                                     const SamplingSettings& settings = {}, const Progress& progress = {});

/// How a drawn pose deviates from the mean.
enum class PoseDeviation
{
    Coordinates, ///< each coordinate on its own, as CVS eq. 11 says: rough where the model is unsure
    /// Along combinations of the training poses with as much variance in each frame: as smooth as they are.
    TrainingSpan,
};

/// Poses as sums of training poses.
struct PoseCombination
{
    RowMatrix coefficients;    ///< of the training rows, positions × training rows
    Eigen::VectorXd variances; ///< of a coordinate without the noise (CVS eq. 13)
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
    /// What the means of a trajectory are sums of, and how sure they are.
    PoseCombination combination(const RowMatrix& trajectory) const;
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
