// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/spreadpoints.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace quadrille {

namespace {

constexpr int cellBits = 20; // of each axis

/// Three whole numbers below 2²⁰ with their bits in turn.
std::uint64_t interleaved(const Eigen::Array<std::uint32_t, 3, 1>& cell)
{
    std::uint64_t result = 0;
    for (int bit = 0; bit < cellBits; ++bit) {
        for (int axis = 0; axis < 3; ++axis)
            result |= std::uint64_t{cell[axis] >> bit & 1U} << (3 * bit + axis);
    }
    return result;
}

} // namespace

std::vector<std::size_t> spreadPoints(Positions points, std::size_t count)
{
    std::vector<std::size_t> chosen(std::min(points.size(), count));
    if (points.size() <= count) {
        std::iota(chosen.begin(), chosen.end(), std::size_t{0});
        return chosen;
    }
    Vec3f low = points.front();
    Vec3f high = low;
    for (const Vec3f& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const float extent = (high - low).maxCoeff();
    const float cells = extent > 0 ? static_cast<float>((1U << cellBits) - 1) / extent : 0.0F;
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    order.reserve(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
        order.emplace_back(interleaved(((points[p] - low) * cells).array().cast<std::uint32_t>()), p);
    std::ranges::sort(order);
    for (std::size_t k = 0; k < count; ++k)
        chosen[k] = order[(2 * k + 1) * points.size() / (2 * count)].second;
    std::ranges::sort(chosen);
    return chosen;
}

std::vector<Triangle> spreadTriangles(std::span<const Triangle> triangles, Positions pose, std::size_t count)
{
    std::vector<Vec3f> centres;
    centres.reserve(triangles.size());
    for (const Triangle& triangle : triangles)
        centres.emplace_back((pose[triangle[0].value] + pose[triangle[1].value] + pose[triangle[2].value]) /
                             3);
    std::vector<Triangle> spread;
    spread.reserve(std::min(triangles.size(), count));
    for (const std::size_t t : spreadPoints(centres, count))
        spread.push_back(triangles[t]);
    return spread;
}

} // namespace quadrille
