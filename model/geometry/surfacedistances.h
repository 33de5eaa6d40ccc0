// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/crosscut.h"

#include <limits>
#include <optional>
#include <vector>

namespace quadrille {

/// The length of a way where there is none, metres.
constexpr float noWay = std::numeric_limits<float>::infinity();

/// A vertex on one of the sheets of an opened surface; 0 is where ways begin.
struct SheetVertex
{
    VertexIndex vertex;
    int sheet = 0;

    bool operator==(const SheetVertex&) const = default;
};

/// The surface that ways may use: as a whole, or opened along a cut.
struct OpenedSurface
{
    static constexpr int sheetsEachWay = 2;

    const SurfaceGraph* graph;
    const CrossCut* cut = nullptr;
    /// Vertices that may be used; all where there is none.
    const std::vector<bool>* within = nullptr;

    std::size_t sheets() const { return cut ? 2U * sheetsEachWay + 1 : 1; }
    std::size_t places() const { return graph->vertexCount() * sheets(); }
    std::size_t place(SheetVertex v) const
    {
        return cut ? v.vertex.value * sheets() + static_cast<std::size_t>(v.sheet + sheetsEachWay)
                   : v.vertex.value;
    }
    /// The end of an edge, or nothing where it leads off the sheets or out of what may be used.
    std::optional<SheetVertex> step(SheetVertex from, VertexIndex to) const
    {
        if (within && !(*within)[to.value])
            return std::nullopt;
        if (!cut)
            return SheetVertex{to, 0};
        const int sheet = from.sheet + cut->crossing(from.vertex, to);
        if (sheet < -sheetsEachWay || sheet > sheetsEachWay)
            return std::nullopt;
        return SheetVertex{to, sheet};
    }
};

/// Distances over a surface from some of its vertices: a front that grows across triangles, from each pair of
/// neighbours as if their distances came from one point in the triangle's plane, with corrections where a
/// better way comes later (triangles with wide angles). Exact in a plane with one source. Source: Novotni &
/// Klein, Computing geodesic distances on triangular meshes, 2002.
class SurfaceDistances
{
public:
    explicit SurfaceDistances(const SurfaceGraph& graph) : SurfaceDistances(OpenedSurface{&graph}) {}
    explicit SurfaceDistances(const OpenedSurface& surface);

    void add(SheetVertex source, float distance);
    /// The next nearest vertex is reached, or one that was reached is corrected; nothing when all are.
    std::optional<SheetVertex> next();
    /// Goes on until everything up to a distance is reached.
    void growTo(float limit);
    /// Goes on until a vertex is reached and some surroundings of the shortest way to it are.
    /// \return its distance; infinite where it lies beyond the limit or no way leads there.
    float growUntil(SheetVertex target, float limit);

    /// Infinite where nothing came yet.
    float at(SheetVertex v) const { return m_distances[m_surface.place(v)]; }
    float at(std::size_t place) const { return m_distances[place]; }
    /// Of the vertices that the shortest way to one comes between, the nearer one; sources have themselves.
    VertexIndex before(SheetVertex v) const { return m_before[m_surface.place(v)]; }

private:
    struct Waiting
    {
        float distance;
        SheetVertex vertex;
        bool operator>(const Waiting& other) const { return distance > other.distance; }
    };
    void push(SheetVertex v, float distance, VertexIndex before);
    void spread(SheetVertex from);
    void across(SheetVertex a, SheetVertex b, SheetVertex to);

    OpenedSurface m_surface;
    std::vector<float> m_distances;
    std::vector<VertexIndex> m_before;
    std::vector<Waiting> m_waiting; ///< a heap, the nearest first
};

} // namespace quadrille
