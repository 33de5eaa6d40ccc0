// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/legdeformation.h"

#include "model/geometry/procrustes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace quadrille {

namespace {

/// Turns of rotations and solve: the first few take out nearly all of the stretch.
constexpr int rounds = 8;

enum Role : std::uint8_t
{
    Outside,
    Free,
    OfFoot,
};

/// Half the cotangent of the angle at a corner, at least a little, so that slivers do no harm.
double halfCotangent(const Vec3d& corner, const Vec3d& a, const Vec3d& b)
{
    const Vec3d u = a - corner;
    const Vec3d v = b - corner;
    const double sine = u.cross(v).norm();
    return sine > 0 ? std::clamp(0.5 * u.dot(v) / sine, 0.05, 5.0) : 0.05;
}

} // namespace

LegDeformation::LegDeformation(const Topology& topology, std::span<const std::uint32_t> leg,
                               std::span<const std::uint32_t> foot, Positions reference)
{
    std::vector<std::uint8_t> role(topology.vertexCount(), Outside);
    for (const std::uint32_t v : leg)
        role[v] = Free;
    for (const std::uint32_t v : foot)
        role[v] = OfFoot;
    for (const std::uint32_t v : leg) {
        if (role[v] == Free)
            m_vertices.push_back(v);
    }
    m_freeCount = m_vertices.size();
    m_vertices.insert(m_vertices.end(), foot.begin(), foot.end());
    m_footCount = foot.size();
    collectEdges(topology, reference, role);
    factorise();
}

void LegDeformation::collectEdges(const Topology& topology, Positions reference,
                                  std::span<const std::uint8_t> role)
{
    std::map<std::uint32_t, std::uint32_t> local;
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
        local[m_vertices[i]] = static_cast<std::uint32_t>(i);
    const auto localOf = [&](std::uint32_t v) {
        const auto [place, isNew] = local.try_emplace(v, static_cast<std::uint32_t>(m_vertices.size()));
        if (isNew)
            m_vertices.push_back(v);
        return place->second;
    };
    std::vector<std::map<std::uint32_t, double>> weights(m_freeCount);
    for (const Triangle& t : topology.triangles()) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = t[(c + 1) % 3].value;
            const std::uint32_t b = t[(c + 2) % 3].value;
            if (role[a] != Free && role[b] != Free)
                continue;
            const double weight = halfCotangent(reference[t[c].value].cast<double>(),
                                                reference[a].cast<double>(), reference[b].cast<double>());
            if (role[a] == Free)
                weights[localOf(a)][localOf(b)] += weight;
            if (role[b] == Free)
                weights[localOf(b)][localOf(a)] += weight;
        }
    }
    for (const auto& around : weights) {
        m_neighbourStarts.push_back(m_neighbours.size());
        for (const auto& [vertex, weight] : around)
            m_neighbours.push_back({vertex, weight});
    }
    m_neighbourStarts.push_back(m_neighbours.size());
}

std::span<const LegDeformation::Neighbour> LegDeformation::neighboursOf(std::size_t vertex) const
{
    return std::span(m_neighbours)
        .subspan(m_neighbourStarts[vertex], m_neighbourStarts[vertex + 1] - m_neighbourStarts[vertex]);
}

void LegDeformation::factorise()
{
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd toFoot = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_freeCount));
    for (std::size_t v = 0; v < m_freeCount; ++v) {
        const auto row = static_cast<int>(v);
        // A vertex that hangs on nothing stays.
        double sum = neighboursOf(v).empty() ? 1 : 0;
        for (const Neighbour& n : neighboursOf(v)) {
            sum += n.weight;
            if (n.vertex < m_freeCount)
                entries.emplace_back(row, static_cast<int>(n.vertex), -n.weight);
            else if (n.vertex < m_freeCount + m_footCount)
                toFoot[row] += n.weight;
        }
        // A piece that neither hangs on the foot nor on the body must not make the matrix singular.
        entries.emplace_back(row, row, sum * (1 + 1e-9));
    }
    const auto size = static_cast<Eigen::Index>(m_freeCount);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    m_factor.compute(matrix);
    const Eigen::VectorXd field = m_factor.solve(toFoot);
    m_field.assign(field.begin(), field.end());
}

std::vector<Eigen::Quaterniond> LegDeformation::rotations(const Points& rest, const Points& now,
                                                          const Eigen::Quaterniond& ofFoot) const
{
    std::vector<Eigen::Quaterniond> found(rest.size(), Eigen::Quaterniond::Identity());
    std::fill_n(found.begin() + static_cast<std::ptrdiff_t>(m_freeCount), m_footCount, ofFoot);
    for (std::size_t v = 0; v < m_freeCount; ++v) {
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for (const Neighbour& n : neighboursOf(v))
            covariance.noalias() +=
                n.weight * (now[n.vertex] - now[v]) * (rest[n.vertex] - rest[v]).transpose();
        found[v] = rotationOfCovariance(covariance);
    }
    return found;
}

void LegDeformation::solve(const Points& rest, std::span<const Eigen::Quaterniond> rotations,
                           Points& now) const
{
    std::vector<Eigen::Matrix3d> matrices;
    matrices.reserve(rotations.size());
    for (const Eigen::Quaterniond& rotation : rotations)
        matrices.push_back(rotation.toRotationMatrix());
    Eigen::MatrixX3d right(static_cast<Eigen::Index>(m_freeCount), 3);
    for (std::size_t v = 0; v < m_freeCount; ++v) {
        Vec3d sum = neighboursOf(v).empty() ? rest[v] : Vec3d::Zero();
        for (const Neighbour& n : neighboursOf(v)) {
            sum += 0.5 * n.weight * ((matrices[v] + matrices[n.vertex]) * (rest[v] - rest[n.vertex]));
            if (n.vertex >= m_freeCount)
                sum += n.weight * now[n.vertex];
        }
        right.row(static_cast<Eigen::Index>(v)) = sum.transpose();
    }
    const Eigen::MatrixX3d solved = m_factor.solve(right);
    for (std::size_t v = 0; v < m_freeCount; ++v)
        now[v] = solved.row(static_cast<Eigen::Index>(v)).transpose();
}

void LegDeformation::apply(const FootShift& shift, const Ground& ground, MutablePositions pose) const
{
    Points rest;
    rest.reserve(m_vertices.size());
    for (const std::uint32_t v : m_vertices)
        rest.push_back(pose[v].cast<double>());
    Points now = rest;
    for (std::size_t v = 0; v < m_freeCount + m_footCount; ++v) {
        const double share = v < m_freeCount ? m_field[v] : 1;
        now[v] += share * (shift(rest[v], ground) - rest[v]);
    }
    const Eigen::Quaterniond ofFoot(Eigen::AngleAxisd(shift.turn, ground.up()));
    for (int round = 0; round < rounds && m_freeCount > 0; ++round)
        solve(rest, rotations(rest, now, ofFoot), now);
    for (std::size_t v = 0; v < m_freeCount + m_footCount; ++v)
        pose[m_vertices[v]] = now[v].cast<float>();
}

} // namespace quadrille
