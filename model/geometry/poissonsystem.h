// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poseframes.h"
#include "model/geometry/sparsecholesky.h"
#include "model/sequence/topology.h"

#include <memory>
#include <vector>

namespace quadrille {

/// Two edges of a triangle after a deformation: v1 − v3 and v2 − v3; the fourth numbers are not used.
/// The gradient of the positions in the triangle says the same (SMCAS eq. 3).
struct alignas(64) TriangleEdges
{
    std::array<double, 4> first;
    std::array<double, 4> second;
};

/// What the Poisson systems (SMCAS eq. 7) of all poses of one topology share: which entries there are, how
/// they are eliminated, one pinned vertex in each connected component. Immutable; safe from any thread.
class PoissonSystem
{
public:
    /// Cost: one symbolic factorisation.
    explicit PoissonSystem(const std::shared_ptr<const Topology>& topology);

    /// Two triangles at one edge.
    using DualEdge = std::array<int, 2>;

    const Topology& topology() const { return *m_topology; }
    std::size_t triangleCount() const { return m_topology->triangles().size(); }
    std::size_t vertexCount() const { return m_topology->vertexCount(); }
    int rowCount() const { return m_pattern.size(); }
    const CholeskyPattern& pattern() const { return m_pattern; }
    /// Per vertex its row of the factor; pinned and unused ones have row rowCount().
    const std::vector<int>& rows() const { return m_rows; }
    /// Per triangle the rows of its corners.
    const std::vector<std::array<int, 3>>& triangleRows() const { return m_triangleRows; }
    /// Per triangle the values of the matrix that the edges opposite its corners add to; each has the weight
    /// subtracted. One past the last value stands for edges that the matrix does not have.
    const std::vector<std::array<int, 3>>& triangleValues() const { return m_triangleValues; }
    const std::vector<DualEdge>& dualEdges() const { return m_dualEdges; }
    /// Per triangle its neighbours over an edge: from neighbourStarts()[m] to neighbourStarts()[m + 1].
    const std::vector<int>& neighbours() const { return m_neighbours; }
    const std::vector<int>& neighbourStarts() const { return m_neighbourStarts; }
    /// Vertices of each connected component.
    const std::vector<int>& componentSizes() const { return m_componentSizes; }

private:
    struct Numbering;
    PoissonSystem(std::shared_ptr<const Topology> topology, const Numbering& numbering);
    void linkTriangles(const std::vector<std::array<int, 3>>& triangleEdges, std::size_t edgeCount);

    std::shared_ptr<const Topology> m_topology;
    CholeskyPattern m_pattern;
    std::vector<int> m_rows;
    std::vector<std::array<int, 3>> m_triangleRows;
    std::vector<std::array<int, 3>> m_triangleValues;
    std::vector<DualEdge> m_dualEdges;
    std::vector<int> m_neighbours;
    std::vector<int> m_neighbourStarts;
    std::vector<int> m_componentSizes;
};

/// The Poisson system of one rest pose, factorised: finds the surface whose triangles come nearest, by area,
/// to given deformed ones. Immutable after construction; safe from any thread. The system must outlive it.
class PoissonPose
{
public:
    /// \param frames  of the rest pose; triangles without area weigh like equilateral ones.
    /// Cost: one numeric factorisation.
    PoissonPose(const PoissonSystem& system, const PoseFrames& frames);

    /// Solves GᵀDG·v = GᵀD·G̃ for all three coordinates.
    /// \param edges  per triangle its deformed edges.
    /// \param x  (rowCount() + 1) × 4: where PoissonSystem::rows says, a vertex's coordinates relative to the
    /// pinned vertex of its component; the last row, of pinned vertices, is zero.
    void solve(std::span<const TriangleEdges> edges, std::vector<double>& x) const;

    /// Per triangle half the cotangents at its corners.
    const std::vector<std::array<double, 3>>& weights() const { return m_weights; }

private:
    const PoissonSystem* m_system;
    std::vector<std::array<double, 3>> m_weights;
    CholeskyFactor m_factor;
};

} // namespace quadrille
