// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/posereach.h"

#include "model/transition/nearestposes.h"
#include "model/variation/posespread.h"
#include "model/variation/samemovement.h"

#include <algorithm>
#include <iterator>

namespace quadrille {

namespace {

/// Deviations of the worst frames from a mean one.
constexpr double worstOfMean = 3;

/// Of the frames of a take the greatest distance from the nearest pose of some others.
double farthest(const Movement& movement, std::size_t take, std::span<const std::size_t> takes,
                const Progress& progress)
{
    std::vector<Positions> others;
    for (const std::size_t other : takes) {
        if (other != take)
            std::ranges::copy(movement.take(other).allPoses(), std::back_inserter(others));
    }
    double most = 0;
    for (const NearestPose& nearest : nearestPoses(movement.take(take).allPoses(), others, progress))
        most = std::max(most, nearest.distance);
    return most;
}

} // namespace

std::vector<double> poseReaches(const Movement& movement, const Progress& progress)
{
    const std::size_t count = movement.capturedCount();
    std::vector<double> reaches(count);
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t t = 0; t < count; ++t)
        groups.push_back(sameMovement(movement, t));
    for (std::size_t t = 0; t < count; ++t) {
        const std::vector<std::size_t>& group = groups[t];
        const double share = 1.0 / static_cast<double>(count);
        const Progress own =
            progress.part(share * static_cast<double>(t), share * static_cast<double>(t + 1));
        if (group.size() < 2) {
            reaches[t] = worstOfMean * shareOfOneTake * rangeOfMotion(movement.take(t));
            continue;
        }
        for (std::size_t i = 0; i < group.size(); ++i)
            reaches[t] += farthest(movement, group[i], group,
                                   own.part(static_cast<double>(i) / static_cast<double>(group.size()),
                                            static_cast<double>(i + 1) / static_cast<double>(group.size()))) /
                          static_cast<double>(group.size());
    }
    return reaches;
}

} // namespace quadrille
