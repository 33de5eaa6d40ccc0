// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"

#include <optional>
#include <vector>

namespace quadrille {

/// A closed curve through a vertex, or close by it, around the limb there: where a front that spreads from
/// the vertex first meets itself behind something. What it surrounds has to be on both sides at least about
/// as large as a half ball on the curve would be, else the front goes on. \return simple, rough; nothing
/// where there is nothing to go around.
std::optional<std::vector<VertexIndex>> loopAround(const SurfaceGraph& graph, VertexIndex through);

} // namespace quadrille
