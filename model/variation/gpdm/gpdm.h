// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/units.h"

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// Rows × columns of the formulas, double precision, row-major like all tables.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Which rows of a training matrix belong to one sequence.
struct RowSpan
{
    Eigen::Index first = 0;
    Eigen::Index count = 0;

    Eigen::Index last() const { return first + count - 1; }
    bool operator==(const RowSpan&) const = default;
};

/// Parameters of both kernels (CVS eq. 4 and 6).
struct GpdmHyperparameters
{
    double alpha1 = 1;  ///< variance of a coordinate of the pose, m²
    double alpha2 = 1;  ///< inverse squared length in latent space; fixed, as X could be scaled instead
    double alpha3 = 10; ///< 1 / variance of the noise of a coordinate, 1/m²
    double beta1 = 1;   ///< variance of the non-linear dynamics
    double beta2 = 1;   ///< their inverse squared length
    double beta3 = 1;   ///< variance of the linear dynamics
    double beta4 = 10;  ///< 1 / variance of the noise of the dynamics

    bool operator==(const GpdmHyperparameters&) const = default;
};

/// Latent trajectories and hyperparameters: what learning finds.
struct GpdmState
{
    RowMatrix latents; ///< frames × dimensions
    GpdmHyperparameters hyperparameters;
};

/// The negative log posterior of CVS eq. 7 without constants as a function of latents
/// and hyperparameters. Holds working memory: one for each thread.
class GpdmObjective
{
public:
    /// \param gram  Y·Yᵀ of the centred training rows, frames × frames; must outlive the objective.
    /// \param coordinates  columns of Y.
    /// \param spans  of the sequences, without gaps.
    /// \pre Every sequence has at least two frames.
    GpdmObjective(const RowMatrix& gram, Eigen::Index coordinates, std::span<const RowSpan> spans);
    ~GpdmObjective();
    GpdmObjective(const GpdmObjective&) = delete;
    GpdmObjective& operator=(const GpdmObjective&) = delete;

    /// Derivatives by the latents and by the hyperparameters themselves.
    struct Gradient
    {
        RowMatrix latents;
        GpdmHyperparameters hyperparameters;
    };
    double value(const GpdmState& state);
    /// Both at once. Infinite, with a gradient of zero, where latents are too large to be told apart from
    /// infinite ones. Cost: O(frames³).
    double value(const GpdmState& state, Gradient& gradient);
    /// What the last value needed on the diagonal of a kernel matrix, beside the noise, to be factorised in
    /// double precision: a share of its mean diagonal, 0 as a rule.
    double jitter() const;

    /// Multiplies the two terms with K_Y; 1 is the objective that is meant. Learning raises it to 1 in steps.
    void setPoseWeight(double weight);
    /// The last value, had the weight been 1.
    double unweighted() const;

private:
    struct Work;
    std::unique_ptr<Work> m_work;
};

struct GpdmSettings
{
    int dimensions = 3;
    int restarts = 1; ///< starts beyond the first from perturbed principal components; the best one is kept
    std::uint64_t seed = 1;
    /// Stop where the objective fell by less than this share of itself …
    double tolerance = 1e-6;
    int window = 10;                ///< … in so many iterations.
    int greatestIterations = 20000; ///< of one start; learning reports where this is what stopped it

    bool operator==(const GpdmSettings&) const = default;
};

/// Why learning stopped.
enum class GpdmStop
{
    Converged,
    IterationLimit,
    Stalled,   ///< not even along the gradient does the objective fall any more in double precision
    Cancelled, ///< the best so far is kept
};

struct GpdmLearning
{
    GpdmState state;
    /// Of the start that won, before and after each iteration; the last one is final and the least, but
    /// before the last stage of learning it may rise now and then.
    std::vector<double> objective;
    std::vector<double> finalObjectives; ///< of each start
    GpdmStop stop = GpdmStop::Converged;
    /// Names of hyperparameters that stayed at a bound, "alpha3", …
    std::vector<std::string> activeBounds;
    /// GpdmObjective::jitter() of the state.
    double jitter = 0;
};

/// Told after each iteration, from the thread that learns: how many there were of this start, the objective,
/// and the state. What it throws ends learning and is thrown on.
using GpdmWatch = std::function<void(int iteration, double objective, const GpdmState& state)>;

/// Learns a model of one part by L-BFGS from principal components. The variables are latents and u with
/// ln(hyperparameter) = L·tanh(u/L), L = ln 1e6. The same on as many threads as there are; to be called for
/// several parts at a time. The terms of the poses come to their full weight in stages: so latents stay
/// smooth and the minimum is lower than from the components alone. \param rows  centred training rows Y,
/// frames × coordinates. \param progress  once cancelled, learning stops and returns its best so far with
/// GpdmStop::Cancelled. How much is left is a guess: it reports the fraction that learning usually has done
/// after so many iterations. \throws Error BadArgument (a sequence of fewer than 3 frames, fewer frames than
/// dimensions), NonFiniteCoordinate, Cancelled (before there is any state to return).
GpdmLearning learnGpdm(const Eigen::Ref<const RowMatrix>& rows, std::span<const RowSpan> spans,
                       const GpdmSettings& settings, const Progress& progress = {},
                       const GpdmWatch& watch = {});

/// Y·Yᵀ. \throws Error Cancelled.
RowMatrix gramMatrix(const Eigen::Ref<const RowMatrix>& rows, const Progress& progress = {});

/// Principal components as the first latents: scores scaled to unit variance of the first component, each
/// with its largest score positive. Zero where all frames are the same.
/// \param gram  Y·Yᵀ. \return frames × dimensions.
RowMatrix principalLatents(const RowMatrix& gram, int dimensions);

} // namespace quadrille
