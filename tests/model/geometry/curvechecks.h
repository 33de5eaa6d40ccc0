// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/model/geometry/surfaces.h"

namespace quadrille::test {

/// Each vertex once, each next to the following one.
inline bool isSimpleLoop(const SurfaceGraph& graph, const std::vector<VertexIndex>& curve)
{
    bool isClosed = curve.size() >= 3;
    for (std::size_t i = 0; i < curve.size(); ++i)
        isClosed = isClosed && graph.haveEdge(curve[i], curve[(i + 1) % curve.size()]);
    return isClosed && setOf(curve).size() == curve.size();
}

inline bool separates(const SurfaceGraph& graph, const std::vector<VertexIndex>& curve)
{
    return curveSides(graph.topology(), graph.around(), curve).has_value();
}

} // namespace quadrille::test
