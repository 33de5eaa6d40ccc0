// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/training.h"

#include "model/core/badargument.h"

#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

constexpr Eigen::Index displacementCount = std::tuple_size_v<Displacement>;

/// First motion undone, then the second: from the first place to the second, seen from the first.
RigidMotion between(const RigidMotion& from, const RigidMotion& to)
{
    const Eigen::Quaterniond back = from.rotation.conjugate();
    return {(back * to.rotation).normalized(), back * (to.translation - from.translation)};
}

/// Axis times angle in [0, π].
Vec3d logarithm(const Eigen::Quaterniond& rotation)
{
    const double sine = rotation.vec().norm();
    const double sign = rotation.w() < 0 ? -1 : 1;
    if (sine < 1e-300)
        return Vec3d::Zero();
    return 2 * std::atan2(sine, sign * rotation.w()) * sign / sine * rotation.vec();
}

Eigen::Quaterniond exponential(const Vec3d& axisAngle)
{
    const double angle = axisAngle.norm();
    if (angle < 1e-300)
        return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axisAngle / angle));
}

Displacement displacementOf(const RigidMotion& motion)
{
    const Vec3d turn = logarithm(motion.rotation);
    return {
        motion.translation.x(), motion.translation.y(), motion.translation.z(), turn.x(), turn.y(), turn.z()};
}

/// Sum of the variances of all columns.
double totalVariance(const Eigen::Ref<const RowMatrix>& rows)
{
    return (rows.rowwise() - rows.colwise().mean()).squaredNorm() / static_cast<double>(rows.rows());
}

} // namespace

RigidMotion AlignmentTemplate::onto(Positions other) const
{
    if (anchor.empty())
        return rigidProcrustes(other, pose);
    std::vector<Vec3f> moved;
    std::vector<Vec3f> target;
    for (const VertexIndex vertex : anchor) {
        moved.push_back(other[vertex.value]);
        target.push_back(pose[vertex.value]);
    }
    return rigidProcrustes(moved, target);
}

Positions AlignedTake::pose(std::size_t frame) const
{
    const std::size_t vertices = poses.size() / placements.size();
    return Positions(poses).subspan(frame * vertices, vertices);
}

std::vector<Displacement> displacementsOf(std::span<const RigidMotion> placements)
{
    assert(placements.size() >= 2);
    std::vector<Displacement> displacements(placements.size());
    for (std::size_t i = 1; i < placements.size(); ++i)
        displacements[i] = displacementOf(between(placements[i - 1], placements[i]));
    displacements[0] = displacements[1];
    return displacements;
}

RigidMotion moved(const RigidMotion& place, const Displacement& displacement)
{
    const auto& d = displacement;
    return {(place.rotation * exponential({d[3], d[4], d[5]})).normalized(),
            place.rotation * Vec3d(d[0], d[1], d[2]) + place.translation};
}

std::vector<RigidMotion> integrated(std::span<const Displacement> displacements, const RigidMotion& first)
{
    std::vector<RigidMotion> placements;
    placements.reserve(displacements.size());
    for (std::size_t i = 0; i < displacements.size(); ++i)
        placements.push_back(i == 0 ? first : moved(placements.back(), displacements[i]));
    return placements;
}

PartTraining partTraining(std::span<const AlignedTake> takes, const BodyPart& part, double displacementShare)
{
    if (takes.empty())
        refuse("There is no take to learn from", "Name at least one.");
    if (!(displacementShare > 0) || !std::isfinite(displacementShare))
        refuse("The share of the displacements must be greater than 0", "The usual share is 6.");
    const auto frames = static_cast<Eigen::Index>(takes.front().placements.size());
    const auto coordinates = static_cast<Eigen::Index>(3 * part.vertices.size());
    const bool isRoot = part.parent < 0;
    PartTraining training;
    training.rows.resize(frames * static_cast<Eigen::Index>(takes.size()),
                         coordinates + (isRoot ? displacementCount : 0));
    Eigen::Index row = 0;
    for (const AlignedTake& take : takes) {
        assert(static_cast<Eigen::Index>(take.placements.size()) == frames);
        training.spans.push_back({row, frames});
        const std::vector<Displacement> displacements =
            isRoot ? displacementsOf(take.placements) : std::vector<Displacement>();
        for (std::size_t f = 0; f < take.placements.size(); ++f, ++row) {
            const Positions pose = take.pose(f);
            for (std::size_t v = 0; v < part.vertices.size(); ++v)
                training.rows.row(row).segment<3>(static_cast<Eigen::Index>(3 * v)) =
                    pose[part.vertices[v].value].cast<double>();
            if (isRoot)
                training.rows.row(row).tail<displacementCount>() =
                    Eigen::Map<const Eigen::Matrix<double, 1, displacementCount>>(displacements[f].data());
        }
    }
    if (isRoot) {
        const double poses = totalVariance(training.rows.leftCols(coordinates));
        const double places = totalVariance(training.rows.rightCols(displacementCount));
        const double wanted = displacementShare * poses / static_cast<double>(coordinates);
        training.displacementScale = wanted > 0 && places > 0 ? std::sqrt(wanted / places) : 1;
        training.rows.rightCols(displacementCount) *= training.displacementScale;
    }
    training.mean = training.rows.colwise().mean();
    training.rows.rowwise() -= training.mean;
    return training;
}

void partPose(std::span<const double> poseVector, MutablePositions out)
{
    assert(poseVector.size() >= 3 * out.size());
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = Eigen::Map<const Vec3d>(&poseVector[3 * v]).cast<float>();
}

Displacement partDisplacement(std::span<const double> poseVector, double displacementScale)
{
    assert(displacementScale > 0 && poseVector.size() >= displacementCount);
    Displacement displacement{};
    for (std::size_t k = 0; k < displacement.size(); ++k)
        displacement[k] = poseVector[poseVector.size() - displacement.size() + k] / displacementScale;
    return displacement;
}

} // namespace quadrille
