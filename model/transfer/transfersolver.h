// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"
#include "model/transfer/deformationfield.h"
#include "model/transfer/marktracker.h"
#include "model/transfer/solidtarget.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// A mesh that performances are transferred onto, with all that does not depend on marks: its surface, two
/// patterns of elimination and the factorised Poisson system. Immutable; safe from any thread.
class TransferTarget
{
public:
    /// \param positions  of all vertices in the reference pose, turned as the template's, metres.
    /// \throws Error as SolidTarget. Cost: two symbolic factorisations and a numeric one.
    TransferTarget(const Topology& mesh, Positions positions);
    TransferTarget(const TransferTarget&) = delete;
    TransferTarget& operator=(const TransferTarget&) = delete;

    const SolidTarget& surface() const { return m_surface; }
    const PoissonSystem& system() const { return m_system; }
    const PoissonPose& poisson() const { return m_poisson; }
    const HarmonicSystem& harmonic() const { return m_harmonic; }
    const SurfaceGraph& graph() const { return m_graph; }
    /// Per triangle of the surface its edges at rest.
    const std::vector<TriangleEdges>& edges() const { return m_edges; }

private:
    SolidTarget m_surface;
    SurfaceGraph m_graph;
    PoissonSystem m_system;
    PoissonPose m_poisson;
    HarmonicSystem m_harmonic;
    std::vector<TriangleEdges> m_edges;
};

/// Poses a target as the marked triangles of a template are deformed (SCANS §4): a field of rotations from
/// those of the marks, with two of stretches where these are given, then the surface whose triangles come
/// nearest to the deformed ones, by one back-substitution each. Immutable; safe from any thread, each with
/// its own scratch.
class TransferSolver
{
public:
    /// \param marks  triangles of the target's mesh, at least one, each once. \param holdsSurroundings  what
    /// lies about a mark is deformed as that, see Surroundings::vertices: else a mark counts the less the
    /// finer the mesh is. \throws Error TransferTriangleFlat where a mark was left out of the surface, or
    /// does not exist. Cost: one numeric factorisation, surface distances about each mark.
    TransferSolver(std::shared_ptr<const TransferTarget> target, std::span<const TriangleIndex> marks,
                   FieldKind kind = FieldKind::Quaternions, bool holdsSurroundings = false);

    /// Memory that poses made one after the other share.
    struct Scratch
    {
        std::vector<double> field;
        std::size_t width = 0; ///< numbers of the field at a vertex
        std::vector<double> solution;
        std::vector<TriangleEdges> edges;
        std::vector<Vec3f> surface;
    };

    /// \param out  all vertices of the target's mesh, metres, placed so that the middle of its marked
    /// triangles is at the origin.
    void pose(const MarkDeformations& deformations, MutablePositions out, Scratch& scratch) const;

private:
    void place(Scratch& scratch) const;
    Eigen::Quaterniond rotationAt(std::uint32_t vertex, const Scratch& scratch) const;

    std::shared_ptr<const TransferTarget> m_target;
    std::vector<std::size_t> m_marks; ///< triangles of the surface
    DeformationField m_field;
};

} // namespace quadrille
