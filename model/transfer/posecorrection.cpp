// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/posecorrection.h"

#include "model/geometry/procrustes.h"
#include "model/geometry/surfacedistances.h"
#include "model/transfer/solidtarget.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

/// Each place is held by so many near ones, more where marks are dense.
constexpr std::size_t fewestNeighbours = 4;
constexpr std::size_t mostNeighbours = 8;
constexpr std::size_t marksANeighbour = 20;
/// What the way that a place faces is worth against the ways to its neighbours.
constexpr double normalShare = 0.5;
/// What it is worth that neighbours turn alike against the ways between them.
constexpr double smoothness = 0.02;
constexpr int rounds = 50;
/// Turns up to the first angle are not carried, from the second on all of them, radians.
constexpr double ignored = 8 * std::numbers::pi / 180;
constexpr double carried = 14 * std::numbers::pi / 180;

/// Where marked triangles are and where they face, their middles about their mean, the spread one.
struct MarkedPlaces
{
    std::vector<Vec3d> middles;
    std::vector<Vec3d> normals;
};

MarkedPlaces placesOf(const PosedMesh& mesh, std::span<const TrianglePair> pairs,
                      TriangleIndex TrianglePair::*which)
{
    MarkedPlaces places;
    Vec3d mean = Vec3d::Zero();
    for (const TrianglePair& pair : pairs) {
        const Triangle& t = mesh.topology->triangles()[(pair.*which).value];
        const auto corner = [&](std::size_t c) -> Vec3d { return mesh.positions[t[c].value].cast<double>(); };
        places.middles.push_back(middleOf(t, mesh.positions));
        places.normals.push_back((corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized());
        mean += places.middles.back() / static_cast<double>(pairs.size());
    }
    double square = 0;
    for (Vec3d& p : places.middles) {
        p -= mean;
        square += p.squaredNorm() / static_cast<double>(pairs.size());
    }
    if (square > 0) {
        for (Vec3d& p : places.middles)
            p /= std::sqrt(square);
    }
    return places;
}

/// Whether one is more like the other seen in a mirror.
bool areMirrored(const MarkedPlaces& from, const MarkedPlaces& onto)
{
    constexpr double flat = 1e-4;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t m = 0; m < from.middles.size(); ++m)
        covariance += onto.middles[m] * from.middles[m].transpose();
    return (covariance / static_cast<double>(from.middles.size())).determinant() < -flat;
}

struct Neighbour
{
    std::size_t mark = 0;
    double weight = 0;
};

/// Marks near each other over the template's surface: a hand that hangs beside the hip is not near that.
class NearMarks
{
public:
    NearMarks(const PosedMesh& reference, std::span<const TrianglePair> pairs)
        : m_solid(*reference.topology, reference.positions)
        , m_graph(m_solid.topology(), m_solid.positions())
        , m_neighbours(std::clamp(pairs.size() / marksANeighbour, fewestNeighbours, mostNeighbours))
        , m_marksAt(m_graph.vertexCount())
    {
        for (std::size_t m = 0; m < pairs.size(); ++m) {
            m_triangles.push_back(m_solid.triangleOf(pairs[m].onTemplate));
            for (const VertexIndex v : cornersOf(m))
                m_marksAt[v.value].push_back(m);
        }
    }

    std::vector<Neighbour> of(std::size_t mark) const
    {
        SurfaceDistances distances(m_graph);
        for (const VertexIndex v : cornersOf(mark))
            distances.add({v, 0}, 0);
        std::vector<Neighbour> near;
        while (near.size() < m_neighbours) {
            const auto reached = distances.next();
            if (!reached)
                break;
            for (const std::size_t m : m_marksAt[reached->vertex.value]) {
                if (m != mark && std::ranges::find(near, m, &Neighbour::mark) == near.end())
                    near.push_back({m, static_cast<double>(distances.at(*reached))});
            }
        }
        for (Neighbour& n : near) {
            const double share = near.back().weight > 0 ? n.weight / near.back().weight : 0;
            n.weight = std::exp(-share * share);
        }
        return near;
    }

private:
    std::span<const VertexIndex> cornersOf(std::size_t mark) const
    {
        if (!m_triangles[mark])
            return {};
        return m_solid.topology()->triangles()[*m_triangles[mark]];
    }

    SolidTarget m_solid;
    SurfaceGraph m_graph;
    std::size_t m_neighbours;
    std::vector<std::optional<std::size_t>> m_triangles;
    std::vector<std::vector<std::size_t>> m_marksAt; ///< of each vertex the marks that it is a corner of
};

/// Turns of a few degrees become none, without a step.
Eigen::Quaterniond withoutSmallTurns(const Eigen::Quaterniond& q)
{
    const Eigen::AngleAxisd turn(q);
    const double share = std::clamp((turn.angle() - ignored) / (carried - ignored), 0.0, 1.0);
    return Eigen::Quaterniond(Eigen::AngleAxisd(turn.angle() * share * share * (3 - 2 * share), turn.axis()));
}

} // namespace

std::vector<Eigen::Quaterniond> poseCorrections(const PosedMesh& reference, const PosedMesh& target,
                                                std::span<const TrianglePair> pairs)
{
    constexpr std::size_t fewest = 4;
    const std::size_t count = pairs.size();
    if (count < fewest)
        return std::vector(count, Eigen::Quaterniond::Identity());
    const MarkedPlaces onto = placesOf(reference, pairs, &TrianglePair::onTemplate);
    const MarkedPlaces from = placesOf(target, pairs, &TrianglePair::onTarget);
    if (areMirrored(from, onto))
        return std::vector(count, Eigen::Quaterniond::Identity());
    const NearMarks marks(reference, pairs);
    std::vector<std::vector<Neighbour>> near(count);
    std::vector<Eigen::Matrix3d> data(count);
    std::vector<double> size(count, 0);
    for (std::size_t m = 0; m < count; ++m) {
        near[m] = marks.of(m);
        data[m].setZero();
        for (const Neighbour& n : near[m]) {
            const Vec3d a = onto.middles[n.mark] - onto.middles[m];
            const Vec3d b = from.middles[n.mark] - from.middles[m];
            data[m] += n.weight * a * b.transpose();
            size[m] += n.weight * a.norm() * b.norm();
        }
        data[m] += normalShare * size[m] * onto.normals[m] * from.normals[m].transpose();
    }
    std::vector<Eigen::Matrix3d> turns(count, Eigen::Matrix3d::Identity());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t m = 0; m < count; ++m) {
            Eigen::Matrix3d like = Eigen::Matrix3d::Zero();
            double weights = 0;
            for (const Neighbour& n : near[m]) {
                like += n.weight * turns[n.mark];
                weights += n.weight;
            }
            if (weights == 0)
                continue;
            turns[m] =
                rotationOfCovariance(data[m] + smoothness * size[m] / weights * like).toRotationMatrix();
        }
    }
    std::vector<Eigen::Quaterniond> corrections;
    corrections.reserve(count);
    for (const Eigen::Matrix3d& turn : turns)
        corrections.push_back(withoutSmallTurns(Eigen::Quaterniond(turn)));
    return corrections;
}

} // namespace quadrille
