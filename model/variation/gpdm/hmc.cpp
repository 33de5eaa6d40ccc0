// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/hmc.h"

#include "model/core/error.h"
#include "model/core/random.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// A chain that can take one trajectory after the other.
class Chain
{
public:
    Chain(const HmcEnergy& energy, const Eigen::VectorXd& start, const Eigen::MatrixXd& mass,
          std::uint64_t seed, int leapfrogSteps, const Progress& progress)
        : m_energy(energy)
        , m_hasMass(mass.size() > 0)
        , m_mass(mass)
        , m_random(seed)
        , m_leapfrogSteps(std::max(leapfrogSteps, 1))
        , m_token(progress.token())
        , m_position(start)
        , m_gradient(start.size())
    {
        m_value = m_energy(m_position, m_gradient);
    }

    const Eigen::VectorXd& position() const { return m_position; }
    double energy() const { return m_value; }

    struct Outcome
    {
        bool accepted = false;
        double probability = 0;
    };

    Outcome step(double stepSize)
    {
        drawMomentum();
        const double before = m_value + kinetic();
        m_proposal = m_position;
        m_proposalGradient = m_gradient;
        const auto steps = 1 + static_cast<int>(m_random.unit() * m_leapfrogSteps);
        double value = m_value;
        m_momentum -= 0.5 * stepSize * m_proposalGradient;
        for (int i = 0; i < steps; ++i) {
            if (m_token.isCancelled())
                throw Error(ErrorCode::Cancelled);
            m_velocity = m_momentum;
            if (m_hasMass)
                m_mass.solveInPlace(m_velocity);
            m_proposal += stepSize * m_velocity;
            value = m_energy(m_proposal, m_proposalGradient);
            if (!std::isfinite(value))
                break;
            m_momentum -= (i + 1 < steps ? 1.0 : 0.5) * stepSize * m_proposalGradient;
        }
        const double rise =
            std::isfinite(value) ? value + kinetic() - before : std::numeric_limits<double>::infinity();
        Outcome outcome{.probability = std::isfinite(rise) ? std::min(1.0, std::exp(-rise)) : 0};
        outcome.accepted = m_random.unit() < outcome.probability;
        if (outcome.accepted) {
            m_position.swap(m_proposal);
            m_gradient.swap(m_proposalGradient);
            m_value = value;
        }
        return outcome;
    }

private:
    void drawMomentum()
    {
        m_momentum.resize(m_position.size());
        for (double& value : m_momentum)
            value = m_random.normal();
        if (m_hasMass)
            m_momentum = (m_mass.matrixL() * m_momentum).eval();
    }

    double kinetic() const
    {
        return 0.5 *
               (m_hasMass ? m_mass.matrixL().solve(m_momentum).squaredNorm() : m_momentum.squaredNorm());
    }

    const HmcEnergy& m_energy;
    bool m_hasMass;
    Eigen::LLT<Eigen::MatrixXd> m_mass;
    Random m_random;
    int m_leapfrogSteps;
    CancelToken m_token;
    Eigen::VectorXd m_position;
    Eigen::VectorXd m_gradient;
    double m_value = 0;
    Eigen::VectorXd m_proposal;
    Eigen::VectorXd m_proposalGradient;
    Eigen::VectorXd m_momentum;
    Eigen::VectorXd m_velocity;
};

/// Dual averaging (Hoffman & Gelman 2014, section 3.2) towards a mean acceptance.
class StepSizeTuning
{
public:
    StepSizeTuning(double firstSize, double acceptance)
        : m_centre(std::log(firstSize)), m_log(m_centre), m_acceptance(acceptance)
    {
    }

    double size() const { return std::exp(m_log); }
    double averagedSize() const { return std::exp(m_averagedLog); }

    void update(double probability)
    {
        constexpr double steadiness = 10;
        constexpr double shrinkage = 0.05;
        m_count += 1;
        const double share = 1 / (m_count + steadiness);
        m_meanError += share * (m_acceptance - probability - m_meanError);
        m_log = m_centre - std::sqrt(m_count) / shrinkage * m_meanError;
        const double forgetting = std::pow(m_count, -0.75);
        m_averagedLog += forgetting * (m_log - m_averagedLog);
    }

private:
    double m_centre;
    double m_log;
    double m_acceptance;
    double m_averagedLog = 0;
    double m_meanError = 0;
    double m_count = 0;
};

constexpr int greatestGrowth = 16;
constexpr int greatestTunings = 5;

/// Runs a chain, and keeps all its states after burn-in.
class Recording
{
public:
    Recording(Chain& chain, const HmcSettings& settings, std::int64_t samples, const Progress& progress,
              const HmcDelivery& delivery)
        : m_chain(chain)
        , m_settings(settings)
        , m_delivery(delivery)
        , m_progress(progress)
        , m_tuning(std::pow(static_cast<double>(chain.position().size()), -0.25),
                   (settings.leastAcceptance + settings.greatestAcceptance) / 2)
        , m_planned(std::max(settings.burnIn, 1) + samples * std::max(settings.thinning, 1))
    {
    }

    void burnIn()
    {
        for (int i = 0; i < std::max(m_settings.burnIn, 1); ++i) {
            m_tuning.update(m_chain.step(m_tuning.size()).probability);
            countStep();
        }
        m_stepSize = m_tuning.averagedSize();
    }

    void extendTo(std::int64_t length)
    {
        m_states.conservativeResize(m_chain.position().size(), length);
        while (std::ssize(m_energies) < length) {
            m_accepted += m_chain.step(m_stepSize).accepted;
            const Eigen::Index state = std::ssize(m_energies);
            if (m_delivery.of) {
                m_states.col(state) = m_delivery.of(m_chain.position());
                m_energies.push_back(m_delivery.energy(m_states.col(state)));
            } else {
                m_states.col(state) = m_chain.position();
                m_energies.push_back(m_chain.energy());
            }
            countStep();
        }
    }

    void discard()
    {
        m_energies.clear();
        m_accepted = 0;
    }

    bool isWellTuned() const
    {
        return acceptance() >= m_settings.leastAcceptance && acceptance() <= m_settings.greatestAcceptance;
    }

    double acceptance() const
    {
        return m_energies.empty() ? 0
                                  : static_cast<double>(m_accepted) / static_cast<double>(m_energies.size());
    }

    double leastSampleSize() const
    {
        double least = static_cast<double>(m_states.cols());
        Eigen::VectorXd series(m_states.cols());
        for (Eigen::Index i = 0; i < m_states.rows(); ++i) {
            series = m_states.row(i);
            least = std::min(least, effectiveSampleSize(series));
        }
        return least;
    }

    const Eigen::MatrixXd& states() const { return m_states; }

    HmcReport report(int thinning) const
    {
        return {.acceptance = acceptance(),
                .stepSize = m_stepSize,
                .thinning = thinning,
                .energies = m_energies,
                .effectiveSampleSize = leastSampleSize(),
                .lag1 = lag1Autocorrelation(
                    Eigen::Map<const Eigen::VectorXd>(m_energies.data(), std::ssize(m_energies)))};
    }

private:
    void countStep()
    {
        ++m_done;
        m_progress.report(m_done, std::max(m_done, m_planned));
    }

    Chain& m_chain;
    const HmcSettings& m_settings;
    const HmcDelivery& m_delivery;
    const Progress& m_progress;
    StepSizeTuning m_tuning;
    std::int64_t m_planned;
    std::int64_t m_done = 0;
    double m_stepSize = 0;
    Eigen::MatrixXd m_states; ///< coordinates × states
    std::vector<double> m_energies;
    int m_accepted = 0;
};

} // namespace

HmcChain drawByHmc(const HmcEnergy& energy, const Eigen::VectorXd& start, const Eigen::MatrixXd& mass,
                   int count, std::uint64_t seed, const HmcSettings& settings, const Progress& progress,
                   const HmcDelivery& delivery)
{
    HmcChain result;
    if (count <= 0 || start.size() == 0) {
        result.samples.assign(static_cast<std::size_t>(std::max(count, 0)), start);
        return result;
    }
    Chain chain(energy, start, mass, seed, settings.leapfrogSteps, progress);
    Recording recording(chain, settings, count, progress, delivery);
    int thinning = std::max(settings.thinning, 1);
    recording.burnIn();
    recording.extendTo(std::int64_t{count} * thinning);
    for (int tunings = 1; tunings < greatestTunings && !recording.isWellTuned(); ++tunings) {
        recording.discard();
        recording.burnIn();
        recording.extendTo(std::int64_t{count} * thinning);
    }
    for (int growth = 2; growth <= greatestGrowth && recording.leastSampleSize() < count; growth *= 2) {
        thinning *= 2;
        recording.extendTo(std::int64_t{count} * thinning);
    }
    for (int i = 1; i <= count; ++i)
        result.samples.emplace_back(recording.states().col(std::int64_t{i} * thinning - 1));
    result.report = recording.report(thinning);
    return result;
}

double effectiveSampleSize(const Eigen::Ref<const Eigen::VectorXd>& series)
{
    const Eigen::Index n = series.size();
    if (n < 2)
        return static_cast<double>(n);
    const Eigen::VectorXd centred = series.array() - series.mean();
    const double variance = centred.squaredNorm();
    if (variance <= 0)
        return 1;
    const auto correlation = [&](Eigen::Index lag) {
        return lag < n ? centred.head(n - lag).dot(centred.tail(n - lag)) / variance : 0.0;
    };
    double sum = 0;
    double last = std::numeric_limits<double>::infinity();
    for (Eigen::Index lag = 0; lag < n; lag += 2) {
        const double pair = std::min(last, correlation(lag) + correlation(lag + 1));
        if (pair <= 0)
            break;
        sum += pair;
        last = pair;
    }
    return static_cast<double>(n) / std::max(1.0, 2 * sum - 1);
}

double lag1Autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& series)
{
    const Eigen::Index n = series.size();
    if (n < 2)
        return 0;
    const Eigen::VectorXd centred = series.array() - series.mean();
    const double variance = centred.squaredNorm();
    return variance > 0 ? centred.head(n - 1).dot(centred.tail(n - 1)) / variance : 0;
}

} // namespace quadrille
