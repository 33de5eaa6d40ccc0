// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/parametric/similarityerrors.h"
#include "tests/model/codeof.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A vertex that is share² away from where the other one stands.
MovingPose squaredPose(double share)
{
    return {{Vec3f(static_cast<float>(share * share), 0, 0)}, {Vec3f::Zero()}};
}

MovingPose standingPose(double /*share*/)
{
    return {{Vec3f::Zero()}, {Vec3f::Zero()}};
}

} // namespace

TEST(SimilarityErrors, OfASquareAreThoseOfItsChords)
{
    // A chord over h misses a square by h²/4 at most, in its middle; all values are floats that are exact.
    const std::vector<SimilarityError> errors = similarityErrors(squaredPose, standingPose, {.samples = 17});
    ASSERT_EQ(errors.size(), 3U);
    EXPECT_NEAR(errors[0].greatest, 25, 1e-12);
    EXPECT_NEAR(errors[1].greatest, 6.25, 1e-12);
    EXPECT_NEAR(errors[2].greatest, 1.5625, 1e-12);
    EXPECT_NEAR(errors[0].mean, 15.625, 1e-12); // Σ (k/16 − k²/256) / 17
    EXPECT_EQ(errors[2].bisections, 2);
    const std::vector<SimilarityError> turned = similarityErrors(standingPose, squaredPose, {.samples = 17});
    EXPECT_NEAR(turned[1].mean, errors[1].mean, 1e-12);
}

TEST(SimilarityErrors, CountVelocitiesByTheirWeight)
{
    const auto moving = [](double share) {
        return MovingPose{{Vec3f(static_cast<float>(share), 0, 0)},
                          {Vec3f(static_cast<float>(share * share), 0, 0)}};
    };
    // share + w·share²: the square is w / (1 + w) of the range.
    const SimilarityErrorSettings settings{.mostBisections = 0, .samples = 17, .velocityWeight = 3};
    EXPECT_NEAR(similarityErrors(moving, standingPose, settings)[0].greatest, 25 * 0.75, 1e-12);
}

TEST(SimilarityErrors, AreNoneWhereNothingChanges)
{
    for (const SimilarityError& error : similarityErrors(standingPose, standingPose)) {
        EXPECT_EQ(error.mean, 0);
        EXPECT_EQ(error.greatest, 0);
    }
}

TEST(SimilarityErrors, StopWhenTheyAreCancelled)
{
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { similarityErrors(standingPose, standingPose, {}, Progress(token)); }),
              ErrorCode::Cancelled);
}
