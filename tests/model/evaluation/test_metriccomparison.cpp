// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/metriccomparison.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace quadrille;

namespace {

/// One joint bends evenly, the other to and fro.
JointAngles bending(std::int64_t frames)
{
    JointAngles angles{.joints = {"bends", "sways"}, .fps = 30, .frameCount = frames, .angles = {}};
    for (std::int64_t f = 0; f < frames; ++f)
        angles.angles.insert(angles.angles.end(), {0.1 * static_cast<double>(f), 0, 0, 0,
                                                   0.03 * std::sin(static_cast<double>(f)), 0});
    return angles;
}

} // namespace

TEST(MetricComparison, AMetricThatIsTheReferenceCorrelatesFully)
{
    const JointAngles angles = bending(12);
    const Table<float> reference = jointAngleDistances(angles);
    const Table<float> squared = reference.square();
    const MetricComparison comparison = compareMetrics(angles, squared, Table<float>(2 * reference));
    EXPECT_EQ(comparison.frames, 12);
    EXPECT_EQ(comparison.pairs, 66);
    ASSERT_EQ(comparison.rows.size(), 2U);
    EXPECT_NEAR(comparison.rows[0].surface.pearson, 1, 1e-6);
    EXPECT_NEAR(comparison.rows[0].surface.distance, 1, 1e-6);
    EXPECT_LT(comparison.rows[0].euclidean.pearson, 0.99);
    EXPECT_LT(comparison.rows[0].euclidean.distance, 0.999);
}

TEST(MetricComparison, JointsShareTheSquaredDistance)
{
    const JointAngles angles = bending(5);
    const Table<float> reference = jointAngleDistances(angles);
    const MetricComparison comparison = compareMetrics(angles, reference, reference);
    ASSERT_EQ(comparison.joints.size(), 2U);
    EXPECT_EQ(comparison.joints[0].joint, "bends");
    EXPECT_NEAR(comparison.joints[0].share + comparison.joints[1].share, 1, 1e-6);
    // Ten pairs: 4 one frame apart, 3 two, 2 three and 1 four.
    EXPECT_NEAR(comparison.joints[0].meanDifference, 0.1 * (4 * 1 + 3 * 2 + 2 * 3 + 1 * 4) / 10, 1e-7);
    EXPECT_GT(comparison.joints[0].surfacePearson, comparison.joints[1].surfacePearson);
}
