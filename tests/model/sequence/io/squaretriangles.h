// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <vector>

namespace quadrille {

inline Triangle triangleOf(int a, int b, int c)
{
    return {VertexIndex(a), VertexIndex(b), VertexIndex(c)};
}

/// Of a square whose corners are named one after the other.
inline const std::vector<Triangle> squareTriangles{triangleOf(0, 1, 2), triangleOf(0, 2, 3)};

} // namespace quadrille
