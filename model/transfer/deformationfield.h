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

/// How the marked triangles of a template are deformed in one frame, from the reference pose.
struct MarkDeformations
{
    std::vector<Eigen::Quaterniond> rotations; ///< unit quaternions
    Eigen::Quaterniond root;                   ///< the mean of those: the rotation of the body as a whole
    /// How they are stretched beforehand, symmetric matrices; empty where they only turn.
    std::vector<Eigen::Matrix3d> stretches;
};

/// The rotations of all triangles of a target from those of marked ones, and how they are stretched.
/// Immutable; safe from any thread.
class DeformationField
{
public:
    /// \param system  must outlive the field. \param marks, held  as for HarmonicField.
    DeformationField(const HarmonicSystem& system, std::vector<std::size_t> marks, FieldKind kind,
                     std::span<const std::vector<std::uint32_t>> held = {});

    /// The rotations at the vertices, and the stretches where there are any.
    /// \param marks  rotations of the marked triangles, unit quaternions whose signs go together, see
    /// MarkTracker; that of the body as a whole, whose sign goes with theirs; stretches, symmetric matrices
    /// in the axes of the pose at rest, or none. \param x  (rows + 1) × `width`, in the order of
    /// HarmonicSystem::rowOf: quaternions w, x, y, z of any length, then the stretches' diagonals, and what
    /// is off it (yz, xz, xy), each with a zero behind it.
    void solve(const MarkDeformations& marks, std::vector<double>& x) const;
    static std::size_t width(const MarkDeformations& marks)
    {
        return HarmonicField::lanes * (marks.stretches.empty() ? 1 : 3);
    }
    /// The edges of all triangles, stretched and turned by the means of what is at their corners, marked ones
    /// by their own. \param x  as `solve` left it. \param rest  the edges at rest.
    void deform(const MarkDeformations& marks, std::span<const double> x, std::span<const TriangleEdges> rest,
                std::span<TriangleEdges> deformed) const;

private:
    const HarmonicSystem* m_system;
    std::vector<std::size_t> m_marks;
    FieldKind m_kind;
    HarmonicField m_field;
};

} // namespace quadrille
