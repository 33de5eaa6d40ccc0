// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"

#include <cmath>
#include <memory>

namespace quadrille {

/// A closed double pyramid of six vertices (plus one that no triangle uses) with a UV seam and two materials;
/// in each frame its tips wander, the rest stands still.
inline MeshSequence wanderingPyramid(std::int64_t frames)
{
    TopologyData data;
    data.vertexCount = 7;
    data.materials = {"upper", "lower"};
    data.uvs.emplace_back(0.5F, 1.0F);
    data.uvs.emplace_back(0.5F, 0.0F);
    for (int i = 0; i <= 4; ++i)
        data.uvs.emplace_back(static_cast<float>(i) / 4, 0.5F);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const VertexIndex a(1 + i);
        const VertexIndex b(1 + (i + 1) % 4);
        data.triangles.push_back({VertexIndex(0), a, b});
        data.triangleUvs.push_back({0, 2 + i, 3 + i});
        data.triangleMaterials.push_back(0);
        data.triangles.push_back({VertexIndex(5), b, a});
        data.triangleUvs.push_back({1, 3 + i, 2 + i});
        data.triangleMaterials.push_back(1);
    }
    std::vector<Vec3f> positions;
    for (std::int64_t f = 0; f < frames; ++f) {
        const float t = static_cast<float>(f) * 0.3F;
        positions.insert(positions.end(), {Vec3f(std::sin(t), 1.1F + 0.1F * t, 0), Vec3f(1, 0, 0),
                                           Vec3f(0, 0, -1), Vec3f(-1, 0, 0), Vec3f(0, 0, 1),
                                           Vec3f(0, -1, std::cos(t) - 1), Vec3f(0.25F, 0.5F, 0.75F)});
    }
    return makeSequence("pyramid", std::make_shared<const Topology>(std::move(data)),
                        std::make_shared<MemoryFrames>(std::move(positions), 7U), 24.0);
}

/// A small picture of one colour.
inline std::shared_ptr<const Image> plainImage(std::uint8_t red)
{
    Image image(4, 4);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        image.pixels[i] = red;
        image.pixels[i + 3] = 255;
    }
    return std::make_shared<const Image>(std::move(image));
}

} // namespace quadrille
