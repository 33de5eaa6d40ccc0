// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/stretchtracker.h"

#include "model/geometry/trianglelogs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

/// Logarithms of stretches are cut at that of two: skin gives no more, folds of single triangles do.
constexpr double mostStretch = std::numbers::ln2;

/// S of one triangle, in the axes of its pose at rest.
Eigen::Matrix3d stretchOf(const PoseFrames& rest, const TriangleLogs& logs, std::size_t t)
{
    const double scale = std::exp(std::clamp(logs.logScale[t], -mostStretch, mostStretch));
    const double stretch = std::min(logs.logStretch[t], mostStretch);
    const double even = scale * std::cosh(stretch);
    const double uneven = scale * std::sinh(stretch);
    Eigen::Matrix3d local = Eigen::Matrix3d::Identity();
    local(0, 0) = even + uneven * logs.u1[t];
    local(1, 1) = even - uneven * logs.u1[t];
    local(0, 1) = local(1, 0) = uneven * logs.u2[t];
    const Eigen::Matrix3d axes =
        Eigen::Quaterniond(rest.qw[t], rest.qx[t], rest.qy[t], rest.qz[t]).toRotationMatrix();
    return axes * local * axes.transpose();
}

} // namespace

StretchTracker::StretchTracker(MarkPatches patches, Positions reference)
    : m_patches(std::move(patches)), m_reference(poseFrames(m_patches.triangles, reference))
{
}

std::vector<Eigen::Matrix3d> StretchTracker::next(Positions frame) const
{
    const PoseFrames frames = poseFrames(m_patches.triangles, frame);
    const TriangleLogs logs = triangleLogs(m_reference, frames, Eigen::Quaterniond::Identity());
    std::vector<Eigen::Matrix3d> each;
    each.reserve(m_patches.triangles.size());
    for (std::size_t t = 0; t < m_patches.triangles.size(); ++t)
        each.push_back(stretchOf(m_reference, logs, t));
    for (const std::vector<int>* degenerate : {&m_reference.degenerate, &frames.degenerate}) {
        for (const int t : *degenerate)
            each[static_cast<std::size_t>(t)].setIdentity();
    }
    std::vector<Eigen::Matrix3d> stretches(m_patches.near.size(), Eigen::Matrix3d::Identity());
    for (std::size_t m = 0; m < m_patches.near.size(); ++m) {
        for (const Surroundings::Near& near : m_patches.near[m])
            stretches[m] += near.weight * (each[near.triangle] - Eigen::Matrix3d::Identity());
    }
    return stretches;
}

} // namespace quadrille
