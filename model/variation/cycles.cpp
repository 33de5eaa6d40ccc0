// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/cycles.h"

#include <algorithm>
#include <limits>
#include <tbb/parallel_for.h>

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

/// Greatest distance of so many frames from each other.
double rangeOf(const Table<float>& distances, Eigen::Index first, Eigen::Index count)
{
    return double{distances.block(first, first, count, count).maxCoeff()};
}

/// What the greatest distances of so many frames from each other are in the mean, over the whole take.
double meanRange(const Table<float>& distances, Eigen::Index count)
{
    constexpr Eigen::Index mostWindows = 32;
    const Eigen::Index last = distances.rows() - count;
    const Eigen::Index windows = std::min(last + 1, mostWindows);
    double sum = 0;
    for (Eigen::Index w = 0; w < windows; ++w)
        sum += rangeOf(distances, windows > 1 ? w * last / (windows - 1) : 0, count);
    return sum / static_cast<double>(windows);
}

/// Whether the frames that are seen twice move each time as the take does, or at least this share of it:
/// standing before a jump and after it is no repetition.
bool movesAtLag(const Table<float>& distances, Eigen::Index lag)
{
    constexpr double leastShare = 0.25; // real gaits 0.43 – 1.28
    const Eigen::Index pairs = distances.rows() - lag;
    return std::min(rangeOf(distances, 0, pairs), rangeOf(distances, lag, pairs)) >=
           leastShare * meanRange(distances, pairs);
}

/// What comes back has moved in the meantime: the ends of a cycle may differ by this share of the greatest
/// distance of its frames from each other.
constexpr double greatestShareOfRange = 0.4;

/// A block of costs, in frames of both takes.
struct Block
{
    Eigen::Index firstRow = 0;
    Eigen::Index rows = 0;
    Eigen::Index firstColumn = 0;
    Eigen::Index columns = 0;
};

/// The least sum over a path from corner to corner of a block, without a limit of the slope, per frame of the
/// longer side.
double matchCost(const Table<float>& costs, const Block& block)
{
    std::vector<double> sums(static_cast<std::size_t>(block.columns) + 1,
                             std::numeric_limits<double>::infinity());
    for (Eigen::Index r = 0; r < block.rows; ++r) {
        double diagonal = r == 0 ? 0 : std::numeric_limits<double>::infinity();
        for (Eigen::Index c = 0; c < block.columns; ++c) {
            double& sum = sums[static_cast<std::size_t>(c) + 1];
            const double above = sum;
            sum = std::min({diagonal, above, sums[static_cast<std::size_t>(c)]}) +
                  costs(block.firstRow + r, block.firstColumn + c);
            diagonal = above;
        }
    }
    return sums.back() / static_cast<double>(std::max(block.rows, block.columns));
}

/// The least value of a function of 0 … count − 1: tried at so many places at most, then near the best.
/// \return its place and the value; the first of equal ones.
template <typename Function>
std::pair<std::int64_t, double> leastOf(std::int64_t count, std::int64_t tries, const Function& function)
{
    const std::int64_t stride = (count + tries - 1) / tries;
    std::pair<std::int64_t, double> best{0, std::numeric_limits<double>::infinity()};
    const auto look = [&](std::int64_t first, std::int64_t last, std::int64_t step) {
        std::vector<double> values(static_cast<std::size_t>((last - first) / step) + 1);
        tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
            values[i] = function(first + static_cast<std::int64_t>(i) * step);
        });
        const auto least = std::min_element(values.begin(), values.end());
        const std::int64_t place = first + (least - values.begin()) * step;
        if (*least < best.second || (*least == best.second && place < best.first))
            best = {place, *least};
    };
    look(0, count - 1, stride);
    if (stride > 1)
        look(std::max<std::int64_t>(best.first - stride + 1, 0), std::min(best.first + stride, count) - 1, 1);
    return best;
}

/// The window of a take that matches rows of the reference best, and its cost.
std::pair<std::int64_t, double> bestWindow(const Table<float>& costs, std::int64_t firstRow,
                                           std::int64_t rows, std::int64_t period)
{
    constexpr std::int64_t greatestWindows = 64;
    return leastOf(costs.cols() - period + 1, greatestWindows, [&](std::int64_t first) {
        return matchCost(costs, {firstRow, rows, first, period});
    });
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
        if (isLeast && isSeen && means[lag] <= greatestReturn * largest &&
            movesAtLag(distances, static_cast<Eigen::Index>(lag)))
            return static_cast<std::int64_t>(lag);
        largest = std::max(largest, means[lag]);
    }
    return std::nullopt;
}

std::int64_t chooseCycleStart(std::span<const CycleTake> takes, std::int64_t period,
                              std::int64_t referenceFrames, const Progress& progress)
{
    constexpr std::int64_t greatestStarts = 32;
    const auto mismatch = [&](std::int64_t start) {
        progress.report(0);
        double sum = 0;
        for (const CycleTake& take : takes) {
            const Table<float>& costs = *take.costs;
            const double cost = take.period ? bestWindow(costs, start, period, *take.period).second
                                            : matchCost(costs, {start, period, 0, costs.cols()});
            sum += cost / std::max(double{costs.mean()}, std::numeric_limits<double>::min());
        }
        return sum;
    };
    return leastOf(referenceFrames - period + 1, greatestStarts, mismatch).first;
}

FrameRange cycleWindow(const Table<float>& costs, std::int64_t period)
{
    const std::int64_t first = bestWindow(costs, 0, costs.rows(), period).first;
    return {FrameIndex(first), FrameIndex(first + period - 1)};
}

std::optional<FrameRange> cycleWithin(const Table<float>& toReference, const Table<float>& own,
                                      const WarpSteps& steps, double greatestMatch, double greatestReturn)
{
    // With its first frame again behind it the cycle ends where it comes back, not a little before.
    Table<float> closed(toReference.rows() + 1, toReference.cols());
    closed.topRows(toReference.rows()) = toReference;
    closed.bottomRows(1) = toReference.topRows(1);
    const std::optional<WarpPathResult> found = warpWithin(closed, steps);
    if (!found)
        return std::nullopt;
    const int first = found->path.front().take;
    const int next = found->path.back().take;
    const bool matches = found->meanCost() <= greatestMatch * static_cast<double>(toReference.mean());
    const double apart = own(first, next);
    const bool returns = apart <= greatestReturn * double{own.mean()} &&
                         apart <= greatestShareOfRange * rangeOf(own, first, next - first + 1);
    // Nobody walks at less than half the tempo of the reference, or at more than twice.
    const std::int64_t count = next - first;
    const bool keepsTempo = 2 * count >= toReference.rows() && count <= 2 * toReference.rows();
    if (!matches || !returns || !keepsTempo)
        return std::nullopt;
    return FrameRange{FrameIndex(first), FrameIndex(next - 1)};
}

} // namespace quadrille
