// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/stretchtracker.h"

#include "model/geometry/surfacedistances.h"
#include "model/geometry/trianglelogs.h"
#include "model/transfer/solidtarget.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

/// How far what is near a mark reaches, of the root of the body's area: some 8 cm on a grown-up.
constexpr double reachShare = 0.06;
/// Logarithms of stretches are cut at that of two: skin gives no more, folds of single triangles do.
constexpr double mostStretch = std::numbers::ln2;

double areaOf(const Triangle& t, Positions pose)
{
    const auto corner = [&](std::size_t c) -> Vec3d { return pose[t[c].value].cast<double>(); };
    return 0.5 * (corner(0) - corner(2)).cross(corner(1) - corner(2)).norm();
}

/// The template's surface, and which of its triangles are near a mark.
class Surroundings
{
public:
    explicit Surroundings(const PosedMesh& reference)
        : m_solid(*reference.topology, reference.positions), m_graph(m_solid.topology(), m_solid.positions())
    {
        double all = 0;
        for (const Triangle& t : surface()) {
            m_areas.push_back(areaOf(t, m_solid.positions()));
            all += m_areas.back();
        }
        m_reach = reachShare * std::sqrt(all);
        m_trianglesAt.resize(m_graph.vertexCount());
        for (std::size_t t = 0; t < surface().size(); ++t) {
            for (const VertexIndex v : surface()[t])
                m_trianglesAt[v.value].push_back(t);
        }
    }

    std::optional<std::size_t> triangleOf(TriangleIndex mark) const { return m_solid.triangleOf(mark); }

    /// Triangles of the surface near one of them, itself among them, with their weights, whose sum is one;
    /// none without an area.
    std::vector<std::pair<std::size_t, double>> of(std::size_t mark) const
    {
        SurfaceDistances distances(m_graph);
        for (const VertexIndex v : surface()[mark])
            distances.add({v, 0}, 0);
        std::vector<std::size_t> near;
        while (const auto reached = distances.next()) {
            if (static_cast<double>(distances.at(*reached)) > m_reach)
                break;
            const std::vector<std::size_t>& at = m_trianglesAt[reached->vertex.value];
            near.insert(near.end(), at.begin(), at.end());
        }
        std::ranges::sort(near);
        near.erase(std::unique(near.begin(), near.end()), near.end());
        std::vector<std::pair<std::size_t, double>> weighted;
        double sum = 0;
        for (const std::size_t t : near) {
            double way = 0;
            for (const VertexIndex v : surface()[t])
                way += static_cast<double>(distances.at({v, 0})) / 3;
            const double left = 1 - std::min(1.0, (way * way) / (m_reach * m_reach));
            if (!(left > 0 && m_areas[t] > 0))
                continue;
            weighted.emplace_back(t, left * left * m_areas[t]);
            sum += weighted.back().second;
        }
        for (auto& [triangle, weight] : weighted)
            weight /= sum;
        return weighted;
    }

private:
    const std::vector<Triangle>& surface() const { return m_solid.topology()->triangles(); }

    SolidTarget m_solid;
    SurfaceGraph m_graph;
    std::vector<double> m_areas;
    std::vector<std::vector<std::size_t>> m_trianglesAt; ///< of each vertex
    double m_reach = 0;
};

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

StretchTracker::StretchTracker(const PosedMesh& reference, std::span<const TrianglePair> pairs)
{
    const Surroundings surroundings(reference);
    const std::vector<Triangle>& mesh = reference.topology->triangles();
    std::vector<std::size_t> ofMesh(mesh.size()); // of each triangle of the surface
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        if (const auto onSurface = surroundings.triangleOf(TriangleIndex(t)))
            ofMesh[*onSurface] = t;
    }
    std::vector<std::size_t> used(ofMesh.size(), mesh.size());
    for (const TrianglePair& pair : pairs) {
        std::vector<Near>& near = m_near.emplace_back();
        const auto mark = surroundings.triangleOf(pair.onTemplate);
        if (!mark)
            continue;
        for (const auto& [triangle, weight] : surroundings.of(*mark)) {
            if (used[triangle] == mesh.size()) {
                used[triangle] = m_triangles.size();
                m_triangles.push_back(mesh[ofMesh[triangle]]);
            }
            near.push_back({used[triangle], weight});
        }
    }
    m_reference = poseFrames(m_triangles, reference.positions);
}

std::vector<Eigen::Matrix3d> StretchTracker::next(Positions frame) const
{
    const PoseFrames frames = poseFrames(m_triangles, frame);
    const TriangleLogs logs = triangleLogs(m_reference, frames, Eigen::Quaterniond::Identity());
    std::vector<Eigen::Matrix3d> each;
    each.reserve(m_triangles.size());
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
        each.push_back(stretchOf(m_reference, logs, t));
    for (const std::vector<int>* degenerate : {&m_reference.degenerate, &frames.degenerate}) {
        for (const int t : *degenerate)
            each[static_cast<std::size_t>(t)].setIdentity();
    }
    std::vector<Eigen::Matrix3d> stretches(m_near.size(), Eigen::Matrix3d::Identity());
    for (std::size_t m = 0; m < m_near.size(); ++m) {
        for (const Near& near : m_near[m])
            stretches[m] += near.weight * (each[near.triangle] - Eigen::Matrix3d::Identity());
    }
    return stretches;
}

} // namespace quadrille
