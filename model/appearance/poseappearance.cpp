// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/poseappearance.h"

#include "model/geometry/procrustes.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

namespace {

constexpr std::uint32_t mostVertices = 1000;

std::vector<std::uint32_t> comparedVertices(std::uint32_t vertexCount)
{
    const std::uint32_t count = std::min(vertexCount, mostVertices);
    std::vector<std::uint32_t> vertices;
    for (std::uint64_t i = 0; i < count; ++i)
        vertices.push_back(static_cast<std::uint32_t>(i * vertexCount / count));
    return vertices;
}

std::vector<Vec3f> positionsOf(const std::vector<std::uint32_t>& vertices, Positions pose)
{
    std::vector<Vec3f> chosen;
    chosen.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices)
        chosen.push_back(pose[vertex]);
    return chosen;
}

std::span<const float> placeOf(const PosePlaces& places, std::int64_t pose)
{
    const std::size_t size = 3 * places.vertices.size();
    return std::span(places.positions).subspan(static_cast<std::size_t>(pose) * size, size);
}

/// The positions turned and moved onto a pose; as they are where there is none.
std::vector<float> laidOn(std::span<const float> target, const std::vector<Vec3f>& pose)
{
    RigidMotion motion;
    if (!target.empty()) {
        std::vector<Vec3f> onto;
        for (std::size_t i = 0; i < target.size(); i += 3)
            onto.emplace_back(target[i], target[i + 1], target[i + 2]);
        motion = rigidProcrustes(pose, onto);
    }
    std::vector<float> place;
    for (const Vec3f& position : pose) {
        const Vec3f moved = motion(position.cast<double>()).cast<float>();
        place.insert(place.end(), moved.begin(), moved.end());
    }
    return place;
}

double meanSquare(std::span<const float> first, std::span<const float> second)
{
    const auto size = std::ssize(first);
    const Eigen::Map<const Eigen::VectorXf> a(first.data(), size);
    const Eigen::Map<const Eigen::VectorXf> b(second.data(), size);
    return 3 * static_cast<double>((a - b).squaredNorm()) / static_cast<double>(size);
}

std::vector<float> inSingle(const Eigen::VectorXd& values)
{
    const Eigen::VectorXf rounded = values.cast<float>();
    return {rounded.begin(), rounded.end()};
}

} // namespace

PosePlaces posePlaces(std::int64_t count, std::uint32_t vertexCount,
                      const std::function<Frame(std::int64_t)>& pose, const Progress& progress)
{
    PosePlaces places{.vertices = comparedVertices(vertexCount), .positions = {}};
    for (std::int64_t i = 0; i < count; ++i) {
        progress.report(i, count);
        const auto first = i == 0 ? std::span<const float>() : placeOf(places, 0);
        const std::vector<float> place = laidOn(first, positionsOf(places.vertices, pose(i).positions()));
        places.positions.insert(places.positions.end(), place.begin(), place.end());
    }
    return places;
}

Eigen::MatrixXd squaredDistances(const PosePlaces& places, const Progress& progress)
{
    const std::int64_t count = places.count();
    Eigen::MatrixXd squared = Eigen::MatrixXd::Zero(count, count);
    for (std::int64_t pose = 0; pose < count; ++pose) {
        progress.report(pose, count);
        for (std::int64_t other = 0; other < pose; ++other)
            squared(pose, other) = squared(other, pose) =
                meanSquare(placeOf(places, pose), placeOf(places, other));
    }
    return squared;
}

Eigen::VectorXd squaredDistances(const PosePlaces& places, Positions pose)
{
    const std::vector<float> place = laidOn(placeOf(places, 0), positionsOf(places.vertices, pose));
    Eigen::VectorXd squared(places.count());
    for (Eigen::Index i = 0; i < squared.size(); ++i)
        squared[i] = meanSquare(place, placeOf(places, i));
    return squared;
}

Eigen::MatrixXd coefficientRows(const QuantisedSpace& space, std::span<const std::int64_t> samples)
{
    Eigen::MatrixXd rows(std::ssize(samples), space.count);
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
        const auto first = static_cast<std::size_t>(samples[static_cast<std::size_t>(row)] * space.count);
        for (Eigen::Index c = 0; c < space.count; ++c)
            rows(row, c) = space.coefficients[first + static_cast<std::size_t>(c)];
    }
    return rows;
}

PoseAppearance::PoseAppearance(const PosePlaces& places, const Eigen::MatrixXd& textures,
                               const Eigen::MatrixXd& warps, const PoseScales& scales)
    : PoseAppearance(places, squaredDistances(places), textures, warps, scales)
{
}

PoseAppearance::PoseAppearance(PosePlaces places, const Eigen::MatrixXd& squaredDistances,
                               const Eigen::MatrixXd& textures, const Eigen::MatrixXd& warps,
                               const PoseScales& scales)
    : m_places(std::move(places))
    , m_textures(squaredDistances, textures, scales.textures)
    , m_warps(squaredDistances, warps, scales.warps)
{
}

AppearanceCoefficients PoseAppearance::at(Positions pose) const
{
    assert(pose.size() > m_places.vertices.back());
    const Eigen::VectorXd squared = squaredDistances(m_places, pose);
    return {inSingle(m_textures.at(squared)), inSingle(m_warps.at(squared))};
}

} // namespace quadrille
