// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/gpdmvariables.h"
#include "tests/model/codeof.h"
#include "tests/model/plainalgebra.h"
#include "tests/model/variation/plaingpdm.h"
#include "tests/model/variation/smoothmovement.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <numeric>
#include <stdexcept>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Root of the mean squared coordinate of what the mean prediction at the latents leaves.
double predictionError(const SmoothMovement& movement, const GpdmState& state)
{
    RowMatrix kernel = plainPoseKernel(state.latents, state.hyperparameters);
    const RowMatrix weights = solutionOf(kernel, movement.rows);
    kernel.diagonal().array() -= 1 / state.hyperparameters.alpha3;
    return std::sqrt((kernel * weights - movement.rows).squaredNorm() /
                     static_cast<double>(movement.rows.size()));
}

double principalError(const SmoothMovement& movement, int dimensions)
{
    const Eigen::VectorXd values = singularVectors(movement.rows).values;
    return std::sqrt(values.tail(values.size() - dimensions).squaredNorm() /
                     static_cast<double>(movement.rows.size()));
}

/// Changes of steps in steps: √2 where each step goes anywhere, small where they go on.
double roughness(const GpdmState& state, std::span<const RowSpan> spans)
{
    double changes = 0;
    double steps = 0;
    for (const RowSpan& span : spans) {
        for (Eigen::Index i = span.first + 1; i < span.last(); ++i) {
            const Eigen::RowVectorXd after = state.latents.row(i + 1) - state.latents.row(i);
            const Eigen::RowVectorXd before = state.latents.row(i) - state.latents.row(i - 1);
            changes += (after - before).squaredNorm();
            steps += after.squaredNorm();
        }
    }
    return std::sqrt(changes / steps);
}

void expectSensible(const GpdmLearning& learning)
{
    EXPECT_TRUE(learning.state.latents.allFinite());
    EXPECT_TRUE(std::isfinite(learning.objective.back()));
    EXPECT_LE(learning.objective.back(), learning.objective.front());
    EXPECT_NE(learning.stop, GpdmStop::IterationLimit);
}

} // namespace

TEST(PrincipalLatents, AreTheScoresOfUnitVariance)
{
    const SmoothMovement movement = smoothMovement(2, 20, 30, 1);
    const RowMatrix latents = principalLatents(gramMatrix(movement.rows), 3);
    const SingularVectors svd = singularVectors(movement.rows);
    const double scale = std::sqrt(40.0) / svd.values[0];
    for (int c = 0; c < 3; ++c) {
        const Eigen::VectorXd scores = scale * svd.values[c] * svd.left.col(c);
        EXPECT_NEAR(std::abs(latents.col(c).dot(scores)), scores.squaredNorm(), 1e-9);
        EXPECT_EQ(latents.col(c).maxCoeff(), latents.col(c).cwiseAbs().maxCoeff());
    }
    EXPECT_NEAR(latents.col(0).squaredNorm() / 40, 1, 1e-12);
    EXPECT_TRUE(principalLatents(RowMatrix::Zero(5, 5), 3).isZero());
    // There are no more components than frames.
    EXPECT_TRUE(principalLatents(RowMatrix::Identity(2, 2), 3).col(2).isZero());
}

TEST(GpdmVariables, GoBackAndForthAndPassDerivativesOn)
{
    const SmoothMovement movement = smoothMovement(2, 6, 20, 2);
    const GpdmState state = randomState(12, 2, 5);
    for (const double smoothness : {0.0, 3.0}) {
        const GpdmVariables variables(movement.spans, 2, smoothness);
        ASSERT_EQ(variables.count(), 30);
        Eigen::VectorXd values(30);
        variables.write(state, values.data());
        const GpdmState back = variables.read(values.data());
        EXPECT_LE((back.latents - state.latents).norm(), 1e-12);
        EXPECT_NEAR(back.hyperparameters.beta4 / state.hyperparameters.beta4, 1, 1e-12);

        const RowMatrix gram = gramMatrix(movement.rows);
        GpdmObjective objective(gram, 20, movement.spans);
        GpdmState same = state;
        same.hyperparameters.alpha2 = 1;
        GpdmObjective::Gradient gradient;
        objective.value(same, gradient);
        Eigen::VectorXd derivatives(30);
        variables.writeGradient(same, gradient, derivatives.data());
        for (Eigen::Index i = 0; i < 30; ++i) {
            const auto at = [&](double offset) {
                Eigen::VectorXd moved = values;
                moved(i) += offset;
                return objective.value(variables.read(moved.data()));
            };
            const double slope = (8 * (at(1e-3) - at(-1e-3)) - (at(2e-3) - at(-2e-3))) / 12e-3;
            EXPECT_NEAR(derivatives(i), slope, 1e-5 * std::max(1.0, std::abs(slope)));
        }
    }
}

TEST(GpdmVariables, AreSmoothWhereTheyAreStraight)
{
    // A straight line has no second differences but those at its ends.
    const RowSpan span{0, 5};
    GpdmState state;
    state.latents.resize(5, 1);
    state.latents << 1, 2, 3, 4, 5;
    Eigen::VectorXd values(11);
    GpdmVariables(std::span(&span, 1), 1, 10).write(state, values.data());
    EXPECT_THAT(std::vector<double>(values.data(), values.data() + 5),
                ::testing::ElementsAre(-9, 2, 3, 4, 15));
}

TEST(GpdmVariables, HyperparametersNearBoundsAreNamed)
{
    GpdmHyperparameters parameters;
    EXPECT_TRUE(hyperparametersAtBounds(parameters).empty());
    parameters.alpha3 = 0.9999e6;
    parameters.beta3 = 1.0001e-6;
    parameters.beta1 = 1e5;
    EXPECT_THAT(hyperparametersAtBounds(parameters), ::testing::ElementsAre("alpha3", "beta3"));
}

TEST(GpdmLearning, FindsWhatPrincipalComponentsCannot)
{
    const SmoothMovement movement = smoothMovement(3, 30, 120, 3);
    const GpdmLearning learning = learnGpdm(movement.rows, movement.spans, {});
    EXPECT_EQ(learning.stop, GpdmStop::Converged);
    EXPECT_EQ(learning.jitter, 0);
    const double prediction = predictionError(movement, learning.state);
    EXPECT_LT(prediction, 0.5 * principalError(movement, 3));
    // The noise is 1 mm; more is not explained by it, less would be made up.
    EXPECT_NEAR(1 / std::sqrt(learning.state.hyperparameters.alpha3), 0.001, 0.0003);
    EXPECT_LT(roughness(learning.state, movement.spans), 0.8);
    const double plain = plainObjective(movement.rows, movement.spans, learning.state);
    EXPECT_NEAR(learning.objective.back(), plain, 1e-9 * std::abs(plain));
    const std::size_t count = learning.objective.size();
    const double last = learning.objective[count - 1];
    EXPECT_LT(learning.objective[count - 11] - last, 1e-6 * std::abs(last));
    EXPECT_EQ(last, *std::min_element(learning.objective.begin(), learning.objective.end()));
    EXPECT_EQ(learning.state.hyperparameters.alpha2, 1);
}

TEST(GpdmLearning, PerturbedStartsAgreeWithinTwoPercent)
{
    const SmoothMovement movement = smoothMovement(3, 30, 120, 4);
    std::vector<double> finals;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        const GpdmLearning learning = learnGpdm(movement.rows, movement.spans, {.restarts = 1, .seed = seed});
        EXPECT_EQ(learning.stop, GpdmStop::Converged);
        ASSERT_EQ(learning.finalObjectives.size(), 2U);
        EXPECT_EQ(learning.objective.back(),
                  std::min(learning.finalObjectives[0], learning.finalObjectives[1]));
        // The first start is the same for every seed: what seeds change is the second.
        finals.push_back(learning.finalObjectives[1]);
    }
    const auto [least, greatest] = std::minmax_element(finals.begin(), finals.end());
    EXPECT_GT(*greatest, *least) << "or nothing is compared";
    EXPECT_LT(*greatest - *least, 0.02 * std::abs(*least));
}

TEST(GpdmLearning, TheSameSeedGivesTheSameModel)
{
    const SmoothMovement movement = smoothMovement(2, 15, 40, 5);
    const GpdmSettings settings{.restarts = 1, .seed = 9};
    const GpdmLearning first = learnGpdm(movement.rows, movement.spans, settings);
    const GpdmLearning second = learnGpdm(movement.rows, movement.spans, settings);
    EXPECT_EQ(first.state.latents, second.state.latents);
    EXPECT_EQ(first.state.hyperparameters, second.state.hyperparameters);
    EXPECT_EQ(first.objective, second.objective);
    const GpdmLearning other = learnGpdm(movement.rows, movement.spans, {.restarts = 1, .seed = 10});
    EXPECT_NE(first.finalObjectives[1], other.finalObjectives[1]);
}

TEST(GpdmLearning, IsWatchedAtEachIteration)
{
    const SmoothMovement movement = smoothMovement(2, 15, 40, 5);
    std::vector<double> told;
    GpdmState last;
    double fraction = 0;
    const Progress progress(CancelToken(), [&fraction](double done) { fraction = done; });
    const GpdmLearning learning = learnGpdm(movement.rows, movement.spans, {.restarts = 0}, progress,
                                            [&](int iteration, double objective, const GpdmState& state) {
                                                told.push_back(objective);
                                                EXPECT_EQ(iteration, static_cast<int>(told.size()));
                                                last = state;
                                            });
    ASSERT_EQ(told.size() + 1, learning.objective.size());
    EXPECT_TRUE(std::equal(told.begin(), told.end(), learning.objective.begin() + 1));
    EXPECT_EQ(last.latents, learning.state.latents);
    EXPECT_GT(fraction, 0);
}

TEST(GpdmLearning, CancelledKeepsTheBestSoFar)
{
    const SmoothMovement movement = smoothMovement(2, 15, 40, 5);
    CancelToken token;
    std::vector<double> told;
    const GpdmLearning learning = learnGpdm(movement.rows, movement.spans, {}, Progress(token),
                                            [&](int iteration, double objective, const GpdmState&) {
                                                told.push_back(objective);
                                                if (iteration == 25)
                                                    token.cancel();
                                            });
    EXPECT_EQ(learning.stop, GpdmStop::Cancelled);
    EXPECT_EQ(told.size(), 25U);
    EXPECT_EQ(learning.objective.back(), *std::min_element(told.begin(), told.end()));
    const double plain = plainObjective(movement.rows, movement.spans, learning.state);
    EXPECT_NEAR(learning.objective.back(), plain, 1e-9 * std::abs(plain));

    // Before there are any latents, there is nothing to keep.
    EXPECT_EQ(codeOf([&] { learnGpdm(movement.rows, movement.spans, {}, Progress(token)); }),
              ErrorCode::Cancelled);
}

TEST(GpdmLearning, TellsThatTheLimitStoppedIt)
{
    const SmoothMovement movement = smoothMovement(2, 15, 40, 5);
    const GpdmLearning learning =
        learnGpdm(movement.rows, movement.spans, {.restarts = 0, .greatestIterations = 30});
    EXPECT_EQ(learning.stop, GpdmStop::IterationLimit);
    EXPECT_LE(learning.objective.size(), 31U);
}

TEST(GpdmLearning, ThrowsOnWhatTheWatchThrows)
{
    const SmoothMovement movement = smoothMovement(1, 15, 40, 5);
    const GpdmWatch watch = [](int, double, const GpdmState&) { throw std::runtime_error("enough"); };
    EXPECT_THROW(learnGpdm(movement.rows, movement.spans, {}, {}, watch), std::runtime_error);
}

TEST(GpdmLearning, RefusesWhatCannotBeLearned)
{
    const SmoothMovement movement = smoothMovement(2, 5, 6, 1);
    const auto learn = [](const RowMatrix& rows, std::vector<RowSpan> spans, GpdmSettings settings = {}) {
        return codeOf([&] { learnGpdm(rows, spans, settings); });
    };
    EXPECT_EQ(learn(movement.rows, {{0, 8}, {8, 2}}), ErrorCode::BadArgument);
    EXPECT_EQ(learn(movement.rows, {{0, 5}}), ErrorCode::BadArgument);
    EXPECT_EQ(learn(movement.rows, {{1, 5}, {6, 4}}), ErrorCode::BadArgument);
    EXPECT_EQ(learn(movement.rows, {}), ErrorCode::BadArgument);
    EXPECT_EQ(learn(movement.rows.topRows(3), {{0, 3}}), ErrorCode::BadArgument);
    EXPECT_EQ(learn(movement.rows.leftCols(0), movement.spans), ErrorCode::BadArgument);
    EXPECT_EQ(learn(movement.rows, movement.spans, {.dimensions = 0}), ErrorCode::BadArgument);
    RowMatrix broken = movement.rows;
    broken(4, 5) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(learn(broken, movement.spans), ErrorCode::NonFiniteCoordinate);
}

TEST(GpdmLearning, DegenerateMovementsGiveSensibleModels)
{
    // Three frames; a take of three among longer ones; fewer coordinates than frames; a constant coordinate.
    const SmoothMovement few = smoothMovement(1, 4, 30, 1);
    expectSensible(learnGpdm(few.rows, few.spans, {}));
    const SmoothMovement three = smoothMovement(1, 3, 30, 1);
    expectSensible(learnGpdm(three.rows, three.spans, {.dimensions = 2}));
    const SmoothMovement mixed = smoothMovement(1, 20, 30, 2);
    const std::vector<RowSpan> spans{{0, 3}, {3, 17}};
    expectSensible(learnGpdm(mixed.rows, spans, {}));
    SmoothMovement narrow = smoothMovement(2, 20, 6, 3);
    expectSensible(learnGpdm(narrow.rows, narrow.spans, {}));
    narrow.rows.col(2).setZero();
    expectSensible(learnGpdm(narrow.rows, narrow.spans, {}));
    SmoothMovement one = smoothMovement(2, 20, 1, 3);
    expectSensible(learnGpdm(one.rows, one.spans, {}));
}

TEST(GpdmLearning, IdenticalFramesGiveAModelThatStandsStill)
{
    const SmoothMovement movement = smoothMovement(2, 10, 12, 6);
    const RowMatrix still = RowMatrix::Zero(20, 12);
    const GpdmLearning learning = learnGpdm(still, movement.spans, {});
    expectSensible(learning);
    EXPECT_LT(predictionError({still, movement.spans}, learning.state), 1e-12);
    // Two takes that are the same.
    SmoothMovement twice = movement;
    twice.rows.bottomRows(10) = twice.rows.topRows(10);
    expectSensible(learnGpdm(twice.rows, twice.spans, {}));
}

TEST(GpdmLearning, TakesAThousandFrames)
{
    const SmoothMovement movement = smoothMovement(10, 100, 60, 7);
    const GpdmLearning learning =
        learnGpdm(movement.rows, movement.spans, {.restarts = 0, .greatestIterations = 3});
    EXPECT_EQ(learning.stop, GpdmStop::IterationLimit);
    EXPECT_LT(learning.objective.back(), learning.objective.front());
    EXPECT_TRUE(learning.state.latents.allFinite());
}
