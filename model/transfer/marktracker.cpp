// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/marktracker.h"

#include "model/geometry/procrustes.h"
#include "model/geometry/trianglelogs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// The mean over a patch; nothing where no triangle of it has an area.
std::optional<Eigen::Quaterniond> rotationOf(std::span<const Surroundings::Near> near,
                                             const TriangleLogs& logs, const std::vector<bool>& isSound)
{
    const auto turnOf = [&logs](std::size_t t) {
        const double sine = std::sin(logs.halfAngle[t]);
        return Eigen::Quaterniond(logs.cosine[t], sine * logs.axisX[t], sine * logs.axisY[t],
                                  sine * logs.axisZ[t]);
    };
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    std::size_t count = 0;
    std::size_t last = 0;
    for (const Surroundings::Near& each : near) {
        if (!isSound[each.triangle])
            continue;
        sum += each.weight * turnOf(each.triangle).toRotationMatrix();
        last = each.triangle;
        ++count;
    }
    if (count == 0)
        return std::nullopt;
    return count == 1 ? turnOf(last) : rotationOfCovariance(sum);
}

void negate(Eigen::Quaterniond& q)
{
    q.coeffs() = -q.coeffs();
}

} // namespace

MarkTracker::MarkTracker(MarkPatches patches, Positions reference)
    : m_patches(std::move(patches)), m_reference(poseFrames(m_patches.triangles, reference))
{
}

MarkDeformations MarkTracker::next(Positions frame)
{
    const PoseFrames frames = poseFrames(m_patches.triangles, frame);
    const TriangleLogs logs = triangleLogs(m_reference, frames, Eigen::Quaterniond::Identity());
    std::vector<bool> isSound(m_patches.triangles.size(), true);
    for (const std::vector<int>* degenerate : {&std::as_const(m_reference).degenerate, &frames.degenerate}) {
        for (const int t : *degenerate)
            isSound[static_cast<std::size_t>(t)] = false;
    }
    MarkDeformations now;
    std::vector<Eigen::Quaterniond> sound;
    std::vector<std::size_t> lost;
    for (const std::vector<Surroundings::Near>& near : m_patches.near) {
        const auto rotation = rotationOf(near, logs, isSound);
        if (rotation)
            sound.push_back(*rotation);
        else
            lost.push_back(now.rotations.size());
        now.rotations.push_back(rotation.value_or(Eigen::Quaterniond::Identity()));
    }
    now.root = sound.empty() ? Eigen::Quaterniond::Identity() : meanRotation(sound);
    for (const std::size_t m : lost)
        now.rotations[m] = now.root;
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
