// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/stepcosts.h"

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

StepDifferences::StepDifferences(const RootPoses& roots, const FrameLayout& layout, double fps)
    : m_stances(roots.stances), m_turns(roots.turns), m_points(roots.stances.feet.size() + 1)
{
    if (!areKnown())
        return;
    const double scale = fps / m_stances.height;
    const Ground ground(roots.up);
    m_moving.resize(m_points * static_cast<std::size_t>(layout.frameCount()));
    const auto setVelocities = [&](std::size_t point, const auto& placeOf) {
        const std::vector<Vec3d> all = velocitiesOf(layout, scale, placeOf);
        for (std::size_t node = 0; node < all.size(); ++node)
            m_moving[node * m_points + point] = {ground.of(all[node]), ground.heightOf(all[node])};
    };
    setVelocities(0, [&](NodeIndex node) -> Vec3d { return roots.centres[static_cast<std::size_t>(node)]; });
    for (std::size_t foot = 0; foot + 1 < m_points; ++foot)
        setVelocities(foot + 1, [&](NodeIndex node) -> Vec3d { return m_stances.placeOf(node, foot); });
}

float StepDifferences::contacts(NodeIndex i, NodeIndex j) const
{
    return static_cast<float>(differingFeet(m_stances, i, j));
}

float StepDifferences::velocity(NodeIndex i, NodeIndex j) const
{
    const Velocity* const here = &m_moving[static_cast<std::size_t>(i) * m_points];
    const Velocity* const there = &m_moving[static_cast<std::size_t>(j) * m_points];
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(static_cast<double>(m_turns(i, j))).toRotationMatrix();
    const auto difference = [&](std::size_t point) {
        return std::hypot((here[point].over - turn * there[point].over).norm(),
                          here[point].up - there[point].up);
    };
    const auto feet = static_cast<double>(m_points - 1);
    double ofFeet = 0;
    for (std::size_t point = 1; point < m_points; ++point)
        ofFeet += difference(point) / feet;
    return static_cast<float>(difference(0) + ofFeet);
}

StepCosts stepCosts(const RootPoses& roots, const FrameLayout& layout, double fps)
{
    const NodeIndex frames = layout.frameCount();
    StepCosts parts{.contacts = Table<float>::Zero(frames, frames),
                    .velocity = Table<float>::Zero(frames, frames)};
    const StepDifferences differences(roots, layout, fps);
    if (!differences.areKnown())
        return parts;
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        for (NodeIndex j = 0; j < frames; ++j) {
            if (i == j)
                continue;
            parts.contacts(i, j) = differences.contacts(i, j);
            parts.velocity(i, j) = differences.velocity(i, j);
        }
    });
    return parts;
}

void addStepCosts(Table<float>& distances, const StepDifferences& differences, const StepWeights& weights)
{
    if (!differences.areKnown())
        return;
    const auto frames = static_cast<NodeIndex>(distances.rows());
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        for (NodeIndex j = 0; j < frames; ++j)
            distances(i, j) = differences.step(distances(i, j), weights, i, j);
    });
}

void addDrifts(Table<float>& cost, TableView<float> drifts, TableView<std::uint16_t> length, bool isSum,
               const StepWeights& weights)
{
    const auto weight = static_cast<float>(weights.contacts / dragOfOneFoot);
    if (isSum)
        cost += weight * drifts * length.cast<float>();
    else
        cost += weight * drifts;
}

Table<float> weightedSteps(TableView<float> distances, const StepCosts& parts, const StepWeights& weights)
{
    return distances + static_cast<float>(weights.contacts) * parts.contacts +
           static_cast<float>(weights.velocity) * parts.velocity;
}

} // namespace quadrille
