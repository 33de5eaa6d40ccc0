// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/transfererrors.h"

#include <gtest/gtest.h>
#include <vector>

using namespace quadrille;

TEST(TransferErrors, KnowWhereTheBodyIsAndHowItStands)
{
    const std::vector<Vec3f> truth{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}};
    std::vector<Vec3f> made = truth;
    for (Vec3f& p : made)
        p += Vec3f(3, 0, 4);
    TransferErrors errors = transferErrors(made, truth);
    EXPECT_NEAR(errors.moved.worst, 0, 1e-6);
    EXPECT_NEAR(errors.placed.mean, 5, 1e-6);
    EXPECT_NEAR(errors.placed.worst, 5, 1e-6);

    // One vertex is off, which moves the mean by a quarter of that.
    made = truth;
    made[2].z() = 0.4F;
    errors = transferErrors(made, truth);
    EXPECT_NEAR(errors.placed.mean, 0.1, 1e-6);
    EXPECT_NEAR(errors.placed.worst, 0.4, 1e-6);
    EXPECT_NEAR(errors.moved.mean, 0.15, 1e-6);
    EXPECT_NEAR(errors.moved.worst, 0.3, 1e-6);
}
