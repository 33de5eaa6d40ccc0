// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/badargument.h"
#include "model/core/random.h"
#include "model/variation/gpdm/gpdm.h"
#include "model/variation/gpdm/gpdmvariables.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <lbfgs.h>
#include <limits>
#include <memory>

namespace quadrille {

namespace {

/// Pairs of steps that L-BFGS remembers.
constexpr int history = 100;

/// Of stages before the last one: enough for latents to find their order.
constexpr double stageTolerance = 1e-4;

/// Of the variables' latents (see GpdmVariables).
constexpr double smoothness = 10;

/// Fewer let the noise of the dynamics go to its bound, and the latents shrink to a point where there are few
/// frames.
constexpr double firstCoordinates = 100;

/// From one stage to the next.
constexpr double weightFactor = 1.8;

struct Free
{
    void operator()(double* values) const { lbfgs_free(values); }
};

/// How much the objective's terms of the poses weigh, stage after stage. All at once they are so many that
/// latents are scattered to fit them before they have found their order; in the first stage they weigh as if
/// there were `firstCoordinates` of them.
std::vector<double> poseWeights(Eigen::Index coordinates)
{
    std::vector<double> weights;
    for (double weight = firstCoordinates / static_cast<double>(coordinates); weight < 1;
         weight *= weightFactor)
        weights.push_back(weight);
    weights.push_back(1);
    return weights;
}

/// One start of the optimiser, told by the library's callbacks.
class Start
{
public:
    Start(GpdmObjective& objective, std::span<const RowSpan> spans, const GpdmState& first,
          const GpdmSettings& settings, const Progress& progress, const GpdmWatch& watch)
        : m_objective(objective)
        , m_variables(spans, first.latents.cols(), smoothness)
        , m_settings(settings)
        , m_progress(progress)
        , m_watch(watch)
        , m_state(first)
        , m_best(first)
    {
        objective.value(first);
        m_values.push_back(objective.unweighted());
    }

    GpdmStop run(std::span<const double> weights);
    /// Of least objective.
    const GpdmState& best() const { return m_best; }
    /// Before and after each iteration until the best.
    std::vector<double> values() const { return {m_values.begin(), m_values.begin() + m_bestAt + 1}; }

private:
    static double evaluate(void* self, const double* x, double* g, int count, double step);
    static int iterated(void* self, const double* x, const double* g, double value, double xNorm,
                        double gNorm, double step, int count, int iteration, int evaluations);
    void accept(const double* x, double value);
    GpdmStop runStage();
    int descend();
    bool converged() const;
    std::ptrdiff_t iterations() const { return static_cast<std::ptrdiff_t>(m_values.size()) - 1; }
    bool isCancelled();

    GpdmObjective& m_objective;
    GpdmVariables m_variables;
    const GpdmSettings& m_settings;
    const Progress& m_progress;
    const GpdmWatch& m_watch;
    GpdmState m_state;
    GpdmState m_best;
    std::ptrdiff_t m_bestAt = 0;
    std::vector<double> m_values;      ///< of the whole objective
    std::vector<double> m_stageValues; ///< of what is minimised in this stage
    double m_tolerance = 0;
    GpdmObjective::Gradient m_gradient;
    std::exception_ptr m_thrown;
    bool m_cancelled = false;
};

bool Start::isCancelled()
{
    m_cancelled = m_cancelled || m_progress.isCancelled();
    return m_cancelled;
}

/// Nothing may be thrown through the library, which is C. What ends learning within a line search looks like
/// the best of all steps to it, so that it comes to iterated() at once.
double Start::evaluate(void* self, const double* x, double* g, int count, double /*step*/)
{
    Start& start = *static_cast<Start*>(self);
    std::fill_n(g, count, 0.0);
    constexpr double end = -1e300;
    if (start.isCancelled() || start.m_thrown)
        return end;
    try {
        const GpdmState state = start.m_variables.read(x);
        const double value = start.m_objective.value(state, start.m_gradient);
        start.m_variables.writeGradient(state, start.m_gradient, g);
        return value;
    } catch (...) {
        start.m_thrown = std::current_exception();
        return end;
    }
}

int Start::iterated(void* self, const double* x, const double* /*g*/, double value, double /*xNorm*/,
                    double /*gNorm*/, double /*step*/, int /*count*/, int /*iteration*/, int /*evaluations*/)
{
    Start& start = *static_cast<Start*>(self);
    if (start.isCancelled() || start.m_thrown)
        return 1;
    try {
        start.accept(x, value);
    } catch (const Error& error) {
        if (error.code() == ErrorCode::Cancelled)
            start.m_cancelled = true;
        else
            start.m_thrown = std::current_exception();
        return 1;
    } catch (...) {
        start.m_thrown = std::current_exception();
        return 1;
    }
    return start.converged() || start.iterations() >= start.m_settings.greatestIterations ? 1 : 0;
}

/// \pre The last evaluation was that of x.
void Start::accept(const double* x, double value)
{
    m_state = m_variables.read(x);
    m_stageValues.push_back(value);
    m_values.push_back(m_objective.unweighted());
    if (m_values.back() < m_values[static_cast<std::size_t>(m_bestAt)]) {
        m_best = m_state;
        m_bestAt = iterations();
    }
    if (m_watch)
        m_watch(static_cast<int>(iterations()), m_values.back(), m_state);
    // How many iterations there will be is not known; some 1,000 are usual.
    m_progress.report(1 - std::exp(-static_cast<double>(iterations()) / 500));
}

bool Start::converged() const
{
    const auto window = static_cast<std::size_t>(m_settings.window);
    if (m_stageValues.size() <= window)
        return false;
    const double value = m_stageValues.back();
    return m_stageValues[m_stageValues.size() - 1 - window] - value < m_tolerance * std::abs(value);
}

/// The optimiser from the last state on, without memory. \return what the library says.
int Start::descend()
{
    // With SSE2 the library takes numbers in sixteens; those beyond have no effect.
    const auto count = static_cast<int>((m_variables.count() + 15) / 16 * 16);
    const std::unique_ptr<double[], Free> x(lbfgs_malloc(count));
    if (!x)
        throw std::bad_alloc();
    std::fill_n(x.get(), count, 0.0);
    m_variables.write(m_state, x.get());
    lbfgs_parameter_t parameters;
    lbfgs_parameter_init(&parameters);
    parameters.m = history;
    parameters.epsilon = 0;
    return lbfgs(count, x.get(), nullptr, evaluate, iterated, this, &parameters);
}

GpdmStop Start::runStage()
{
    m_stageValues = {m_objective.value(m_state)};
    while (true) {
        const std::ptrdiff_t before = iterations();
        const int result = descend();
        if (m_thrown)
            std::rethrow_exception(m_thrown);
        if (m_cancelled)
            return GpdmStop::Cancelled;
        if (converged() || result == LBFGS_SUCCESS || result == LBFGS_ALREADY_MINIMIZED)
            return GpdmStop::Converged;
        if (iterations() >= m_settings.greatestIterations)
            return GpdmStop::IterationLimit;
        // The line search failed. Along the gradient it may go on; if not, then rounding forbids.
        if (iterations() == before)
            return GpdmStop::Stalled;
    }
}

GpdmStop Start::run(std::span<const double> weights)
{
    GpdmStop stop = GpdmStop::Converged;
    for (const double weight : weights) {
        m_objective.setPoseWeight(weight);
        m_tolerance = std::max(m_settings.tolerance, weight < 1 ? stageTolerance : 0.0);
        stop = runStage();
        if (stop == GpdmStop::Cancelled || stop == GpdmStop::IterationLimit)
            return stop;
    }
    // With few frames, an earlier stage may have come by a better state.
    if (m_bestAt != iterations()) {
        m_state = m_best;
        stop = runStage();
    }
    return stop;
}

/// Components turned a little into each other and into the next ones, and other hyperparameters.
GpdmState perturbed(const GpdmState& state, const RowMatrix& components, Random& random)
{
    constexpr double share = 0.2;
    constexpr double factor = 0.5;
    const Eigen::Index dimensions = state.latents.cols();
    RowMatrix mix =
        RowMatrix::NullaryExpr(components.cols(), dimensions, [&random] { return share * random.normal(); });
    mix.topRows(dimensions).diagonal().array() += 1;
    GpdmState result{components * mix, state.hyperparameters};
    GpdmHyperparameters& h = result.hyperparameters;
    for (double* parameter : {&h.alpha1, &h.alpha3, &h.beta1, &h.beta2, &h.beta3, &h.beta4})
        *parameter *= std::exp(factor * random.normal());
    return result;
}

void check(const Eigen::Ref<const RowMatrix>& rows, std::span<const RowSpan> spans,
           const GpdmSettings& settings)
{
    if (settings.dimensions < 1 || settings.restarts < 0 || settings.window < 1 ||
        settings.greatestIterations < 1 || !(settings.tolerance >= 0))
        refuse("the settings of learning are out of their range", "take the defaults");
    if (rows.cols() == 0)
        refuse("the part has no vertices", "draw the curves so that every part has some");
    Eigen::Index next = 0;
    for (const RowSpan& span : spans) {
        if (span.count < 3)
            refuse("a take has fewer than 3 frames", "choose longer takes");
        if (span.first != next)
            refuse("the rows of takes do not follow each other", "order them");
        next += span.count;
    }
    if (spans.empty() || next != rows.rows())
        refuse("the takes do not cover all training frames", "name the rows of each");
    if (rows.rows() <= settings.dimensions)
        refuse("there are no more training frames than latent dimensions",
               "add takes or lower the dimensions");
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        for (Eigen::Index j = 0; j < rows.cols(); ++j)
            if (!std::isfinite(rows(i, j)))
                throw Error(ErrorCode::NonFiniteCoordinate, {.place = {.frame = FrameIndex{i}},
                                                             .values = {{"vertex", std::to_string(j / 3)}}});
}

} // namespace

GpdmLearning learnGpdm(const Eigen::Ref<const RowMatrix>& rows, std::span<const RowSpan> spans,
                       const GpdmSettings& settings, const Progress& progress, const GpdmWatch& watch)
{
    check(rows, spans, settings);
    const RowMatrix gram = gramMatrix(rows, progress.part(0, 0));
    const RowMatrix components = principalLatents(gram, 2 * settings.dimensions);
    GpdmObjective objective(gram, rows.cols(), spans);
    const std::vector<double> weights = poseWeights(rows.cols());
    Random random(settings.seed);
    GpdmLearning learning;
    const int starts = 1 + settings.restarts;
    for (int i = 0; i < starts; ++i) {
        GpdmState first{components.leftCols(settings.dimensions), {}};
        if (i > 0)
            first = perturbed(first, components, random);
        const Progress part = progress.part(static_cast<double>(i) / starts, (i + 1.0) / starts);
        Start start(objective, spans, first, settings, part, watch);
        const GpdmStop stop = start.run(weights);
        std::vector<double> values = start.values();
        learning.finalObjectives.push_back(values.back());
        if (i == 0 || values.back() < learning.objective.back()) {
            learning.state = start.best();
            learning.objective = std::move(values);
            learning.stop = stop;
        }
        if (stop == GpdmStop::Cancelled) {
            learning.stop = stop;
            break;
        }
    }
    learning.activeBounds = hyperparametersAtBounds(learning.state.hyperparameters);
    objective.value(learning.state);
    learning.jitter = objective.jitter();
    return learning;
}

} // namespace quadrille
