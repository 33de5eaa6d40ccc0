// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/topology.h"

#include <QLineF>
#include <QList>
#include <optional>

namespace quadrille {

/// The edges of a mesh in texture coordinates (origin at the lower left), each once; at seams both sides.
/// Empty for a mesh without UVs.
/// \param material only of triangles with this material.
/// \throws Error Cancelled. Cost: O(triangles · log triangles).
QList<QLineF> uvEdges(const Topology& topology, std::optional<int> material, const Progress& progress = {});

} // namespace quadrille
