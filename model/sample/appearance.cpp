// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/appearance.h"

#include "model/sample/noise.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

constexpr double largestWarp = 2.0; ///< texels at 512, in proportion at other sizes

/// Light that each vertex gets.
std::vector<Vec3f> shade(const Topology& topology, Positions posed, const SampleLight& light)
{
    std::vector<Vec3f> normals(posed.size(), Vec3f::Zero());
    for (const Triangle& t : topology.triangles()) {
        const Vec3f& a = posed[t[0].value];
        const Vec3f n = (posed[t[1].value] - a).cross(posed[t[2].value] - a);
        for (const VertexIndex v : t)
            normals[v.value] += n;
    }
    const Vec3f direction = light.direction.cast<float>();
    std::vector<Vec3f> shades;
    shades.reserve(posed.size());
    for (const Vec3f& n : normals) {
        // Wrapped, as from a large soft window.
        const float facing = std::max(0.0F, (n.normalized().dot(direction) + 0.4F) / 1.4F);
        shades.emplace_back(light.ambient.cast<float>() + facing * light.colour.cast<float>());
    }
    return shades;
}

Vec3f sample(const Image& image, double x, double y)
{
    x = std::clamp(x - 0.5, 0.0, image.width - 1.001);
    y = std::clamp(y - 0.5, 0.0, image.height - 1.001);
    const int ix = static_cast<int>(x);
    const int iy = static_cast<int>(y);
    const auto tx = static_cast<float>(x - ix);
    const auto ty = static_cast<float>(y - iy);
    const auto at = [&](int dx, int dy) {
        const std::uint8_t* p = image.pixel(ix + dx, iy + dy);
        return Vec3f(p[0], p[1], p[2]);
    };
    return (1 - ty) * ((1 - tx) * at(0, 0) + tx * at(1, 0)) + ty * ((1 - tx) * at(0, 1) + tx * at(1, 1));
}

/// Each texel a mean of itself and its neighbours, the nearest counting most.
Image smoothed(const Image& image)
{
    Image found(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        const std::array rows{image.pixel(0, std::max(0, y - 1)), image.pixel(0, y),
                              image.pixel(0, std::min(image.height - 1, y + 1))};
        for (int x = 0; x < image.width; ++x) {
            const std::array columns{4 * std::max(0, x - 1), 4 * x, 4 * std::min(image.width - 1, x + 1)};
            for (int c = 0; c < 4; ++c) {
                const auto across = [&](const std::uint8_t* row) {
                    return row[columns[0] + c] + 2 * row[columns[1] + c] + row[columns[2] + c];
                };
                found.pixel(x, y)[c] = static_cast<std::uint8_t>(
                    (across(rows[0]) + 2 * across(rows[1]) + across(rows[2]) + 8) / 16);
            }
        }
    }
    return found;
}

} // namespace

SampleAppearance makeAppearance(std::int64_t frames, int textureSize, std::uint64_t seed)
{
    SampleAppearance appearance;
    appearance.textureSize = textureSize;
    Random random(seed);
    const double azimuth = random.between(-0.9, 0.9);
    const double sweep = random.between(0.5, 1.0) * (random.unit() < 0.5 ? -1 : 1);
    const std::uint64_t noise = random.next();
    constexpr int nodes = SampleWarp::nodes;
    for (std::int64_t f = 0; f < frames; ++f) {
        const double time = static_cast<double>(f) / 25;
        const double turned = azimuth + sweep * std::sin(0.9 * time);
        const double warm = 0.5 * valueNoise(time * 0.6, 3.5, 0, noise);
        SampleLight light;
        light.direction = Vec3d(std::sin(turned), 0.8, std::cos(turned)).normalized();
        light.colour = (0.62 + 0.10 * valueNoise(time * 0.8, 9.5, 0, noise)) *
                       Vec3d(1 + 0.10 * warm, 1.0, 1 - 0.14 * warm);
        light.ambient = (0.50 + 0.05 * valueNoise(time * 0.7, 5.5, 0, noise)) *
                        Vec3d(1 - 0.05 * warm, 1.0, 1 + 0.08 * warm);
        appearance.lights.push_back(light);
        SampleWarp warp;
        const double size = largestWarp * textureSize / 512;
        for (int j = 0; j < nodes; ++j)
            for (int i = 0; i < nodes; ++i) {
                const auto along = [&](std::uint64_t axis) {
                    return size * valueNoise(i * 0.31, j * 0.31, time * 0.9, noise + axis);
                };
                warp.offsets.emplace_back(static_cast<float>(along(1)), static_cast<float>(along(2)));
            }
        appearance.warps.push_back(std::move(warp));
    }
    return appearance;
}

Vec2f SampleWarp::at(double u, double v) const
{
    const double x = std::clamp(u, 0.0, 1.0) * (nodes - 1);
    const double y = std::clamp(v, 0.0, 1.0) * (nodes - 1);
    const int i = std::min(static_cast<int>(x), nodes - 2);
    const int j = std::min(static_cast<int>(y), nodes - 2);
    const auto tx = static_cast<float>(x - i);
    const auto ty = static_cast<float>(y - j);
    const auto node = [&](int di, int dj) {
        const int index = (j + dj) * nodes + i + di;
        return offsets[static_cast<std::size_t>(index)];
    };
    return (1 - ty) * ((1 - tx) * node(0, 0) + tx * node(1, 0)) +
           ty * ((1 - tx) * node(0, 1) + tx * node(1, 1));
}

SampleBody forTexturesOf(int size, SampleBody body)
{
    for (int width = body.texture->width; width > size; width /= 2)
        body.texture = std::make_shared<const Image>(smoothed(*body.texture));
    return body;
}

Image frameTexture(const SampleBody& body, const TexelMap& texels, Positions posed,
                   const SampleAppearance& appearance, FrameIndex frame)
{
    const auto f = static_cast<std::size_t>(frame.value);
    const SampleWarp& warp = appearance.warps[f];
    const std::vector<Vec3f> shades = shade(*body.topology, posed, appearance.lights[f]);
    const int size = texels.size;
    const double ratio = static_cast<double>(body.texture->width) / size;
    Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            std::uint8_t* pixel = image.pixel(x, y);
            pixel[3] = 255;
            const std::size_t texel = texels.index(x, y);
            if (texels.triangle[texel] == TexelMap::none) {
                std::fill_n(pixel, 3, static_cast<std::uint8_t>(96));
                continue;
            }
            const Triangle& t = body.topology->triangles()[static_cast<std::size_t>(texels.triangle[texel])];
            const Vec2f& b = texels.barycentric[texel];
            const Vec3f light = (1 - b.x() - b.y()) * shades[t[0].value] + b.x() * shades[t[1].value] +
                                b.y() * shades[t[2].value];
            const Vec2f shift = warp.at((x + 0.5) / size, (y + 0.5) / size);
            const Vec3f colour = sample(*body.texture, (x + 0.5 + static_cast<double>(shift.x())) * ratio,
                                        (y + 0.5 + static_cast<double>(shift.y())) * ratio);
            for (int c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint8_t>(std::clamp(colour[c] * light[c] + 0.5F, 0.0F, 255.0F));
        }
    return image;
}

} // namespace quadrille
