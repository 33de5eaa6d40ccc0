// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/variation/reconstructionerror.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

// Two frames of one vertex, y = ±(3, 4, 0), far apart in latent space: Ŷ = Y·α₁/(α₁ + 1/α₃) = Y/2, so that
// each is off by 2.5.
TEST(ReconstructionError, ofAModelIsThatWorkedOutByHand)
{
    RowMatrix rows(2, 3);
    rows << 3, 4, 0, -3, -4, 0;
    GpdmState state{.latents = RowMatrix(2, 1), .hyperparameters = {.alpha1 = 2, .alpha3 = 0.5}};
    state.latents << -50, 50;
    EXPECT_NEAR(modelError(state, rows, 1), 2.5, 1e-6);
}

// Two vertices that move in three directions at right angles with sizes 5, 3 and 1: two components leave the
// last one.
TEST(ReconstructionError, ofPrincipalComponentsIsWhatTheyLeave)
{
    RowMatrix rows = RowMatrix::Zero(6, 6);
    rows(0, 0) = 5;
    rows(1, 0) = -5;
    rows(2, 1) = 3;
    rows(3, 1) = -3;
    rows(4, 5) = 1;
    rows(5, 5) = -1;
    EXPECT_NEAR(principalError(rows, 3, 2), 0, 1e-12);
    EXPECT_NEAR(principalError(rows, 2, 2), 2.0 / 12, 1e-12);
    EXPECT_NEAR(principalError(rows, 1, 2), 8.0 / 12, 1e-12);
    EXPECT_NEAR(principalError(rows, 2, 1), 0, 1e-12);
    EXPECT_NEAR(principalError(rows, 9, 2), 0, 1e-12);
}

TEST(ReconstructionError, isNothingWithoutVertices)
{
    const RowMatrix rows = normals(6, 6, 1);
    EXPECT_EQ(principalError(rows, 2, 0), 0);
    EXPECT_EQ(modelError(latentLoops(1, 6).state, rows, 0), 0);
}
