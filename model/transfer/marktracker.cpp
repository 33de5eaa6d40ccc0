// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/marktracker.h"

#include "model/geometry/trianglelogs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// More marks than this get their signs from the body alone.
constexpr std::size_t mostLinked = 1000;

/// The mean of rotations, whatever their signs: the principal axis of their quaternions.
Eigen::Quaterniond meanRotation(std::span<const Eigen::Quaterniond> rotations)
{
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (const Eigen::Quaterniond& q : rotations)
        sum += q.coeffs() * q.coeffs().transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(sum);
    return Eigen::Quaterniond(Eigen::Vector4d(axes.eigenvectors().col(3)));
}

void negate(Eigen::Quaterniond& q)
{
    q.coeffs() = -q.coeffs();
}

} // namespace

MarkTracker::MarkTracker(std::vector<Triangle> triangles, Positions reference)
    : m_triangles(std::move(triangles)), m_reference(poseFrames(m_triangles, reference))
{
}

MarkDeformations MarkTracker::next(Positions frame)
{
    const PoseFrames frames = poseFrames(m_triangles, frame);
    const TriangleLogs logs = triangleLogs(m_reference, frames, Eigen::Quaterniond::Identity());
    std::vector<int> degenerate;
    std::ranges::set_union(m_reference.degenerate, frames.degenerate, std::back_inserter(degenerate));
    MarkDeformations now;
    std::vector<Eigen::Quaterniond> sound;
    for (std::size_t m = 0; m < m_triangles.size(); ++m) {
        const double sine = std::sin(logs.halfAngle[m]);
        now.rotations.emplace_back(logs.cosine[m], sine * logs.axisX[m], sine * logs.axisY[m],
                                   sine * logs.axisZ[m]);
        if (!std::ranges::binary_search(degenerate, static_cast<int>(m)))
            sound.push_back(now.rotations.back());
    }
    now.root = sound.empty() ? Eigen::Quaterniond::Identity() : meanRotation(sound);
    for (const int m : degenerate)
        now.rotations[static_cast<std::size_t>(m)] = now.root;
    if (now.root.dot(m_rootBefore) < 0)
        negate(now.root);
    if (m_before.empty())
        chooseSigns(now);
    else
        continueSigns(now);
    m_before = now.rotations;
    m_rootBefore = now.root;
    return now;
}

void MarkTracker::chooseSigns(MarkDeformations& now) const
{
    std::vector<Eigen::Quaterniond>& marks = now.rotations;
    // Marks are linked one after the other, by the pair that turns most alike: parts that have turned far
    // are reached by way of those between.
    std::vector<double> likeness(marks.size());
    std::vector<Eigen::Quaterniond> like(marks.size(), now.root);
    std::vector<std::size_t> left;
    for (std::size_t m = 0; m < marks.size(); ++m) {
        likeness[m] = std::abs(marks[m].dot(now.root));
        left.push_back(m);
    }
    while (!left.empty()) {
        const auto best =
            marks.size() > mostLinked
                ? left.end() - 1
                : std::ranges::max_element(left, {}, [&](std::size_t m) { return likeness[m]; });
        const std::size_t next = *best;
        left.erase(best);
        if (marks[next].dot(like[next]) < 0)
            negate(marks[next]);
        if (marks.size() > mostLinked)
            continue;
        for (const std::size_t m : left) {
            const double alike = std::abs(marks[m].dot(marks[next]));
            if (alike > likeness[m]) {
                likeness[m] = alike;
                like[m] = marks[next];
            }
        }
    }
}

void MarkTracker::continueSigns(MarkDeformations& now) const
{
    for (std::size_t m = 0; m < now.rotations.size(); ++m) {
        if (now.rotations[m].dot(m_before[m]) < 0)
            negate(now.rotations[m]);
    }
}

} // namespace quadrille
