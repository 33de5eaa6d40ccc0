// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/deformationfield.h"

#include <cmath>

namespace quadrille {

namespace {

/// The logarithm of a rotation, radians about its axis; from 0 to 2π, as the quaternion's sign says.
HarmonicField::Value logarithmOf(const Eigen::Quaterniond& rotation)
{
    const double sine = rotation.vec().norm();
    if (sine == 0)
        return {};
    const Vec3d log = rotation.vec() * (2 * std::atan2(sine, rotation.w()) / sine);
    return {log.x(), log.y(), log.z(), 0};
}

/// Turns logarithms into quaternions, in place. \param width  numbers of a vertex.
void exponentiate(const Eigen::Quaterniond& root, std::vector<double>& x, std::size_t width)
{
    for (std::size_t at = 0; at + width < x.size(); at += width) {
        const Vec3d log = Vec3d::Map(&x[at]);
        const double angle = log.norm();
        const double perAngle = angle > 1e-12 ? std::sin(0.5 * angle) / angle : 0.5;
        Eigen::Quaterniond turn;
        turn.w() = std::cos(0.5 * angle);
        turn.vec() = perAngle * log;
        turn = root * turn;
        x[at] = turn.w();
        Vec3d::Map(&x[at + 1]) = turn.vec();
    }
}

/// An edge that a symmetric matrix stretches. \param s  sums over three corners, as the field has them.
std::array<double, 3> stretched(const std::array<double, 8>& s, const std::array<double, 4>& e)
{
    constexpr double third = 1.0 / 3;
    return {third * (s[0] * e[0] + s[6] * e[1] + s[5] * e[2]),
            third * (s[6] * e[0] + s[1] * e[1] + s[4] * e[2]),
            third * (s[5] * e[0] + s[4] * e[1] + s[2] * e[2])};
}

/// \param x  of each row a quaternion, then a stretch where there are any.
template <bool stretches>
void deformTriangles(std::span<const std::array<int, 3>> rows, const double* x, const TriangleEdges* rest,
                     TriangleEdges* deformed)
{
    constexpr std::size_t width = HarmonicField::lanes * (stretches ? 3 : 1);
    for (std::size_t t = 0; t < rows.size(); ++t) {
        const double* const a = x + width * static_cast<std::size_t>(rows[t][0]);
        const double* const b = x + width * static_cast<std::size_t>(rows[t][1]);
        const double* const c = x + width * static_cast<std::size_t>(rows[t][2]);
        const double qw = a[0] + b[0] + c[0];
        const double qx = a[1] + b[1] + c[1];
        const double qy = a[2] + b[2] + c[2];
        const double qz = a[3] + b[3] + c[3];
        // The matrix of a quaternion of any length: its square divides out.
        const double s = 2 / (qw * qw + qx * qx + qy * qy + qz * qz);
        const std::array<double, 9> m{
            1 - s * (qy * qy + qz * qz), s * (qx * qy + qw * qz),     s * (qx * qz - qw * qy),
            s * (qx * qy - qw * qz),     1 - s * (qx * qx + qz * qz), s * (qy * qz + qw * qx),
            s * (qx * qz + qw * qy),     s * (qy * qz - qw * qx),     1 - s * (qx * qx + qy * qy)};
        std::array<double, 3> e{rest[t].first[0], rest[t].first[1], rest[t].first[2]};
        std::array<double, 3> f{rest[t].second[0], rest[t].second[1], rest[t].second[2]};
        if constexpr (stretches) {
            std::array<double, 8> sums{};
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i] = a[4 + i] + b[4 + i] + c[4 + i];
            e = stretched(sums, rest[t].first);
            f = stretched(sums, rest[t].second);
        }
        double* const g = deformed[t].first.data();
        double* const h = deformed[t].second.data();
        for (std::size_t i = 0; i < 3; ++i) {
            g[i] = m[i] * e[0] + m[3 + i] * e[1] + m[6 + i] * e[2];
            h[i] = m[i] * f[0] + m[3 + i] * f[1] + m[6 + i] * f[2];
        }
        g[3] = 0;
        h[3] = 0;
    }
}

} // namespace

DeformationField::DeformationField(const HarmonicSystem& system, std::vector<std::size_t> marks,
                                   FieldKind kind, std::span<const std::vector<std::uint32_t>> held)
    : m_system(&system), m_marks(std::move(marks)), m_kind(kind), m_field(system, m_marks, held)
{
}

void DeformationField::solve(const MarkDeformations& marks, std::vector<double>& x) const
{
    std::vector<HarmonicField::Value> values;
    values.reserve(marks.rotations.size() + 2 * marks.stretches.size());
    for (std::size_t m = 0; m < marks.rotations.size(); ++m) {
        const Eigen::Quaterniond& q = marks.rotations[m];
        values.push_back(m_kind == FieldKind::Logarithms ? logarithmOf(marks.root.conjugate() * q)
                                                         : HarmonicField::Value{q.w(), q.x(), q.y(), q.z()});
        if (marks.stretches.empty())
            continue;
        const Eigen::Matrix3d& s = marks.stretches[m];
        values.push_back({s(0, 0), s(1, 1), s(2, 2), 0});
        values.push_back({s(1, 2), s(0, 2), s(0, 1), 0});
    }
    m_field.solve(values, x);
    if (m_kind == FieldKind::Logarithms)
        exponentiate(marks.root, x, width(marks));
}

void DeformationField::deform(const MarkDeformations& marks, std::span<const double> x,
                              std::span<const TriangleEdges> rest, std::span<TriangleEdges> deformed) const
{
    (marks.stretches.empty() ? deformTriangles<false> : deformTriangles<true>)(m_system->triangleRows(),
                                                                               x.data(), rest.data(),
                                                                               deformed.data());
    for (std::size_t m = 0; m < m_marks.size(); ++m) {
        Eigen::Matrix3d own = marks.rotations[m].toRotationMatrix();
        if (!marks.stretches.empty())
            own *= marks.stretches[m];
        const TriangleEdges& edges = rest[m_marks[m]];
        TriangleEdges& out = deformed[m_marks[m]];
        Vec3d::Map(out.first.data()) = own * Vec3d::Map(edges.first.data());
        Vec3d::Map(out.second.data()) = own * Vec3d::Map(edges.second.data());
    }
}

} // namespace quadrille
