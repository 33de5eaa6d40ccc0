// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transfer/harmonicfield.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace quadrille {

/// Which numbers of the marked triangles' rotations are spread over a target.
enum class FieldKind
{
    Quaternions, ///< the components of unit quaternions, normalised afterwards (SCANS §4)
    /// Logarithms of the rotations against that of the body as a whole: a part that turns by more than 180
    /// degrees against the body goes on turning.
    Logarithms,
};

/// The rotations of all triangles of a target from those of marked ones, and how they are stretched.
/// Immutable; safe from any thread.
class DeformationField
{
public:
    /// \param system  must outlive the field. \param marks, held  as for HarmonicField.
    DeformationField(const HarmonicSystem& system, std::vector<std::size_t> marks, FieldKind kind,
                     std::span<const std::vector<std::uint32_t>> held = {});

    /// The rotations at the vertices.
    /// \param marks  those of the marked triangles, unit quaternions whose signs go together, see
    /// MarkTracker. \param root  that of the body as a whole; its sign goes with theirs. \param x  (rows + 1)
    /// × 4: quaternions w, x, y, z of any length, in the order of HarmonicSystem::rowOf.
    void solve(std::span<const Eigen::Quaterniond> marks, const Eigen::Quaterniond& root,
               std::vector<double>& x) const;
    /// The edges of all triangles, stretched by the mean of what harmonic fields make of the marks' stretches
    /// at their corners. \param marks  symmetric matrices in the axes of the pose at rest. \param x  memory.
    /// \param rest  the edges at rest.
    void stretch(std::span<const Eigen::Matrix3d> marks, std::vector<double>& x,
                 std::span<const TriangleEdges> rest, std::span<TriangleEdges> stretched) const;
    /// The edges of all triangles, turned: by the mean of the rotations at their corners, marked ones by
    /// their own. \param x  as `solve` left it. \param rest  the edges before.
    void turn(std::span<const Eigen::Quaterniond> marks, std::span<const double> x,
              std::span<const TriangleEdges> rest, std::span<TriangleEdges> turned) const;

private:
    const HarmonicSystem* m_system;
    std::vector<std::size_t> m_marks;
    FieldKind m_kind;
    HarmonicField m_field;
};

} // namespace quadrille
