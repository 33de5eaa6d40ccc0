// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/spreadtriangles.h"

#include <algorithm>
#include <cstdint>
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

std::vector<Triangle> spreadTriangles(std::span<const Triangle> triangles, Positions pose, std::size_t count)
{
    if (triangles.size() <= count)
        return {triangles.begin(), triangles.end()};
    std::vector<Vec3f> centres;
    centres.reserve(triangles.size());
    for (const Triangle& triangle : triangles)
        centres.emplace_back((pose[triangle[0].value] + pose[triangle[1].value] + pose[triangle[2].value]) /
                             3);
    Vec3f low = centres.front();
    Vec3f high = low;
    for (const Vec3f& centre : centres) {
        low = low.cwiseMin(centre);
        high = high.cwiseMax(centre);
    }
    const float extent = (high - low).maxCoeff();
    const float cells = extent > 0 ? static_cast<float>((1U << cellBits) - 1) / extent : 0.0F;
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    order.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        order.emplace_back(interleaved(((centres[t] - low) * cells).array().cast<std::uint32_t>()), t);
    std::ranges::sort(order);
    std::vector<std::size_t> chosen;
    chosen.reserve(count);
    for (std::size_t k = 0; k < count; ++k)
        chosen.push_back(order[(2 * k + 1) * triangles.size() / (2 * count)].second);
    std::ranges::sort(chosen);
    std::vector<Triangle> spread;
    spread.reserve(count);
    for (const std::size_t t : chosen)
        spread.push_back(triangles[t]);
    return spread;
}

} // namespace quadrille
