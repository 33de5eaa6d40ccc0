// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// A closed curve through a vertex, or close by it, around the limb there: where a front that spreads from
/// the vertex first meets itself behind something. What it surrounds has to be on both sides at least about
/// as large as a half ball on the curve would be, else the front goes on. \return simple, rough; nothing
/// where there is nothing to go around.
std::optional<std::vector<VertexIndex>> loopAround(const SurfaceGraph& graph, VertexIndex through);

/// Tells closed curves that go around something from those that are folded together or surround a patch.
class CurveWorth
{
public:
    explicit CurveWorth(const SurfaceGraph& graph);

    /// Whether a curve of this length separates two pieces that are each at least about as large as a half
    /// ball on it would be. \param curve  simple, closed.
    bool surroundsSomething(std::span<const VertexIndex> curve, float length);

private:
    bool isOpen(std::span<const VertexIndex> curve, float length) const;
    bool isLarge(std::span<const VertexIndex> curve, bool isLeft, float area);

    const SurfaceGraph& m_graph;
    std::vector<std::uint32_t> m_next;  ///< along the curve, while it is looked at
    std::vector<std::uint32_t> m_visit; ///< per triangle the number of the last look at it
    std::uint32_t m_look = 0;
};

} // namespace quadrille
