// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/sampling.h"

#include "model/core/badargument.h"
#include "model/core/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace quadrille {

namespace {

/// So many candidates are drawn for each sample.
constexpr int candidatesPerSample = 8;
/// So many of them, at least, decide on the spread: by how many of these keep within the reach.
constexpr int trials = 40;
constexpr int leastWithin = trials / 4;
constexpr double narrowing = 0.7;
constexpr int greatestNarrowings = 10;

/// What the innovations of a chain become.
class Candidates
{
public:
    Candidates(const GpdmDynamics& dynamics, const RowMatrix& trajectory,
               const std::vector<Eigen::VectorXd>& innovations, double reach, const CancelToken& token)
        : m_dynamics(dynamics)
        , m_start(trajectory.row(0))
        , m_innovations(innovations)
        , m_reach(reach)
        , m_token(token)
    {
    }

    std::size_t count() const { return m_innovations.size(); }
    RowMatrix trajectory(std::size_t index, double spread) const
    {
        if (m_token.isCancelled())
            throw Error(ErrorCode::Cancelled);
        const Eigen::VectorXd& values = m_innovations[index];
        const Eigen::Index dimensions = m_start.size();
        return m_dynamics.trajectory(
            m_start,
            spread * Eigen::Map<const RowMatrix>(values.data(), values.size() / dimensions, dimensions));
    }
    /// Infinite for trajectories that overflow.
    double distance(const RowMatrix& candidate) const
    {
        return candidate.allFinite() ? m_dynamics.furthestFromTraining(candidate)
                                     : std::numeric_limits<double>::infinity();
    }
    bool isWithin(double distance) const { return distance <= m_reach; }

    /// The largest of the spreads that keep enough candidates within the reach.
    double usefulSpread(double spread) const
    {
        const std::size_t tried = std::min<std::size_t>(count(), trials);
        for (int narrowings = 0; narrowings < greatestNarrowings; ++narrowings, spread *= narrowing) {
            int within = 0;
            for (std::size_t i = 0; i < tried && within < leastWithin; ++i)
                within += isWithin(distance(trajectory(i, spread)));
            if (within == leastWithin)
                break;
        }
        return spread;
    }

private:
    const GpdmDynamics& m_dynamics;
    Eigen::RowVectorXd m_start;
    const std::vector<Eigen::VectorXd>& m_innovations;
    double m_reach;
    CancelToken m_token;
};

/// The first candidates within the reach; where there are too few, those nearest to the training as well.
void choose(const Candidates& candidates, int count, const Progress& progress, TrajectorySamples& samples)
{
    std::vector<RowMatrix> beyond;
    std::vector<double> distances;
    const auto wanted = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < candidates.count() && samples.trajectories.size() < wanted; ++i) {
        RowMatrix candidate = candidates.trajectory(i, samples.spread);
        const double distance = candidates.distance(candidate);
        if (candidates.isWithin(distance)) {
            samples.trajectories.push_back(std::move(candidate));
        } else {
            ++samples.rejected;
            beyond.push_back(std::move(candidate));
            distances.push_back(distance);
        }
        progress.report(static_cast<std::int64_t>(samples.trajectories.size()), count);
    }
    std::vector<std::size_t> order(beyond.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return distances[i]; });
    for (std::size_t i = 0; samples.trajectories.size() < wanted; ++i) {
        samples.trajectories.push_back(beyond[order[i]]);
        ++samples.beyondReach;
    }
}

} // namespace

TrajectorySamples sampleTrajectories(const GpdmDynamics& dynamics, const RowMatrix& trajectory, int count,
                                     std::uint64_t seed, const HmcSettings& settings,
                                     const Progress& progress, const TrajectoryLimits& limits)
{
    if (trajectory.rows() == 0)
        refuse("the trajectory has no positions", "choose a learned trajectory");
    if (!(limits.spread >= 0) || !std::isfinite(limits.spread) || !(limits.reach >= 0))
        refuse("the limits of variations are negative or no numbers", "choose numbers from 0 on, such as 1");
    if (count <= 0)
        return {};
    const HmcEnergy energy = [](const Eigen::VectorXd& innovations, Eigen::VectorXd& gradient) {
        gradient = innovations;
        return 0.5 * innovations.squaredNorm();
    };
    const Eigen::VectorXd start = Eigen::VectorXd::Zero(trajectory.size() - trajectory.cols());
    const HmcChain chain = drawByHmc(energy, start, {}, std::max(candidatesPerSample * count, trials), seed,
                                     settings, progress.part(0, 0.3));
    const Candidates candidates(dynamics, trajectory, chain.samples, limits.reach, progress.token());
    TrajectorySamples samples{.report = chain.report, .spread = candidates.usefulSpread(limits.spread)};
    choose(candidates, count, progress.part(0.3, 1), samples);
    for (const RowMatrix& sample : samples.trajectories)
        samples.energies.push_back(dynamics.energy(sample));
    return samples;
}

} // namespace quadrille
