// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/stepcosts.h"

#include <bit>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// How points move in each frame: half the way from the frame before to the one behind, where there are both.
std::vector<Vec3d> velocitiesOf(const FrameLayout& layout, double scale, const auto& placeOf)
{
    std::vector<Vec3d> velocities;
    velocities.reserve(static_cast<std::size_t>(layout.frameCount()));
    for (int s = 0; s < layout.sequenceCount(); ++s) {
        const NodeIndex first = layout.firstOf(s);
        const NodeIndex last = layout.lastOf(s);
        for (NodeIndex node = first; node <= last; ++node) {
            const NodeIndex before = std::max(node - 1, first);
            const NodeIndex behind = std::min(node + 1, last);
            const Vec3d way = placeOf(behind) - placeOf(before);
            velocities.push_back(way * (scale / std::max(behind - before, 1)));
        }
    }
    return velocities;
}

} // namespace

double differingFeet(const Stances& stances, NodeIndex i, NodeIndex j)
{
    if (!stances.isKnown())
        return 0;
    return std::popcount(stances.at(i) ^ stances.at(j)) / static_cast<double>(stances.feet.size());
}

StepCosts stepCosts(const RootPoses& roots, const FrameLayout& layout, double fps)
{
    const NodeIndex frames = layout.frameCount();
    StepCosts parts{.contacts = Table<float>::Zero(frames, frames),
                    .velocity = Table<float>::Zero(frames, frames)};
    const Stances& stances = roots.stances;
    const std::size_t feet = stances.feet.size();
    if (feet == 0 || stances.height <= 0)
        return parts;
    const double scale = fps / stances.height;
    std::vector<std::vector<Vec3d>> moving{velocitiesOf(layout, scale, [&](NodeIndex node) -> Vec3d {
        return roots.centres[static_cast<std::size_t>(node)];
    })};
    for (std::size_t foot = 0; foot < feet; ++foot)
        moving.push_back(velocitiesOf(layout, scale,
                                      [&](NodeIndex node) -> Vec3d { return stances.placeOf(node, foot); }));
    const Ground ground(roots.up);
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        for (NodeIndex j = 0; j < frames; ++j) {
            if (i == j)
                continue;
            parts.contacts(i, j) = static_cast<float>(differingFeet(stances, i, j));
            const Eigen::Rotation2Dd turn(static_cast<double>(roots.turns(i, j)));
            const auto difference = [&](std::size_t point) {
                const Vec3d& here = moving[point][static_cast<std::size_t>(i)];
                const Vec3d& there = moving[point][static_cast<std::size_t>(j)];
                return std::hypot((ground.of(here) - turn * ground.of(there)).norm(),
                                  ground.heightOf(here) - ground.heightOf(there));
            };
            double ofFeet = 0;
            for (std::size_t foot = 0; foot < feet; ++foot)
                ofFeet += difference(foot + 1) / static_cast<double>(feet);
            parts.velocity(i, j) = static_cast<float>(difference(0) + ofFeet);
        }
    });
    return parts;
}

void addDrifts(Table<float>& cost, const Table<float>& drifts, const Table<std::uint16_t>& length, bool isSum,
               const StepWeights& weights)
{
    const auto weight = static_cast<float>(weights.contacts / dragOfOneFoot);
    if (isSum)
        cost += weight * drifts * length.cast<float>();
    else
        cost += weight * drifts;
}

Table<float> weightedSteps(const Table<float>& distances, const StepCosts& parts, const StepWeights& weights)
{
    return distances + static_cast<float>(weights.contacts) * parts.contacts +
           static_cast<float>(weights.velocity) * parts.velocity;
}

} // namespace quadrille
