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

void checkShare(double share, const std::string& block)
{
    if (!(share > 0) || !std::isfinite(share))
        refuse("The share of the " + block + " must be greater than 0", "The usual share is 6.");
}

RowMatrix displacementRows(const AlignedTake& take)
{
    const std::vector<Displacement> displacements = displacementsOf(take.placements);
    const std::vector<double> steps = takeSteps(take.warp, displacements.size());
    RowMatrix rows = Eigen::Map<const RowMatrix>(
        displacements.front().data(), static_cast<Eigen::Index>(displacements.size()), displacementCount);
    for (Eigen::Index f = 0; f < rows.rows(); ++f)
        rows.row(f) /= steps[static_cast<std::size_t>(f)];
    return rows;
}

/// The displacements, then the coefficients of each kind.
std::vector<BlockColumns> rootBlocks(const AlignedTake& take, Eigen::Index coordinates,
                                     std::span<const CoefficientKind> kinds)
{
    std::vector<BlockColumns> blocks{{displacementBlock, coordinates, displacementCount, 1}};
    for (std::size_t k = 0; k < kinds.size(); ++k)
        blocks.push_back(
            {kinds[k].name, blocks.back().first + blocks.back().count, take.coefficients[k].cols(), 1});
    return blocks;
}

/// Gives a block its share of the variance.
void scaleBlock(PartTraining& training, std::size_t index, Eigen::Index coordinates, double share)
{
    BlockColumns& block = training.blocks[index];
    auto columns = training.rows.middleCols(block.first, block.count);
    const double poses = totalVariance(training.rows.leftCols(coordinates));
    const double values = totalVariance(columns);
    const double wanted = share * poses / static_cast<double>(coordinates);
    // Of values of single precision that do not vary.
    const double rounding = 1e-12 * columns.squaredNorm() / static_cast<double>(columns.rows());
    block.scale = wanted > 0 && values > rounding ? std::sqrt(wanted / values) : 1;
    columns *= block.scale;
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

std::vector<Positions> AlignedTake::allPoses() const
{
    std::vector<Positions> all;
    for (std::size_t f = 0; f < placements.size(); ++f)
        all.push_back(pose(f));
    return all;
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

PartTraining partTraining(std::span<const AlignedTake> takes, const BodyPart& part, double displacementShare,
                          std::span<const CoefficientKind> kinds)
{
    if (takes.empty())
        refuse("There is no take to learn from", "Name at least one.");
    checkShare(displacementShare, displacementBlock);
    for (const CoefficientKind& kind : kinds)
        checkShare(kind.share, kind.name);
    PartTraining training;
    const auto coordinates = static_cast<Eigen::Index>(3 * part.vertices.size());
    if (part.parent < 0)
        training.blocks = rootBlocks(takes.front(), coordinates, kinds);
    const auto frames = static_cast<Eigen::Index>(takes.front().placements.size());
    training.rows.resize(
        frames * static_cast<Eigen::Index>(takes.size()),
        training.blocks.empty() ? coordinates : training.blocks.back().first + training.blocks.back().count);
    for (const AlignedTake& take : takes) {
        assert(static_cast<Eigen::Index>(take.placements.size()) == frames);
        const Eigen::Index first = training.spans.empty() ? 0 : training.spans.back().last() + 1;
        training.spans.push_back({first, frames});
        for (Eigen::Index f = 0; f < frames; ++f) {
            const Positions pose = take.pose(static_cast<std::size_t>(f));
            for (std::size_t v = 0; v < part.vertices.size(); ++v)
                training.rows.row(first + f).segment<3>(static_cast<Eigen::Index>(3 * v)) =
                    pose[part.vertices[v].value].cast<double>();
        }
        for (std::size_t b = 0; b < training.blocks.size(); ++b) {
            const BlockColumns& block = training.blocks[b];
            training.rows.block(first, block.first, frames, block.count) =
                b == 0 ? displacementRows(take) : take.coefficients[b - 1];
        }
    }
    for (std::size_t b = 0; b < training.blocks.size(); ++b)
        scaleBlock(training, b, coordinates, b == 0 ? displacementShare : kinds[b - 1].share);
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

std::vector<Displacement> partDisplacements(const Eigen::Ref<const RowMatrix>& poseVectors,
                                            const PartTraining& training, const TakeWarp& warp)
{
    assert(!training.blocks.empty() && training.blocks.front().count == displacementCount);
    const RowMatrix values = blockValues(poseVectors, training.blocks.front());
    std::vector<Displacement> displacements(static_cast<std::size_t>(values.rows()));
    const std::vector<double> steps = takeSteps(warp, displacements.size());
    for (std::size_t f = 0; f < displacements.size(); ++f)
        Eigen::Map<Eigen::Matrix<double, 1, displacementCount>>(displacements[f].data()) =
            steps[f] * values.row(static_cast<Eigen::Index>(f));
    return displacements;
}

} // namespace quadrille
