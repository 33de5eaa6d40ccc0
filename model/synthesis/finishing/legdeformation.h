// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"
#include "model/synthesis/finishing/footpath.h"

#include <Eigen/SparseCholesky>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Moves the foot of a leg and lets the leg follow as rigidly as it can: alternating best rotations of the
/// vertices and one linear solve (Sorkine and Alexa 2007), from a harmonic field between foot and hip.
/// The matrix is that of one reference pose, factorised once. Immutable; safe from any thread.
class LegDeformation
{
public:
    /// \param leg  vertices up to the hip, with those of the foot. \param foot  that moves as a whole. Both
    /// ascending. \param reference  all vertices.
    LegDeformation(const Topology& topology, std::span<const std::uint32_t> leg,
                   std::span<const std::uint32_t> foot, Positions reference);

    /// Deforms a pose in place.
    void apply(const FootShift& shift, const Ground& ground, MutablePositions pose) const;

private:
    struct Neighbour
    {
        std::uint32_t vertex = 0; ///< local
        double weight = 0;
    };
    void collectEdges(const Topology& topology, Positions reference, std::span<const std::uint8_t> role);
    void factorise();
    std::span<const Neighbour> neighboursOf(std::size_t vertex) const;
    using Points = std::vector<Vec3d>;
    std::vector<Eigen::Quaterniond> rotations(const Points& rest, const Points& now,
                                              const Eigen::Quaterniond& ofFoot) const;
    void solve(const Points& rest, std::span<const Eigen::Quaterniond> rotations, Points& now) const;

    // Local vertices: those that are free, then those of the foot, then those around that stay.
    std::size_t m_freeCount = 0;
    std::size_t m_footCount = 0;
    std::vector<std::uint32_t> m_vertices;      ///< of the mesh
    std::vector<std::size_t> m_neighbourStarts; ///< of free vertices in m_neighbours
    std::vector<Neighbour> m_neighbours;
    std::vector<double> m_field; ///< of free vertices: 1 at the foot, 0 at the hip
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;
};

} // namespace quadrille
