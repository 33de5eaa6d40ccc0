// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/metriccomparison.h"

#include "model/evaluation/correlation.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace quadrille {

namespace {

/// The values of all pairs, each once.
std::vector<double> pairsOf(TableView<float> table)
{
    std::vector<double> pairs;
    pairs.reserve(static_cast<std::size_t>(table.size()) / 2);
    for (Eigen::Index i = 0; i < table.rows(); ++i) {
        for (Eigen::Index j = i + 1; j < table.cols(); ++j)
            pairs.push_back(static_cast<double>(table(i, j)));
    }
    return pairs;
}

double sumOfSquares(const std::vector<double>& values)
{
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

} // namespace

MetricComparison compareMetrics(const JointAngles& angles, TableView<float> euclidean,
                                TableView<float> surface, const Progress& progress)
{
    assert(euclidean.rows() == angles.frameCount && surface.rows() == angles.frameCount);
    const std::vector<double> byVertices = pairsOf(euclidean);
    const std::vector<double> bySurface = pairsOf(surface);
    MetricComparison comparison{.frames = angles.frameCount,
                                .pairs = static_cast<std::int64_t>(bySurface.size())};
    double done = 0;
    const auto correlate = [&](const std::vector<double>& reference, const std::vector<double>& distances) {
        const MetricCorrelation correlation{
            .pearson = pearsonCorrelation(reference, distances),
            .distance = distanceCorrelation(reference, distances, progress.part(done, done + 0.2))};
        done += 0.2;
        return correlation;
    };
    double squares = 0;
    for (const JointAngleMetric metric : {JointAngleMetric::EulerAngles, JointAngleMetric::Rotations}) {
        const std::vector<double> reference = pairsOf(jointAngleDistances(angles, metric));
        if (metric == JointAngleMetric::EulerAngles)
            squares = sumOfSquares(reference);
        MetricComparisonRow row{.reference = metric};
        row.euclidean = correlate(reference, byVertices);
        row.surface = correlate(reference, bySurface);
        comparison.rows.push_back(row);
    }
    for (std::size_t joint = 0; joint < angles.joints.size(); ++joint) {
        progress.report(0.8 + 0.2 * static_cast<double>(joint) / static_cast<double>(angles.joints.size()));
        const auto own = pairsOf(jointAngleDistances(selectJoints(angles, {&joint, 1})));
        const double sum = std::accumulate(own.begin(), own.end(), 0.0);
        comparison.joints.push_back(
            {.joint = angles.joints[joint],
             .meanDifference = sum / static_cast<double>(std::max<std::size_t>(own.size(), 1)),
             .share = squares > 0 ? sumOfSquares(own) / squares : 0,
             .euclideanPearson = pearsonCorrelation(own, byVertices),
             .surfacePearson = pearsonCorrelation(own, bySurface)});
    }
    return comparison;
}

} // namespace quadrille
