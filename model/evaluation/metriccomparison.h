// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/evaluation/jointangledistance.h"

#include <string>
#include <vector>

namespace quadrille {

/// How well pose distances go with reference distances.
struct MetricCorrelation
{
    double pearson = 0;
    double distance = 0; ///< distance correlation
};

/// A row of SMCAS Table 1.
struct MetricComparisonRow
{
    JointAngleMetric reference = JointAngleMetric::EulerAngles;
    MetricCorrelation euclidean;
    MetricCorrelation surface;
};

/// What a single joint has to do with it; by wrapped Euler angles.
struct JointShare
{
    std::string joint;
    double meanDifference = 0; ///< over all pairs, radians
    double share = 0;          ///< of the sum of all squared reference distances
    double euclideanPearson = 0;
    double surfacePearson = 0;
};

struct MetricComparison
{
    std::int64_t frames = 0;
    std::int64_t pairs = 0; ///< of different frames, each once
    std::vector<MetricComparisonRow> rows;
    std::vector<JointShare> joints;
};

/// Correlates pose distances with the distances of reference joint angles, over all pairs of frames (SMCAS
/// §3.1, Table 1).
/// \param euclidean, surface  frames × frames, of the frames of `angles`.
/// \throws Error Cancelled. Cost: O(frames² · (joints + log frames)).
MetricComparison compareMetrics(const JointAngles& angles, TableView<float> euclidean,
                                TableView<float> surface, const Progress& progress = {});

} // namespace quadrille
