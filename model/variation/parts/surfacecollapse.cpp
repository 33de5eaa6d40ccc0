// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/surfacecollapse.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace quadrille {

namespace {

constexpr double leastShareOfArea = 0.5;
constexpr double furtherFold = std::numbers::pi / 3;
/// Fewer triangles are no region: they count with the next slice.
constexpr int fewestTriangles = 40;

/// Normals of the length of twice the areas.
std::vector<Vec3d> areaVectors(std::span<const std::array<VertexIndex, 3>> triangles, Positions pose)
{
    std::vector<Vec3d> vectors;
    vectors.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) {
        const Vec3d first = (pose[b.value] - pose[a.value]).cast<double>();
        const Vec3d second = (pose[c.value] - pose[a.value]).cast<double>();
        vectors.push_back(first.cross(second));
    }
    return vectors;
}

double angleBetween(const Vec3d& a, const Vec3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Of each triangle the part with the most of its vertices that are no other's.
std::vector<std::size_t> partOfTriangles(std::span<const std::array<VertexIndex, 3>> triangles,
                                         std::size_t vertexCount, const BodyParts& parts)
{
    // Later parts hang on earlier ones: what two share counts with the later.
    std::vector<std::size_t> ofVertex(vertexCount, 0);
    for (std::size_t p = 0; p < parts.parts.size(); ++p) {
        for (const VertexIndex vertex : parts.parts[p].vertices)
            ofVertex[vertex.value] = std::max(ofVertex[vertex.value], p);
    }
    std::vector<std::size_t> ofTriangle;
    ofTriangle.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles)
        ofTriangle.push_back(std::min({ofVertex[a.value], ofVertex[b.value], ofVertex[c.value]}));
    return ofTriangle;
}

} // namespace

SurfaceCollapse::SurfaceCollapse(const Topology& topology, const BodyParts& parts,
                                 std::span<const Positions> poses, int slices)
    : m_triangles(topology.triangles().begin(), topology.triangles().end())
    , m_leastAreas(m_triangles.size(), std::numeric_limits<double>::infinity())
    , m_regions(m_triangles.size())
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = m_triangles[t][i].value;
            const std::uint32_t b = m_triangles[t][(i + 1) % 3].value;
            const auto [found, isNew] = edges.try_emplace({std::min(a, b), std::max(a, b)}, t);
            if (!isNew)
                m_folds.push_back({{found->second, t}});
        }
    }
    for (const Positions pose : poses) {
        const std::vector<Vec3d> vectors = areaVectors(m_triangles, pose);
        for (std::size_t t = 0; t < vectors.size(); ++t)
            m_leastAreas[t] = std::min(m_leastAreas[t], vectors[t].norm());
        for (Fold& fold : m_folds)
            fold.greatest =
                std::max(fold.greatest, angleBetween(vectors[fold.triangles[0]], vectors[fold.triangles[1]]));
    }
    const Positions pose = poses.front();
    const auto middle = [&](std::size_t t) {
        const auto& [a, b, c] = m_triangles[t];
        return Vec3d((pose[a.value] + pose[b.value] + pose[c.value]).cast<double>() / 3);
    };
    const std::vector<std::size_t> ofTriangle = partOfTriangles(m_triangles, pose.size(), parts);
    for (std::size_t p = 0; p < std::max<std::size_t>(parts.parts.size(), 1); ++p) {
        std::vector<std::size_t> own;
        for (std::size_t t = 0; t < ofTriangle.size(); ++t) {
            if (ofTriangle[t] == p)
                own.push_back(t);
        }
        Vec3d mean = Vec3d::Zero();
        for (const std::size_t t : own)
            mean += middle(t) / static_cast<double>(own.size());
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const std::size_t t : own)
            spread += (middle(t) - mean) * (middle(t) - mean).transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
        const Vec3d along = solver.eigenvectors().col(2);
        std::ranges::sort(own, {}, [&](std::size_t t) { return along.dot(middle(t)); });
        if (own.empty())
            continue;
        const double first = along.dot(middle(own.front()));
        const double length = along.dot(middle(own.back())) - first;
        m_counts.push_back(0);
        int slice = 0;
        for (const std::size_t t : own) {
            const double place = length > 0 ? (along.dot(middle(t)) - first) / length * slices : 0;
            if (place >= slice + 1 && slice + 1 < slices && m_counts.back() >= fewestTriangles) {
                slice = static_cast<int>(place);
                m_counts.push_back(0);
            }
            m_regions[t] = static_cast<int>(m_counts.size()) - 1;
            ++m_counts.back();
        }
    }
}

double SurfaceCollapse::of(Positions pose) const
{
    const std::vector<Vec3d> vectors = areaVectors(m_triangles, pose);
    std::vector<bool> isBad(vectors.size());
    for (std::size_t t = 0; t < vectors.size(); ++t)
        isBad[t] = vectors[t].norm() < leastShareOfArea * m_leastAreas[t];
    for (const Fold& fold : m_folds) {
        const double angle = angleBetween(vectors[fold.triangles[0]], vectors[fold.triangles[1]]);
        if (angle > fold.greatest + furtherFold)
            isBad[fold.triangles[0]] = isBad[fold.triangles[1]] = true;
    }
    std::vector<int> bad(m_counts.size());
    for (std::size_t t = 0; t < isBad.size(); ++t)
        bad[static_cast<std::size_t>(m_regions[t])] += isBad[t] ? 1 : 0;
    double worst = 0;
    for (std::size_t r = 0; r < bad.size(); ++r)
        worst = std::max(worst, static_cast<double>(bad[r]) / m_counts[r]);
    return worst;
}

} // namespace quadrille
