// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <vector>

namespace quadrille::test {

/// A rectangle of an atlas, in texels of it from the upper left corner.
struct Rectangle
{
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/// A mesh that shows rectangles of an atlas: two triangles and four UVs each.
inline TopologyData atlasOf(const std::vector<Rectangle>& rectangles, double width, double height)
{
    TopologyData data;
    for (const Rectangle& r : rectangles) {
        const std::uint32_t first = data.vertexCount;
        data.vertexCount += 4;
        const auto put = [&](double x, double y) {
            data.uvs.emplace_back(static_cast<float>(x / width), static_cast<float>(1 - y / height));
        };
        put(r.left, r.bottom);
        put(r.right, r.bottom);
        put(r.right, r.top);
        put(r.left, r.top);
        for (const std::array<std::uint32_t, 3> t : {std::array{0U, 1U, 2U}, std::array{0U, 2U, 3U}}) {
            data.triangleUvs.push_back({first + t[0], first + t[1], first + t[2]});
            data.triangles.push_back(
                {VertexIndex(first + t[0]), VertexIndex(first + t[1]), VertexIndex(first + t[2])});
        }
    }
    return data;
}

} // namespace quadrille::test
