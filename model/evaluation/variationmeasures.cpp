// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/variationmeasures.h"

#include "model/synthesis/clips/ground.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

double meanAcceleration(const Clip& clip)
{
    double sum = 0;
    for (std::int64_t f = 1; f + 1 < clip.frameCount(); ++f) {
        const Positions before = clip.frame(f - 1);
        const Positions here = clip.frame(f);
        const Positions after = clip.frame(f + 1);
        double frame = 0;
        for (std::size_t v = 0; v < here.size(); ++v)
            frame += static_cast<double>((after[v] - 2 * here[v] + before[v]).norm());
        sum += frame / static_cast<double>(here.size());
    }
    return sum * clip.fps * clip.fps / static_cast<double>(std::max<std::int64_t>(clip.frameCount() - 2, 1));
}

double centreAcceleration(const Clip& clip)
{
    double sum = 0;
    for (std::int64_t f = 1; f + 1 < clip.frameCount(); ++f)
        sum +=
            (centroid(clip.frame(f + 1)) - 2 * centroid(clip.frame(f)) + centroid(clip.frame(f - 1))).norm();
    return sum * clip.fps * clip.fps / static_cast<double>(std::max<std::int64_t>(clip.frameCount() - 2, 1));
}

std::optional<double> meanSlide(const Clip& clip, const Stances& stances, UpAxis up)
{
    const std::vector<std::uint32_t> standing = stancesOf(clip, stances);
    double sum = 0;
    int count = 0;
    for (std::size_t f = 0; f + 1 < standing.size(); ++f) {
        const auto frame = static_cast<std::int64_t>(f);
        if (const auto slide = slideOf(clip.frame(frame), clip.frame(frame + 1),
                                       standing[f] & standing[f + 1], stances, up, clip.fps)) {
            sum += *slide;
            ++count;
        }
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

double turnAbout(const Eigen::Quaterniond& rotation, const Vec3d& up)
{
    return wrappedAngle(2 * std::atan2(rotation.vec().dot(up), rotation.w()));
}

/// Of each part the swing of its middle along its main direction in the take, both centred.
RowMatrix swings(const RowMatrix& limbs, const RowMatrix& take)
{
    const Eigen::Index parts = limbs.cols() / 3;
    RowMatrix swing(limbs.rows(), parts);
    for (Eigen::Index p = 0; p < parts; ++p) {
        const RowMatrix own =
            take.middleCols(3 * p, 3).rowwise() - take.middleCols(3 * p, 3).colwise().mean();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Eigen::Matrix3d(own.transpose() * own));
        swing.col(p) = limbs.middleCols(3 * p, 3) * solver.eigenvectors().col(2);
    }
    return swing.rowwise() - swing.colwise().mean().eval();
}

double correlationOf(const RowMatrix& swings, Eigen::Index a, Eigen::Index b)
{
    const double sizes = swings.col(a).norm() * swings.col(b).norm();
    return sizes > 0 ? swings.col(a).dot(swings.col(b)) / sizes : 0;
}

double ratioOf(double value, double to)
{
    return to > 0 ? value / to : 1;
}

} // namespace

MovedMeasures measureMoved(const Clip& clip, const Movement& movement, const Stances& stances, UpAxis up)
{
    MovedMeasures measures{.acceleration = meanAcceleration(clip),
                           .centreAcceleration = centreAcceleration(clip),
                           .slide = meanSlide(clip, stances, up)};
    const AlignmentTemplate& laidOnto = *movement.alignment.takes.front().laidOnto;
    const std::vector<BodyPart>& parts = movement.parts.parts;
    const std::size_t count = clip.topology->vertexCount();
    measures.limbs.setZero(clip.frameCount(), 3 * (std::ssize(parts) - 1));
    std::vector<Vec3d> first(count);
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const Positions pose = clip.frame(f);
        const RigidMotion laid = laidOnto.onto(pose);
        const Eigen::Quaterniond back = laid.rotation.conjugate();
        measures.placements.push_back({back, back * -laid.translation});
        double lowest = static_cast<double>(pose.front()[static_cast<Eigen::Index>(up)]);
        for (const Vec3f& position : pose)
            lowest = std::min(lowest, static_cast<double>(position[static_cast<Eigen::Index>(up)]));
        measures.lowest.push_back(lowest);
        for (std::size_t p = 1; p < parts.size(); ++p) {
            Vec3d middle = Vec3d::Zero();
            for (const VertexIndex v : parts[p].vertices)
                middle += laid(pose[v.value].cast<double>());
            measures.limbs.block<1, 3>(f, 3 * static_cast<Eigen::Index>(p - 1)) =
                middle.transpose() / static_cast<double>(parts[p].vertices.size());
        }
        for (std::size_t v = 0; v < count; ++v) {
            const Vec3d place = laid(pose[v].cast<double>());
            if (f == 0)
                first[v] = place;
            if (f + 1 == clip.frameCount())
                measures.closing += (place - first[v]).norm() / static_cast<double>(count);
        }
    }
    return measures;
}

VariationComparison compared(const MovedMeasures& of, const MovedMeasures& take,
                             std::span<const std::size_t> frames, UpAxis up)
{
    VariationComparison comparison{.acceleration = ratioOf(of.acceleration, take.acceleration),
                                   .centreAcceleration =
                                       ratioOf(of.centreAcceleration, take.centreAcceleration),
                                   .closing = of.closing - take.closing};
    if (of.slide && take.slide)
        comparison.slide = ratioOf(*of.slide, *take.slide);
    comparison.sink =
        std::max(0.0, *std::ranges::min_element(take.lowest) - *std::ranges::min_element(of.lowest));
    const Vec3d upwards = Vec3d::Unit(static_cast<Eigen::Index>(up));
    for (std::size_t f = 0; f < of.lowest.size(); ++f) {
        comparison.hover = std::max(comparison.hover, of.lowest[f] - take.lowest[frames[f]]);
        const Eigen::Quaterniond apart =
            of.placements[f].rotation * take.placements[frames[f]].rotation.conjugate();
        comparison.heading = std::max(comparison.heading, std::abs(turnAbout(apart, upwards)));
    }
    const RowMatrix own = swings(of.limbs, take.limbs);
    const RowMatrix captured = swings(take.limbs, take.limbs);
    constexpr double leastCorrelation = 0.5;
    double sum = 0;
    double sumOfTake = 0;
    int pairs = 0;
    for (Eigen::Index a = 0; a < captured.cols(); ++a) {
        for (Eigen::Index b = a + 1; b < captured.cols(); ++b) {
            const double inTake = correlationOf(captured, a, b);
            if (std::abs(inTake) < leastCorrelation)
                continue;
            sumOfTake += std::abs(inTake);
            sum += std::copysign(1, inTake) * correlationOf(own, a, b);
            ++pairs;
        }
    }
    if (pairs > 0) {
        comparison.step = sum / pairs;
        comparison.takeStep = sumOfTake / pairs;
    }
    return comparison;
}

FollowedTake followedTake(const Clip& clip, const CharacterFrames& character)
{
    FollowedTake take;
    take.clip.topology = clip.topology;
    take.clip.fps = clip.fps;
    const NodeIndex first = clip.origins.front().nearest();
    for (NodeIndex node = first; node <= clip.origins.back().nearest(); ++node) {
        take.clip.origins.push_back({.source = node, .destination = node});
        const Frame frame = character.frame(node);
        take.clip.positions.insert(take.clip.positions.end(), frame.positions().begin(),
                                   frame.positions().end());
    }
    for (const FrameProvenance& origin : clip.origins)
        take.frames.push_back(static_cast<std::size_t>(origin.nearest() - first));
    return take;
}

} // namespace quadrille
