// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/cycles.h"

#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

double meanAtLag(const Table<float>& distances, Eigen::Index lag)
{
    const Eigen::Index pairs = distances.rows() - lag;
    double sum = 0;
    for (Eigen::Index i = 0; i < pairs; ++i)
        sum += distances(i, i + lag);
    return sum / static_cast<double>(pairs);
}

} // namespace

std::optional<std::int64_t> findPeriod(const Table<float>& distances, double greatestReturn)
{
    const Eigen::Index frames = distances.rows();
    std::vector<double> means{0};
    for (Eigen::Index lag = 1; lag < frames; ++lag)
        means.push_back(meanAtLag(distances, lag));
    double largest = 0;
    for (std::size_t lag = 1; lag + 1 < means.size(); ++lag) {
        const bool isLeast = means[lag] < means[lag - 1] && means[lag] <= means[lag + 1];
        const bool isSeen = 5 * (static_cast<std::size_t>(frames) - lag) >= lag;
        if (isLeast && isSeen && means[lag] <= greatestReturn * largest)
            return static_cast<std::int64_t>(lag);
        largest = std::max(largest, means[lag]);
    }
    return std::nullopt;
}

std::optional<CycleMatch> matchCycle(const Table<float>& costs, const WarpSteps& steps)
{
    Table<float> closed(costs.rows() + 1, costs.cols());
    closed.topRows(costs.rows()) = costs;
    closed.bottomRows(1) = costs.topRows(1);
    std::optional<WarpPathResult> found = warpWithin(closed, steps);
    if (!found)
        return std::nullopt;
    CycleMatch match{.path = std::move(found->path), .meanCost = 0};
    match.meanCost = found->cost / static_cast<double>(match.path.size());
    while (match.path.back().reference == costs.rows())
        match.path.pop_back();
    return match;
}

std::int64_t chooseCycleStart(std::span<const Table<float>> costs, std::int64_t period,
                              std::int64_t referenceFrames, const WarpSteps& steps)
{
    std::int64_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t start = 0; start + period <= referenceFrames; ++start) {
        double sum = 0;
        for (const Table<float>& table : costs) {
            const std::optional<CycleMatch> match = matchCycle(table.middleRows(start, period), steps);
            // A take that is too short for any cycle weighs the same wherever the cycle begins.
            sum += match ? match->meanCost / std::max(double{table.mean()}, 1e-12) : 1;
        }
        if (sum < least) {
            least = sum;
            best = start;
        }
    }
    return best;
}

} // namespace quadrille
