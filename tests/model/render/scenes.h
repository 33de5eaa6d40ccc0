// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/render/camera.h"
#include "model/sequence/meshsequence.h"

#include <memory>
#include <vector>

namespace quadrille::test {

/// Triangles with their corners.
struct Mesh
{
    std::vector<Vec3f> positions;
    std::vector<Triangle> triangles;

    void add(const Vec3f& a, const Vec3f& b, const Vec3f& c)
    {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), {a, b, c});
        triangles.push_back({VertexIndex(first), VertexIndex(first + 1), VertexIndex(first + 2)});
    }
};

/// Two triangles from (x0, y0) to (x1, y1) at height z, seen counter-clockwise from +z; UVs 0 … 1.
inline TopologyData quadTopology()
{
    TopologyData data;
    data.vertexCount = 4;
    data.triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)},
                      {VertexIndex(0), VertexIndex(2), VertexIndex(3)}};
    data.uvs = {Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1), Vec2f(0, 1)};
    data.triangleUvs = {{0, 1, 2}, {0, 2, 3}};
    return data;
}
inline std::vector<Vec3f> quadPositions(float x0, float y0, float x1, float y1, float z = 0)
{
    return {Vec3f(x0, y0, z), Vec3f(x1, y0, z), Vec3f(x1, y1, z), Vec3f(x0, y1, z)};
}

/// Looks along −z with a right angle of view from `distance` before the plane z = 0: in a square picture of
/// 2 × distance samples, one sample is one unit of that plane and its middle lies in the picture's middle.
inline Camera unitCamera(double distance)
{
    Camera camera;
    camera.eye = {0, 0, distance};
    camera.target = {0, 0, 0};
    camera.verticalFovDegrees = 90;
    camera.nearDistance = 0.5;
    return camera;
}

/// A bumpy ball of one metre above the ground, with a texture, that travels along x and spins.
inline MeshSequence ball(int rings, int frames)
{
    const int columns = 2 * rings;
    TopologyData data;
    std::vector<Vec3f> unit;
    for (int r = 0; r <= rings; ++r) {
        const auto [height, width] = sineCosine(0.5 * r / rings - 0.25);
        for (int c = 0; c < columns; ++c) {
            const auto [s, k] = sineCosine(static_cast<double>(c) / columns);
            const double radius = 0.5 + 0.04 * sineCosine(3.0 * c / columns).sine * width;
            unit.emplace_back(Vec3d(radius * width * s, radius * height, radius * width * k).cast<float>());
        }
        for (int c = 0; c <= columns; ++c)
            data.uvs.emplace_back(static_cast<float>(c) / static_cast<float>(columns),
                                  static_cast<float>(r) / static_cast<float>(rings));
    }
    const auto corner = [columns](int r, int c) { return VertexIndex(r * columns + c % columns); };
    const auto uv = [columns](int r, int c) { return static_cast<std::uint32_t>(r * (columns + 1) + c); };
    for (int r = 0; r < rings; ++r) {
        for (int c = 0; c < columns; ++c) {
            data.triangles.push_back({corner(r, c), corner(r, c + 1), corner(r + 1, c + 1)});
            data.triangles.push_back({corner(r, c), corner(r + 1, c + 1), corner(r + 1, c)});
            data.triangleUvs.push_back({uv(r, c), uv(r, c + 1), uv(r + 1, c + 1)});
            data.triangleUvs.push_back({uv(r, c), uv(r + 1, c + 1), uv(r + 1, c)});
        }
    }
    data.vertexCount = static_cast<std::uint32_t>(unit.size());
    std::vector<Vec3f> positions;
    for (int f = 0; f < frames; ++f) {
        const auto [s, k] = sineCosine(0.02 * f);
        for (const Vec3f& p : unit) {
            const Vec3d spun(p.x() * k + p.z() * s, p.y() + 0.5, p.z() * k - p.x() * s);
            positions.emplace_back((spun + Vec3d(0.1 * f, 0, 0)).cast<float>());
        }
    }
    auto texture = std::make_shared<Image>(256, 128);
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 256; ++x) {
            std::uint8_t* pixel = texture->pixel(x, y);
            const bool odd = ((x / 32 + y / 32) & 1) != 0;
            pixel[0] = static_cast<std::uint8_t>(odd ? 230 : 40 + x / 2);
            pixel[1] = static_cast<std::uint8_t>(odd ? 190 - y : 110);
            pixel[2] = static_cast<std::uint8_t>(odd ? 60 : 200);
            pixel[3] = 255;
        }
    }
    const std::uint32_t vertexCount = data.vertexCount;
    auto sequence = makeSequence("ball", std::make_shared<const Topology>(std::move(data)),
                                 std::make_shared<MemoryFrames>(std::move(positions), vertexCount), 25);
    sequence.textures = TextureSet::single({{}, std::move(texture)});
    return sequence;
}

/// A gently waving sheet of 2 × 1.5 metres that faces +z, its texture spread over it.
inline MeshSequence wavySheet(int parts)
{
    TopologyData data;
    std::vector<Vec3f> positions;
    for (int r = 0; r <= parts; ++r) {
        for (int c = 0; c <= parts; ++c) {
            const double u = static_cast<double>(c) / parts;
            const double v = static_cast<double>(r) / parts;
            const double z = 0.05 * sineCosine(2 * u + v).sine;
            positions.emplace_back(Vec3d(2 * u - 1, 1.5 * v, z).cast<float>());
            data.uvs.emplace_back(Eigen::Vector2d(u, v).cast<float>());
        }
    }
    const auto at = [parts](int r, int c) { return static_cast<std::uint32_t>(r * (parts + 1) + c); };
    for (int r = 0; r < parts; ++r) {
        for (int c = 0; c < parts; ++c) {
            data.triangleUvs.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
            data.triangleUvs.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
        }
    }
    for (const auto& t : data.triangleUvs)
        data.triangles.push_back({VertexIndex(t[0]), VertexIndex(t[1]), VertexIndex(t[2])});
    data.vertexCount = static_cast<std::uint32_t>(positions.size());
    const std::uint32_t vertexCount = data.vertexCount;
    return makeSequence("sheet", std::make_shared<const Topology>(std::move(data)),
                        std::make_shared<MemoryFrames>(std::move(positions), vertexCount), 25);
}

/// FNV-1a over size and pixels.
inline std::uint64_t hashOf(const Image& image)
{
    std::uint64_t hash = 14695981039346656037ULL;
    const auto add = [&hash](std::uint64_t byte) { hash = (hash ^ byte) * 1099511628211ULL; };
    add(static_cast<std::uint64_t>(image.width));
    add(static_cast<std::uint64_t>(image.height));
    for (const std::uint8_t byte : image.pixels)
        add(byte);
    return hash;
}

} // namespace quadrille::test
