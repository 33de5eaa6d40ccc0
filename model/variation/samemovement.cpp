// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/samemovement.h"

#include <algorithm>

namespace quadrille {

namespace {

/// Walks of one person, slow and fast, are 0.5 to 0.9 apart, runs and jumps 0.5, a jog and a run 0.96, a walk
/// and a run 1.9.
constexpr double greatestDistance = 0.92;

double meanDistance(std::span<const Vec3f> a, std::span<const Vec3f> b)
{
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        sum += static_cast<double>((a[v] - b[v]).norm());
    return sum / static_cast<double>(std::max<std::size_t>(a.size(), 1));
}

} // namespace

double rangeOfMotion(const AlignedTake& take)
{
    const std::size_t frames = take.placements.size();
    const std::size_t vertices = take.poses.size() / frames;
    double sum = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        Vec3d mean = Vec3d::Zero();
        for (std::size_t f = 0; f < frames; ++f)
            mean += take.poses[f * vertices + v].cast<double>() / static_cast<double>(frames);
        for (std::size_t f = 0; f < frames; ++f)
            sum += (take.poses[f * vertices + v].cast<double>() - mean).norm();
    }
    return sum / static_cast<double>(take.poses.size());
}

double movementDistance(const Movement& movement, std::size_t take, std::size_t other)
{
    const double range = (rangeOfMotion(movement.take(take)) + rangeOfMotion(movement.take(other))) / 2;
    const double apart = meanDistance(movement.take(take).poses, movement.take(other).poses);
    return range > 0 ? apart / range : 0;
}

std::vector<std::size_t> sameMovement(const Movement& movement, std::size_t take)
{
    const std::vector<std::string>& labels = movement.take(take).labels;
    std::vector<std::size_t> same;
    for (std::size_t other = 0; other < movement.capturedCount(); ++other) {
        const std::vector<std::string>& others = movement.take(other).labels;
        const bool isSame = labels.empty() || others.empty()
                                ? movementDistance(movement, take, other) <= greatestDistance
                                : labels == others;
        if (other == take || isSame)
            same.push_back(other);
    }
    return same;
}

} // namespace quadrille
