// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/pliablesurface.h"

#include "model/geometry/procrustes.h"
#include "model/geometry/surfacedistances.h"
#include "model/transfer/farthesttriangles.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace quadrille {

namespace {

constexpr std::size_t fewestPlaces = 500;
/// Each place is near so many others.
constexpr std::size_t neighbours = 7;
/// What it is worth at most that a place is where it is held, against one way to a near place that is as it
/// was.
constexpr double anchorWeight = 3;
/// Against all ways to near places: what it is worth that a place faces as it is held, and that it turns as
/// those near it.
constexpr double normalShare = 0.3;
constexpr double smoothness = 0.03;
/// Places grow as those near them do; what they would by themselves is so much of it.
constexpr double ownGrowth = 0.1;
constexpr double mostGrowth = 2;
/// Keeps parts of the surface where they are that nothing holds.
constexpr double inertia = 1e-9;

} // namespace

Spread spreadOf(std::span<const Vec3d> places)
{
    const auto count = static_cast<double>(places.size());
    Spread spread;
    for (const Vec3d& p : places)
        spread.middle += p / count;
    for (const Vec3d& p : places)
        spread.size += (p - spread.middle).squaredNorm() / count;
    spread.size = std::sqrt(spread.size);
    return spread;
}

PliableSurface::PliableSurface(const PosedSurface& surface, std::vector<TriangleIndex> places)
    : m_triangles(std::move(places))
{
    choosePlaces(surface);
    findNear(surface);
    const PosedMesh& mesh = surface.mesh();
    for (const TriangleIndex triangle : m_triangles) {
        const Triangle& t = mesh.topology->triangles()[triangle.value];
        m_starts.push_back(middleOf(t, mesh.positions));
        m_startNormals.push_back(normalOf(t, mesh.positions));
    }
    m_positions = m_starts;
    m_turns.assign(size(), Eigen::Matrix3d::Identity());
    m_growths.assign(size(), 1);
}

void PliableSurface::choosePlaces(const PosedSurface& surface)
{
    const PosedMesh& mesh = surface.mesh();
    const std::vector<Triangle>& triangles = mesh.topology->triangles();
    TriangleRows middles(triangles.size(), 3);
    std::vector<bool> hasArea(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        middles.row(static_cast<Eigen::Index>(t)) =
            middleOf(triangles[t], mesh.positions).cast<float>().transpose();
        hasArea[t] = surface.onGraph(TriangleIndex(t)).has_value();
    }
    m_triangles = farthestTriangles(middles, hasArea, std::move(m_triangles), fewestPlaces);
}

void PliableSurface::findNear(const PosedSurface& surface)
{
    const SurfaceGraph& graph = surface.graph();
    std::vector<std::vector<std::size_t>> placesAt(graph.vertexCount());
    for (std::size_t i = 0; i < size(); ++i) {
        for (const VertexIndex v : surface.corners(m_triangles[i]))
            placesAt[v.value].push_back(i);
    }
    // By how far they are over the surface: a hand that hangs beside the hip is not near that.
    m_near.resize(size());
    const auto link = [this](std::size_t from, std::size_t to, double weight) {
        const auto known = std::ranges::find(m_near[from], to, &Near::place);
        if (known == m_near[from].end())
            m_near[from].push_back({to, weight});
        else
            known->weight += weight;
    };
    for (std::size_t i = 0; i < size(); ++i) {
        SurfaceDistances distances(graph);
        for (const VertexIndex v : surface.corners(m_triangles[i]))
            distances.add({v, 0}, 0);
        std::vector<Near> found;
        while (found.size() < neighbours) {
            const auto reached = distances.next();
            if (!reached)
                break;
            for (const std::size_t other : placesAt[reached->vertex.value]) {
                if (other != i && std::ranges::find(found, other, &Near::place) == found.end())
                    found.push_back({other, static_cast<double>(distances.at(*reached))});
            }
        }
        for (const Near& other : found) {
            const double farthest = found.back().weight;
            const double share = farthest > 0 ? other.weight / farthest : 0;
            const double weight = std::exp(-share * share) / 2;
            link(i, other.place, weight);
            link(other.place, i, weight);
        }
    }
}

std::vector<std::optional<std::size_t>> PliableSurface::nearestPlaces(const PosedSurface& surface) const
{
    const SurfaceGraph& graph = surface.graph();
    std::vector<std::optional<std::size_t>> ofVertices(graph.vertexCount());
    struct Reached
    {
        float distance = 0;
        VertexIndex vertex;
        std::size_t place = 0;

        bool operator>(const Reached& other) const { return distance > other.distance; }
    };
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> waiting;
    for (std::size_t i = 0; i < size(); ++i) {
        for (const VertexIndex v : surface.corners(m_triangles[i]))
            waiting.push({0, v, i});
    }
    while (!waiting.empty()) {
        const Reached next = waiting.top();
        waiting.pop();
        if (ofVertices[next.vertex.value])
            continue;
        ofVertices[next.vertex.value] = next.place;
        for (const SurfaceGraph::Edge& edge : graph.edgesOf(next.vertex))
            waiting.push({next.distance + edge.length, VertexIndex(edge.to), next.place});
    }
    std::vector<std::optional<std::size_t>> ofTriangles(surface.mesh().topology->triangles().size());
    for (std::size_t t = 0; t < ofTriangles.size(); ++t) {
        const std::span<const VertexIndex> corners = surface.corners(TriangleIndex(t));
        if (!corners.empty())
            ofTriangles[t] = ofVertices[corners.front().value];
    }
    return ofTriangles;
}

void PliableSurface::scale(double factor)
{
    m_scale *= factor;
    for (std::size_t i = 0; i < size(); ++i) {
        m_starts[i] *= factor;
        m_positions[i] *= factor;
    }
}

Eigen::MatrixX3d PliableSurface::pulls(std::span<const Anchor> anchors) const
{
    Eigen::MatrixX3d sums(static_cast<Eigen::Index>(size()), 3);
    for (std::size_t i = 0; i < size(); ++i) {
        Vec3d sum = inertia * m_positions[i];
        for (const auto& [j, weight] : m_near[i])
            sum += weight / 2 * (m_growths[i] * m_turns[i] + m_growths[j] * m_turns[j]) *
                   (m_starts[i] - m_starts[j]);
        sums.row(static_cast<Eigen::Index>(i)) = sum.transpose();
    }
    for (const Anchor& anchor : anchors)
        sums.row(static_cast<Eigen::Index>(anchor.place)) +=
            anchorWeight * anchor.share * anchor.position.transpose();
    return sums;
}

std::optional<PliableSurface::Fit> PliableSurface::fit(std::size_t place, const Anchor* anchor) const
{
    Eigen::Matrix3d ways = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d alike = Eigen::Matrix3d::Zero();
    double size = 0;
    double start = 0;
    double weights = 0;
    double growth = 0;
    for (const auto& [j, weight] : m_near[place]) {
        const Vec3d now = m_positions[j] - m_positions[place];
        const Vec3d before = m_starts[j] - m_starts[place];
        ways += weight * now * before.transpose();
        size += weight * now.norm() * before.norm();
        start += weight * before.squaredNorm();
        alike += weight * m_turns[j];
        growth += weight * m_growths[j];
        weights += weight;
    }
    if (weights == 0)
        return std::nullopt;
    Eigen::Matrix3d all = ways + smoothness * size / weights * alike;
    if (anchor != nullptr)
        all += normalShare * size * anchor->share * anchor->normal * m_startNormals[place].transpose();
    Fit found{rotationOfCovariance(all).toRotationMatrix(), 1};
    const double own = start > 0 ? (found.turn.transpose() * ways).trace() / start : 1;
    found.growth =
        std::clamp(ownGrowth * own + (1 - ownGrowth) * growth / weights, 1 / mostGrowth, mostGrowth);
    return found;
}

void PliableSurface::settle(std::span<const Anchor> anchors, int rounds)
{
    const auto count = static_cast<Eigen::Index>(size());
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<const Anchor*> anchorOf(size(), nullptr);
    for (std::size_t i = 0; i < size(); ++i) {
        const auto row = static_cast<int>(i);
        entries.emplace_back(row, row, inertia);
        for (const auto& [j, weight] : m_near[i]) {
            entries.emplace_back(row, row, weight);
            entries.emplace_back(row, static_cast<int>(j), -weight);
        }
    }
    for (const Anchor& anchor : anchors) {
        const auto row = static_cast<int>(anchor.place);
        entries.emplace_back(row, row, anchorWeight * anchor.share);
        anchorOf[anchor.place] = &anchor;
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    std::vector<std::optional<Fit>> fits(size());
    for (int round = 0; round < rounds; ++round) {
        const Eigen::MatrixX3d positions = factors.solve(pulls(anchors));
        for (std::size_t i = 0; i < size(); ++i)
            m_positions[i] = positions.row(static_cast<Eigen::Index>(i)).transpose();
        for (std::size_t i = 0; i < size(); ++i)
            fits[i] = fit(i, anchorOf[i]);
        for (std::size_t i = 0; i < size(); ++i) {
            if (!fits[i])
                continue;
            m_turns[i] = fits[i]->turn;
            m_growths[i] = fits[i]->growth;
        }
    }
}

double PliableSurface::nearness(std::size_t place, const Vec3d& position, double half) const
{
    return 1 / (1 + (m_positions[place] - position).squaredNorm() / (half * half));
}

Vec3d PliableSurface::moved(std::size_t place, const Vec3d& start) const
{
    return m_positions[place] + m_growths[place] * (m_turns[place] * (m_scale * start - m_starts[place]));
}

} // namespace quadrille
