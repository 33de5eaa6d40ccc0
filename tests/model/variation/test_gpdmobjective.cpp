// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/plainalgebra.h"
#include "tests/model/variation/plaingpdm.h"
#include "tests/model/variation/smoothmovement.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

using Parameter = double GpdmHyperparameters::*;
constexpr Parameter parameters[] = {&GpdmHyperparameters::alpha1, &GpdmHyperparameters::alpha2,
                                    &GpdmHyperparameters::alpha3, &GpdmHyperparameters::beta1,
                                    &GpdmHyperparameters::beta2,  &GpdmHyperparameters::beta3,
                                    &GpdmHyperparameters::beta4};

RowMatrix gramOf(const RowMatrix& rows)
{
    return rows * rows.transpose();
}

void expectClose(double value, double expected, double tolerance)
{
    EXPECT_NEAR(value, expected, tolerance * std::max(1.0, std::abs(expected)));
}

} // namespace

TEST(GpdmObjective, TwoFramesByHand)
{
    // y = (1, −1) in one coordinate; latents 0 and r with r² = 2·ln 2, so that the radial kernel is ½.
    // K_Y = (2 ½; ½ 2): |K_Y| = 3.75, K_Y⁻¹ = (2 −½; −½ 2)/3.75, tr(K_Y⁻¹·G) = 5/3.75 = 4/3.
    // K_X is of the latent 0 alone: β₁ + 0 + 1/β₄ = 3; X' = r.
    RowMatrix gram(2, 2);
    gram << 1, -1, -1, 1;
    const RowSpan span{0, 2};
    GpdmState state;
    state.latents.resize(2, 1);
    state.latents << 0, std::sqrt(2 * std::log(2));
    state.hyperparameters = {
        .alpha1 = 1, .alpha2 = 1, .alpha3 = 1, .beta1 = 1, .beta2 = 1, .beta3 = 1, .beta4 = 0.5};
    GpdmObjective objective(gram, 1, std::span(&span, 1));
    const double expected = 0.5 * std::log(3.75) + 0.5 * 4 / 3.0 + 0.5 * std::log(3) +
                            0.5 * 2 * std::log(2) / 3 + 0 + std::log(0.5);
    EXPECT_NEAR(objective.value(state), expected, 1e-14);
    EXPECT_EQ(objective.jitter(), 0);
}

TEST(GpdmObjective, ThreeFramesByHand)
{
    // Latents so far apart that the radial kernels are unit matrices; linear dynamics of latents 3 and 1000:
    // K_X = (1 + 9 + 1, 3000; 3000, 1 + 10⁶ + 1).
    RowMatrix rows(3, 2);
    rows << 1, 2, 3, 4, -4, -6;
    const RowSpan span{0, 3};
    GpdmState state;
    state.latents.resize(3, 1);
    state.latents << 3, 1000, -500;
    state.hyperparameters = {
        .alpha1 = 1, .alpha2 = 1, .alpha3 = 1, .beta1 = 1, .beta2 = 1, .beta3 = 1, .beta4 = 1};
    GpdmObjective objective(gramOf(rows), 2, std::span(&span, 1));
    // K_Y = 2·1: D/2·ln 8 + ¼·Σ y².
    const double poses = std::log(8) + 0.25 * (1 + 4 + 9 + 16 + 16 + 36);
    const double determinant = 11 * 1000002.0 - 9e6;
    const double quadratic = (1000002.0 * 1e6 + 2 * 3000 * 1000 * 500.0 + 11 * 250000.0) / determinant;
    const double dynamics = 0.5 * std::log(determinant) + 0.5 * quadratic;
    expectClose(objective.value(state), poses + dynamics + 4.5, 1e-12);
}

TEST(GpdmObjective, AgreesWithThePlainFormula)
{
    for (const int takes : {1, 3}) {
        for (const Eigen::Index frames : {2, 5, 23}) {
            const SmoothMovement movement = smoothMovement(takes, frames, 30, 4);
            const GpdmState state = randomState(takes * frames, 3, 7);
            GpdmObjective objective(gramOf(movement.rows), 30, movement.spans);
            GpdmObjective::Gradient gradient;
            GpdmObjective::Gradient plain;
            const double expected = plainObjective(movement.rows, movement.spans, state, &plain);
            expectClose(objective.value(state), expected, 1e-12);
            expectClose(objective.value(state, gradient), expected, 1e-12);
            EXPECT_LE((gradient.latents - plain.latents).norm(), 1e-10 * plain.latents.norm());
            for (const Parameter parameter : parameters)
                expectClose(gradient.hyperparameters.*parameter, plain.hyperparameters.*parameter, 1e-10);
        }
    }
}

TEST(GpdmObjective, GradientIsThatOfFiniteDifferences)
{
    for (const int dimensions : {1, 3, 4}) {
        const SmoothMovement movement = smoothMovement(2, 11, 40, 5);
        GpdmState state = randomState(22, dimensions, 11);
        GpdmObjective objective(gramOf(movement.rows), 40, movement.spans);
        GpdmObjective::Gradient gradient;
        objective.value(state, gradient);
        // Fourth order: the error is far below 1e-5 for steps that keep rounding far below it, too.
        const auto difference = [&](double& variable, double step) {
            const double middle = variable;
            const auto at = [&](double offset) {
                variable = middle + offset;
                return objective.value(state);
            };
            const double slope = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step);
            variable = middle;
            return slope;
        };
        for (Eigen::Index i = 0; i < state.latents.size(); ++i)
            expectClose(gradient.latents.data()[i], difference(state.latents.data()[i], 1e-3), 1e-5);
        for (const Parameter parameter : parameters) {
            double& variable = state.hyperparameters.*parameter;
            expectClose(gradient.hyperparameters.*parameter, difference(variable, 1e-3 * variable), 1e-5);
        }
    }
}

TEST(GpdmObjective, TurningTheLatentSpaceChangesNothing)
{
    const SmoothMovement movement = smoothMovement(2, 15, 30, 6);
    GpdmState state = randomState(30, 3, 3);
    GpdmObjective objective(gramOf(movement.rows), 30, movement.spans);
    GpdmObjective::Gradient gradient;
    const double value = objective.value(state, gradient);
    const Eigen::Matrix3d turn = singularVectors(randomState(3, 3, 9).latents).left;
    state.latents = state.latents * turn;
    GpdmObjective::Gradient turned;
    expectClose(objective.value(state, turned), value, 1e-12);
    EXPECT_LE((turned.latents - gradient.latents * turn).norm(), 1e-9 * gradient.latents.norm());
}

TEST(GpdmObjective, TheOrderOfSequencesChangesNothing)
{
    const SmoothMovement movement = smoothMovement(2, 9, 30, 6);
    const GpdmState state = randomState(18, 3, 3);
    GpdmState other = state;
    other.latents << state.latents.bottomRows(9), state.latents.topRows(9);
    RowMatrix rows(18, 30);
    rows << movement.rows.bottomRows(9), movement.rows.topRows(9);
    GpdmObjective first(gramOf(movement.rows), 30, movement.spans);
    GpdmObjective second(gramOf(rows), 30, movement.spans);
    expectClose(second.value(other), first.value(state), 1e-12);
    // One sequence instead of two is another matter: its dynamics cross the seam.
    const RowSpan whole{0, 18};
    GpdmObjective joined(gramOf(movement.rows), 30, std::span(&whole, 1));
    EXPECT_GT(std::abs(joined.value(state) - first.value(state)), 1e-3);
}

TEST(GpdmObjective, SingularKernelsAreFactorisedAndReported)
{
    // All frames identical and noise far below what double precision can hold beside the variance.
    const RowMatrix rows = RowMatrix::Zero(20, 12);
    const RowSpan span{0, 20};
    GpdmState state;
    state.latents = RowMatrix::Constant(20, 3, 0.5);
    state.hyperparameters = {
        .alpha1 = 1e6, .alpha2 = 1, .alpha3 = 1e14, .beta1 = 1e6, .beta2 = 1, .beta3 = 1e6, .beta4 = 1e14};
    GpdmObjective objective(gramOf(rows), 12, std::span(&span, 1));
    GpdmObjective::Gradient gradient;
    EXPECT_TRUE(std::isfinite(objective.value(state, gradient)));
    EXPECT_TRUE(gradient.latents.allFinite());
    EXPECT_GT(objective.jitter(), 0);
    EXPECT_LT(objective.jitter(), 1e-10);

    // At the bounds of learning they are not singular to double precision.
    state.hyperparameters.alpha3 = state.hyperparameters.beta4 = 1e6;
    const double value = objective.value(state, gradient);
    EXPECT_EQ(objective.jitter(), 0);
    EXPECT_TRUE(std::isfinite(value));

    state.latents(3, 1) = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(std::isinf(objective.value(state, gradient)));
    EXPECT_TRUE(gradient.latents.isZero());
}

TEST(GpdmObjective, FewerCoordinatesThanFramesAndConstantOnes)
{
    // The Gram matrix has rank 2 at most.
    SmoothMovement movement = smoothMovement(2, 10, 3, 8);
    movement.rows.col(1).setZero();
    const GpdmState state = randomState(20, 3, 3);
    GpdmObjective objective(gramOf(movement.rows), 3, movement.spans);
    GpdmObjective::Gradient gradient;
    GpdmObjective::Gradient plain;
    const double expected = plainObjective(movement.rows, movement.spans, state, &plain);
    expectClose(objective.value(state, gradient), expected, 1e-12);
    EXPECT_LE((gradient.latents - plain.latents).norm(), 1e-10 * plain.latents.norm());
}

TEST(GpdmObjective, IsExactWhereTheGramMatrixIsSingular)
{
    // Movements of six waves without noise, as poses that are laid onto each other nearly are: all but six of
    // the eigenvalues are rounding. A model that is as sure of poses as learned ones shows each error.
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SmoothMovement movement = smoothMovement(3, 40, 60, seed, 0);
        movement.rows = movement.rows.cast<float>().cast<double>();
        GpdmState state = randomState(movement.rows.rows(), 3, seed);
        state.latents *= 0.3;
        state.hyperparameters.alpha3 = 1e6;
        GpdmObjective objective(gramOf(movement.rows), 60, movement.spans);
        expectClose(objective.value(state), plainObjective(movement.rows, movement.spans, state), 1e-9);
        RowMatrix moved = movement.rows;
        moved(0, 0) += 1e-14;
        GpdmObjective nearby(gramOf(moved), 60, movement.spans);
        expectClose(nearby.value(state), objective.value(state), 1e-9);
    }
}
