// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/parts/bodyparts.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// What a part shares with its parent, made ready to be cut again and again: a band between the curve where
/// the part ends and the curve where the parent ends. Vertices, edges and triangles are numbered within the
/// band, vertices as in BodyPart::overlap. Immutable; safe from any thread.
class PartOverlap
{
public:
    /// \param pose  of all vertices of the mesh, metres: gives lengths and areas.
    PartOverlap(const Topology& topology, const BodyPart& part, Positions pose);

    std::size_t vertexCount() const { return m_vertexCount; }
    std::size_t edgeCount() const { return m_edges.size(); }
    std::array<std::uint32_t, 2> endsOf(std::size_t edge) const { return m_edges[edge].ends; }
    const std::vector<Triangle>& triangles() const { return m_triangles; }
    /// Of each vertex the area of the triangles around it, m²; 1 for all where no triangle has any.
    const std::vector<double>& areas() const { return m_areas; }

    /// Adds to the cost of each edge what cutting along it costs: its length times the squared difference of
    /// the two instances of the surface there – of their places, in radii of the band, and of their
    /// gradients – which counts more the nearer it lies to a rim, where there is little room to go over from
    /// one to the other. Where both are alike, short cuts in the middle cost least.
    /// \param differences  of the vertices' places between the instances, metres.
    void addCosts(std::span<const Vec3d> differences, std::span<double> costs) const;

    /// The closed curve of least cost that separates the two rims, in order. Where no curve does (rims that
    /// do not belong to one band), the curve where the part ends.
    /// \param costs  of the edges, positive. Source: Erickson & Har-Peled 2004, shortest cycles of odd parity
    /// through the vertices of a cut; the search from each stays within half the best length so far.
    std::vector<std::uint32_t> cheapestSeam(std::span<const double> costs) const;

    /// How much of each triangle comes from the part, the rest from its parent: half at the seam, falling to
    /// nothing where the part ends and rising to all where the parent ends.
    std::vector<double> shares(std::span<const std::uint32_t> seam) const;

private:
    struct Edge
    {
        std::array<std::uint32_t, 2> ends;
        double weight = 0; ///< length times what the place in the band adds, metres
        bool isEnd = false;
        bool isParentEnd = false;
        bool isCrossing = false; ///< crossed by the cut
    };
    struct Neighbour
    {
        std::uint32_t vertex;
        std::uint32_t edge;
    };
    class SeamSearch;

    void linkEdges(Positions places, const std::vector<bool>& isEnd, const std::vector<bool>& isParentEnd);
    void weighEdges();
    void weighTriangles(Positions places);
    void cutAcross();
    std::span<const Neighbour> neighboursOf(std::uint32_t vertex) const;
    /// Along the edges from some vertices; infinite where there is no way.
    std::vector<double> distancesFrom(std::span<const std::uint32_t> vertices) const;
    struct Sides
    {
        std::vector<bool> isSeam;    ///< by edge
        std::vector<bool> isParents; ///< by triangle: it lies between the seam and where the part ends
    };
    Sides sidesOf(std::span<const std::uint32_t> seam) const;

    std::size_t m_vertexCount;
    std::vector<std::uint32_t> m_end; ///< where the part ends, in order
    std::vector<Triangle> m_triangles;
    std::vector<double> m_areas;
    std::vector<std::array<double, 3>> m_gradientWeights;      ///< halved cotangents over the area, 1/m²
    std::vector<std::array<std::uint32_t, 3>> m_triangleEdges; ///< opposite the corners
    std::vector<Edge> m_edges;
    std::vector<double> m_lengths; ///< of the edges, metres
    std::vector<std::vector<std::uint32_t>> m_edgeTriangles;
    std::vector<Neighbour> m_neighbours;
    std::vector<std::uint32_t> m_neighbourStarts;
    std::vector<double> m_toEnd;          ///< of each vertex, metres
    std::vector<double> m_toParentEnd;    ///< of each vertex, metres
    std::vector<std::uint32_t> m_sources; ///< on one side of the cut: every curve around passes one of them
    double m_radius = 1;
};

} // namespace quadrille
