// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/deformationfield.h"

#include "model/core/simd.h"

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

/// Turns logarithms into quaternions, in place.
void exponentiate(const Eigen::Quaterniond& root, std::vector<double>& x)
{
    for (std::size_t at = 0; at + HarmonicField::lanes < x.size(); at += HarmonicField::lanes) {
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

QUADRILLE_SIMD_CLONES void turnTriangles(std::size_t count, const std::array<int, 3>* rows, const double* x,
                                         const TriangleEdges* rest, TriangleEdges* turned)
{
    for (std::size_t t = 0; t < count; ++t) {
        const double* const a = x + HarmonicField::lanes * static_cast<std::size_t>(rows[t][0]);
        const double* const b = x + HarmonicField::lanes * static_cast<std::size_t>(rows[t][1]);
        const double* const c = x + HarmonicField::lanes * static_cast<std::size_t>(rows[t][2]);
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
        const double* const e = rest[t].first.data();
        const double* const f = rest[t].second.data();
        double* const g = turned[t].first.data();
        double* const h = turned[t].second.data();
        for (std::size_t i = 0; i < 3; ++i) {
            g[i] = m[i] * e[0] + m[3 + i] * e[1] + m[6 + i] * e[2];
            h[i] = m[i] * f[0] + m[3 + i] * f[1] + m[6 + i] * f[2];
        }
        g[3] = 0;
        h[3] = 0;
    }
}

/// Adds what three of the six numbers of symmetric matrices make of the edges: the diagonal, or what is off
/// it (yz, xz, xy).
template <bool diagonal>
void stretchTriangles(std::size_t count, const std::array<int, 3>* rows, const double* x,
                      const TriangleEdges* rest, TriangleEdges* stretched)
{
    for (std::size_t t = 0; t < count; ++t) {
        const double* const a = x + HarmonicField::lanes * static_cast<std::size_t>(rows[t][0]);
        const double* const b = x + HarmonicField::lanes * static_cast<std::size_t>(rows[t][1]);
        const double* const c = x + HarmonicField::lanes * static_cast<std::size_t>(rows[t][2]);
        std::array<double, 3> s{};
        for (std::size_t i = 0; i < 3; ++i)
            s[i] = (a[i] + b[i] + c[i]) / 3;
        for (const auto edge : {&TriangleEdges::first, &TriangleEdges::second}) {
            const double* const e = (rest[t].*edge).data();
            double* const out = (stretched[t].*edge).data();
            if constexpr (diagonal) {
                for (std::size_t i = 0; i < 3; ++i)
                    out[i] = s[i] * e[i];
                out[3] = 0;
            } else {
                out[0] += s[2] * e[1] + s[1] * e[2];
                out[1] += s[2] * e[0] + s[0] * e[2];
                out[2] += s[1] * e[0] + s[0] * e[1];
            }
        }
    }
}

} // namespace

DeformationField::DeformationField(const HarmonicSystem& system, std::vector<std::size_t> marks,
                                   FieldKind kind, std::span<const std::vector<std::uint32_t>> held)
    : m_system(&system), m_marks(std::move(marks)), m_kind(kind), m_field(system, m_marks, held)
{
}

void DeformationField::solve(std::span<const Eigen::Quaterniond> marks, const Eigen::Quaterniond& root,
                             std::vector<double>& x) const
{
    std::vector<HarmonicField::Value> values;
    values.reserve(marks.size());
    for (const Eigen::Quaterniond& q : marks) {
        values.push_back(m_kind == FieldKind::Logarithms ? logarithmOf(root.conjugate() * q)
                                                         : HarmonicField::Value{q.w(), q.x(), q.y(), q.z()});
    }
    m_field.solve(values, x);
    if (m_kind == FieldKind::Logarithms)
        exponentiate(root, x);
}

void DeformationField::stretch(std::span<const Eigen::Matrix3d> marks, std::vector<double>& x,
                               std::span<const TriangleEdges> rest, std::span<TriangleEdges> stretched) const
{
    std::vector<HarmonicField::Value> values;
    values.reserve(marks.size());
    for (const Eigen::Matrix3d& s : marks)
        values.push_back({s(0, 0), s(1, 1), s(2, 2), 0});
    m_field.solve(values, x);
    stretchTriangles<true>(rest.size(), m_system->triangleRows().data(), x.data(), rest.data(),
                           stretched.data());
    for (std::size_t m = 0; m < marks.size(); ++m)
        values[m] = {marks[m](1, 2), marks[m](0, 2), marks[m](0, 1), 0};
    m_field.solve(values, x);
    stretchTriangles<false>(rest.size(), m_system->triangleRows().data(), x.data(), rest.data(),
                            stretched.data());
}

void DeformationField::turn(std::span<const Eigen::Quaterniond> marks, std::span<const double> x,
                            std::span<const TriangleEdges> rest, std::span<TriangleEdges> turned) const
{
    turnTriangles(rest.size(), m_system->triangleRows().data(), x.data(), rest.data(), turned.data());
    for (std::size_t m = 0; m < m_marks.size(); ++m) {
        const TriangleEdges& edges = rest[m_marks[m]];
        TriangleEdges& out = turned[m_marks[m]];
        Vec3d::Map(out.first.data()) = marks[m] * Vec3d::Map(edges.first.data());
        Vec3d::Map(out.second.data()) = marks[m] * Vec3d::Map(edges.second.data());
    }
}

} // namespace quadrille
