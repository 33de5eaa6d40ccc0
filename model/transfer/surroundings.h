// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacedistances.h"
#include "model/transfer/posedsurface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// How far what is about a mark reaches.
enum class PatchReach
{
    NextMark, ///< some 8 cm on a grown-up, and less than half of the way to the next mark
    Whole,    ///< 8 cm, whatever else is marked
};

/// What of a surface lies about some of its triangles.
/// Immutable; safe from any thread.
class Surroundings
{
public:
    /// \param graph  of the surface, must outlive it. \param marks  triangles of the surface.
    Surroundings(const SurfaceGraph& graph, std::span<const std::size_t> marks,
                 PatchReach reach = PatchReach::NextMark);

    struct Near
    {
        std::size_t triangle = 0;
        double weight = 0;
    };
    /// Triangles about a mark, its own first, with weights that fall to nothing where it ends, and whose
    /// sum is one. Cost: the surface distances up to there; so for `vertices`.
    std::vector<Near> triangles(std::size_t mark) const;
    /// Corners of the triangles about a mark, but for those of marks, whose corners all
    /// are: no vertex is about two marks.
    std::vector<std::uint32_t> vertices(std::size_t mark) const;

private:
    struct Reached
    {
        SurfaceDistances distances;
        std::vector<std::uint32_t> triangles; ///< at vertices that were reached, ascending
        float reach = 0;                      ///< how far what is about the mark reaches, metres
    };
    /// Grows distances from a mark over what is about it at least.
    Reached grow(std::size_t mark) const;

    const SurfaceGraph* m_graph;
    std::vector<std::size_t> m_marks;
    PatchReach m_patchReach;
    std::vector<std::size_t> m_markedAt; ///< of each vertex the marked triangle that it is a corner of
    float m_reach = 0;                   ///< metres
};

/// Triangles of a template, and which of them tell how each of its marks is deformed.
struct MarkPatches
{
    std::vector<Triangle> triangles;
    std::vector<std::vector<Surroundings::Near>> near; ///< of each mark: places in `triangles`
};

/// Marked triangles alone, as published (SCANS §4).
MarkPatches singleTriangles(std::vector<Triangle> triangles);
/// What lies about the template's triangles of some pairs; those alone that have no area.
MarkPatches patchesAbout(const PosedSurface& reference, std::span<const TrianglePair> pairs,
                         PatchReach reach);

} // namespace quadrille
