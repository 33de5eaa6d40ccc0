// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/render/camera.h"
#include "model/sequence/topology.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

namespace quadrille::test {

/// The plainest rasteriser there is: one thread, one triangle after the other, double precision, a texture
/// sampled bilinearly at its full size, no light, one sample per pixel. What the real one must agree with.
/// \pre Nothing reaches behind the eye.
inline Image plainPicture(Positions positions, const TopologyData& topology, const Image& texture,
                          const Camera& camera, int width, int height)
{
    const Vec3d forward = (camera.target - camera.eye).normalized();
    const Vec3d right = forward.cross(camera.up).normalized();
    const Vec3d up = right.cross(forward);
    const auto [sine, cosine] = sineCosine(camera.verticalFovDegrees / 720);
    const double focal = height / 2.0 * cosine / sine;
    std::vector<Vec3d> screen; // x, y, 1 / depth
    for (const Vec3f& p : positions) {
        const Vec3d view = p.cast<double>() - camera.eye;
        const double depth = view.dot(forward);
        const double x = width / 2.0 + focal * view.dot(right) / depth;
        const double y = height / 2.0 - focal * view.dot(up) / depth;
        screen.emplace_back(std::nearbyint(x * 256) / 256, std::nearbyint(y * 256) / 256, 1 / depth);
    }
    const auto texel = [&texture](double x, double y, int channel) {
        const int column = (static_cast<int>(x) % texture.width + texture.width) % texture.width;
        const int row = (static_cast<int>(y) % texture.height + texture.height) % texture.height;
        return static_cast<double>(texture.pixel(column, row)[channel]);
    };
    Image image(width, height);
    std::vector<double> nearest(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
        const Vec3d& a = screen[topology.triangles[t][0].value];
        const Vec3d& b = screen[topology.triangles[t][1].value];
        const Vec3d& c = screen[topology.triangles[t][2].value];
        const auto edge = [](const Vec3d& from, const Vec3d& to, double x, double y) {
            return (to.x() - from.x()) * (y - from.y()) - (to.y() - from.y()) * (x - from.x());
        };
        const double area = edge(a, b, c.x(), c.y());
        if (area == 0)
            continue;
        const int top = std::max(static_cast<int>(std::min({a.y(), b.y(), c.y()})), 0);
        const int bottom = std::min(static_cast<int>(std::max({a.y(), b.y(), c.y()})), height - 1);
        const int left = std::max(static_cast<int>(std::min({a.x(), b.x(), c.x()})), 0);
        const int last = std::min(static_cast<int>(std::max({a.x(), b.x(), c.x()})), width - 1);
        for (int y = top; y <= bottom; ++y) {
            for (int x = left; x <= last; ++x) {
                Vec3d share(edge(b, c, x + 0.5, y + 0.5), edge(c, a, x + 0.5, y + 0.5),
                            edge(a, b, x + 0.5, y + 0.5));
                share /= area;
                if (share.minCoeff() < 0)
                    continue;
                const Vec3d shares = share.cwiseProduct(Vec3d(a.z(), b.z(), c.z()));
                const double nearness = shares.sum();
                double& best = nearest[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                       static_cast<std::size_t>(x)];
                if (nearness <= best)
                    continue;
                best = nearness;
                Eigen::Vector2d uv = Eigen::Vector2d::Zero();
                for (std::size_t i = 0; i < 3; ++i)
                    uv += topology.uvs[topology.triangleUvs[t][i]].cast<double>() *
                          (shares[static_cast<Eigen::Index>(i)] / nearness);
                const double u = uv.x() * texture.width - 0.5;
                const double v = (1 - uv.y()) * texture.height - 0.5;
                const double u0 = std::floor(u);
                const double v0 = std::floor(v);
                std::uint8_t* pixel = image.pixel(x, y);
                for (int i = 0; i < 3; ++i) {
                    const double upper =
                        texel(u0, v0, i) + (texel(u0 + 1, v0, i) - texel(u0, v0, i)) * (u - u0);
                    const double lower =
                        texel(u0, v0 + 1, i) + (texel(u0 + 1, v0 + 1, i) - texel(u0, v0 + 1, i)) * (u - u0);
                    pixel[i] = static_cast<std::uint8_t>(std::lrint(upper + (lower - upper) * (v - v0)));
                }
                pixel[3] = 255;
            }
        }
    }
    return image;
}

/// A texture without sharp edges that repeats.
inline std::shared_ptr<const Image> smoothTexture(int width, int height)
{
    auto texture = std::make_shared<Image>(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double u = static_cast<double>(x) / width;
            const double v = static_cast<double>(y) / height;
            std::uint8_t* pixel = texture->pixel(x, y);
            pixel[0] = static_cast<std::uint8_t>(130 + 100 * sineCosine(2 * u).sine);
            pixel[1] = static_cast<std::uint8_t>(130 + 100 * sineCosine(u + v).cosine);
            pixel[2] = static_cast<std::uint8_t>(130 + 100 * sineCosine(2 * v).sine);
            pixel[3] = 255;
        }
    }
    return texture;
}

} // namespace quadrille::test
