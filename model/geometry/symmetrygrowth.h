// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/faceedges.h"
#include "model/geometry/symmetry.h"
#include "model/sequence/topology.h"

#include <optional>
#include <vector>

namespace quadrille {

/// An involution of the vertices that maps faces to faces of reversed orientation.
struct GrownSymmetry
{
    std::vector<VertexIndex> opposite;
    /// How much edges differ in length from their counterparts, root mean square, shares of their own.
    double lengthError = 0;
};

/// The one that keeps the lengths of edges best; nothing where there is none.
/// \param plane  to reflect across, if it is known: components that are alike go where it takes them.
std::optional<GrownSymmetry> grownSymmetry(const Topology& topology, const FaceEdges& edges, Positions pose,
                                           const std::optional<ReflectionPlane>& plane,
                                           const Progress& progress);

/// Whether several components are as large as the largest.
bool hasTwins(const Topology& topology);

} // namespace quadrille
