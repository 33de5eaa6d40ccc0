// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/sampling.h"

#include "model/core/badargument.h"
#include "model/core/error.h"
#include "model/variation/posespread.h"
#include "model/variation/smoothdeviations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace quadrille {

namespace {

/// So many candidates are drawn for each sample.
constexpr int candidatesPerSample = 2;
/// Deviations may make a movement bend so much more than it does …
constexpr double greatestBending = 1.1;
/// … or as much as where it swings so often by what its takes are apart, if it hardly moves.
constexpr double swings = 1;
/// The first so many decide on the scale; at least half of them must be sure enough.
constexpr std::size_t trials = 24;
constexpr double leastShareSure = 0.5;
/// The scale is found when the spread differs by no more than this share …
constexpr double scaleTolerance = 0.01;
/// … or after so many measurements.
constexpr int greatestMeasurements = 20;

/// A deviation from a trajectory without what runs along it. Where the trajectory hardly moves, nothing is
/// known of its direction.
RowMatrix acrossTrajectory(const RowMatrix& trajectory, bool closes, RowMatrix deviation)
{
    constexpr double leastShare = 0.2; // of the mean speed
    const Eigen::Index last = trajectory.rows() - 1;
    RowMatrix along(trajectory.rows(), trajectory.cols());
    for (Eigen::Index f = 0; f <= last; ++f) {
        const Eigen::Index before = f > 0 ? f - 1 : closes ? last : 0;
        const Eigen::Index after = f < last ? f + 1 : closes ? 0 : last;
        along.row(f) = trajectory.row(after) - trajectory.row(before);
    }
    const double least = leastShare * leastShare * along.squaredNorm() / static_cast<double>(along.rows());
    for (Eigen::Index f = 0; f <= last; ++f) {
        const double squares = along.row(f).squaredNorm() + least;
        if (squares > 0)
            deviation.row(f) -= deviation.row(f).dot(along.row(f)) / squares * along.row(f);
    }
    return deviation;
}

/// The same, smooth again: what is left out turns with the trajectory. By projections in turn.
RowMatrix smoothAcross(const LearnedTrajectory& trajectory, const SmoothDeviations& smooth,
                       RowMatrix deviation)
{
    constexpr int turns = 6;
    for (int i = 0; i < turns; ++i)
        deviation =
            smooth.smoothed(acrossTrajectory(trajectory.positions, trajectory.closes, std::move(deviation)));
    return deviation;
}

/// Deviations that a chain drew, centred, as variations of any scale.
class Candidates
{
public:
    Candidates(const PoseSpread& poses, const LearnedTrajectory& trajectory, const SmoothDeviations& smooth,
               const std::vector<Eigen::VectorXd>& amplitudes, double uncertainty, const CancelToken& token)
        : m_poses(poses), m_trajectory(trajectory.positions), m_uncertainty(uncertainty), m_token(token)
    {
        const double frequency =
            2 * std::numbers::pi * swings / static_cast<double>(trajectory.positions.rows());
        m_bending = std::max(greatestBending * poses.bending(poses.posed(trajectory.positions)),
                             poses.reference() * frequency * frequency);
        const std::size_t tried = std::min(amplitudes.size(), trials);
        Eigen::VectorXd mean = Eigen::VectorXd::Zero(smooth.size());
        for (std::size_t i = 0; i < tried; ++i)
            mean += amplitudes[i] / static_cast<double>(tried);
        for (const Eigen::VectorXd& each : amplitudes)
            m_deviations.push_back(smoothAcross(trajectory, smooth, smooth.deviation(each - mean)));
    }

    std::size_t count() const { return m_deviations.size(); }
    RowMatrix trajectory(std::size_t index, double scale) const
    {
        return m_trajectory + scale * m_deviations[index];
    }
    bool isSure(const PosedTrajectory& posed) const { return posed.uncertainty <= m_uncertainty; }

    struct Measurement
    {
        double spread = 0;   ///< metres
        bool isSure = false; ///< so are most of them, and all together bend no more than they may
    };
    Measurement measure(double scale) const
    {
        std::vector<PosedTrajectory> posed;
        std::size_t sure = 0;
        double bending = 0;
        const std::size_t tried = std::min(count(), trials);
        for (std::size_t i = 0; i < tried; ++i) {
            if (m_token.isCancelled())
                throw Error(ErrorCode::Cancelled);
            posed.push_back(m_poses.posed(trajectory(i, scale)));
            sure += isSure(posed.back());
            bending += m_poses.bending(posed.back()) / static_cast<double>(tried);
        }
        return {m_poses.between(posed),
                bending <= m_bending &&
                    static_cast<double>(sure) >= leastShareSure * static_cast<double>(tried)};
    }

private:
    const PoseSpread& m_poses;
    RowMatrix m_trajectory;
    std::vector<RowMatrix> m_deviations;
    double m_uncertainty;
    double m_bending = 0; ///< at most
    CancelToken m_token;
};

/// The scale at which candidates are so far apart, or the largest one at which enough of them are sure, and
/// that does not make them bend too much.
double scaleFor(const Candidates& candidates, double spread, const Progress& progress)
{
    double below = 0;
    double spreadBelow = 0;
    double above = std::numeric_limits<double>::infinity();
    double scale = 1;
    for (int i = 0; i < greatestMeasurements && spread > 0; ++i) {
        progress.report(i, greatestMeasurements);
        const Candidates::Measurement found = candidates.measure(scale);
        if (found.spread <= 0)
            return 0;
        const double ratio = spread / found.spread;
        if (found.isSure && std::abs(ratio - 1) <= scaleTolerance)
            return scale;
        // Far from all that was learned, poses become alike again.
        if (found.isSure && ratio > 1 && found.spread >= spreadBelow) {
            below = scale;
            spreadBelow = found.spread;
        } else {
            above = scale;
        }
        // Poses are nearly linear in small scales; between two that were tried, their mean size.
        if (below > 0 && std::isfinite(above))
            scale = std::sqrt(below * above);
        else
            scale *= below > 0 ? ratio : std::min(ratio, 0.5);
        if (above <= (1 + scaleTolerance) * below)
            break;
    }
    return below;
}

/// The first candidates that are sure; where there are too few, the surest of the others as well.
void choose(const Candidates& candidates, const PoseSpread& poses, int count, const Progress& progress,
            TrajectorySamples& samples)
{
    std::vector<PosedTrajectory> posed;
    std::vector<std::size_t> order;
    std::vector<std::size_t> chosen;
    const auto wanted = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < candidates.count() && chosen.size() < wanted; ++i) {
        progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(candidates.count()));
        posed.push_back(poses.posed(candidates.trajectory(i, samples.report.scale)));
        (candidates.isSure(posed.back()) ? chosen : order).push_back(i);
    }
    samples.report.rejected = static_cast<int>(order.size());
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return posed[i].uncertainty; });
    for (std::size_t i = 0; chosen.size() < wanted; ++i) {
        chosen.push_back(order[i]);
        ++samples.report.uncertain;
    }
    std::vector<PosedTrajectory> given;
    for (const std::size_t i : chosen) {
        samples.trajectories.push_back(candidates.trajectory(i, samples.report.scale));
        given.push_back(std::move(posed[i]));
    }
    samples.report.spread = poses.reference() > 0 ? poses.between(given) / poses.reference() : 0;
}

/// The model's own trajectories, and what is said of them.
TrajectorySamples modelTrajectories(const GpdmDynamics& dynamics, const PoseSpread& poses,
                                    const LearnedTrajectory& trajectory, int count, std::uint64_t seed,
                                    const SamplingSettings& settings, const Progress& progress)
{
    const Eigen::Index frames = trajectory.positions.rows();
    const Eigen::Index dimensions = trajectory.positions.cols();
    const Eigen::RowVectorXd start = trajectory.positions.row(0);
    const auto whole = [&](const Eigen::VectorXd& positions) {
        RowMatrix all(frames, dimensions);
        all << start, Eigen::Map<const RowMatrix>(positions.data(), frames - 1, dimensions);
        return all;
    };
    const HmcEnergy energy = [](const Eigen::VectorXd& innovations, Eigen::VectorXd& gradient) {
        gradient = innovations;
        return 0.5 * innovations.squaredNorm();
    };
    const HmcDelivery delivery{
        .of = [&](const Eigen::VectorXd& innovations) -> Eigen::VectorXd {
            const RowMatrix all = dynamics.trajectory(
                start, Eigen::Map<const RowMatrix>(innovations.data(), frames - 1, dimensions));
            return all.bottomRows(frames - 1).reshaped<Eigen::RowMajor>();
        },
        .energy = [&](const Eigen::VectorXd& positions) { return dynamics.energy(whole(positions)); }};
    HmcChain chain = drawByHmc(energy, Eigen::VectorXd::Zero((frames - 1) * dimensions), {}, count, seed,
                               settings.chain, progress, delivery);
    TrajectorySamples samples;
    std::vector<PosedTrajectory> posed;
    for (const Eigen::VectorXd& positions : chain.samples) {
        samples.trajectories.push_back(whole(positions));
        posed.push_back(poses.posed(samples.trajectories.back()));
        samples.report.uncertain += posed.back().uncertainty > settings.limits.uncertainty ? 1 : 0;
    }
    samples.report.chain = std::move(chain.report);
    samples.report.isGuess = poses.isGuess();
    samples.report.spread = poses.reference() > 0 ? poses.between(posed) / poses.reference() : 0;
    return samples;
}

void check(const LearnedTrajectory& trajectory, const TrajectoryLimits& limits)
{
    if (trajectory.positions.rows() == 0)
        refuse("the trajectory has no positions", "choose a learned trajectory");
    const std::vector<double>& times = trajectory.times;
    if (!times.empty() &&
        (std::ssize(times) != trajectory.positions.rows() || !std::ranges::is_sorted(times)))
        refuse("the times of the trajectory are not one for each position, ascending",
               "give those of its take's warp");
    if (!(limits.spread >= 0) || !std::isfinite(limits.spread) || !(limits.uncertainty >= 0))
        refuse("the limits of variations are negative or no numbers",
               "choose numbers from 0 on, such as 0.7");
}

} // namespace

TrajectorySamples sampleTrajectories(const GpdmDynamics& dynamics, const PoseSpread& poses,
                                     const LearnedTrajectory& trajectory, int count, std::uint64_t seed,
                                     const SamplingSettings& settings, const Progress& progress)
{
    check(trajectory, settings.limits);
    TrajectorySamples samples;
    if (count <= 0)
        return samples;
    if (trajectory.positions.rows() == 1) {
        samples.trajectories.assign(static_cast<std::size_t>(count), trajectory.positions);
        return samples;
    }
    if (settings.limits.draw == TrajectoryDraw::Model)
        return modelTrajectories(dynamics, poses, trajectory, count, seed, settings, progress);
    const SmoothDeviations smooth(dynamics, trajectory);
    const HmcEnergy energy = [&](const Eigen::VectorXd& amplitudes, Eigen::VectorXd& gradient) {
        return smooth.energy(amplitudes, gradient);
    };
    const int drawn = std::max(candidatesPerSample * count, static_cast<int>(trials));
    HmcChain chain = drawByHmc(energy, Eigen::VectorXd::Zero(smooth.size()), smooth.curvature(), drawn, seed,
                               settings.chain, progress.part(0, 0.8));
    const Candidates candidates(poses, trajectory, smooth, chain.samples, settings.limits.uncertainty,
                                progress.token());
    samples.report.chain = std::move(chain.report);
    samples.report.isGuess = poses.isGuess();
    samples.report.scale =
        scaleFor(candidates, settings.limits.spread * poses.reference(), progress.part(0.8, 0.95));
    choose(candidates, poses, count, progress.part(0.95, 1), samples);
    return samples;
}

} // namespace quadrille
