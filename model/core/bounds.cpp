// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"

#include <array>

namespace quadrille {

void Bounds::add(const Vec3d& point)
{
    min = min.cwiseMin(point);
    max = max.cwiseMax(point);
}

void Bounds::add(const Bounds& other)
{
    min = min.cwiseMin(other.min);
    max = max.cwiseMax(other.max);
}

Bounds boundsOf(Positions positions)
{
    Bounds bounds;
    if (positions.empty())
        return bounds;
    // Sixteen positions side by side, so that the loop over the lanes vectorises.
    constexpr std::size_t lanes = 48;
    const float* values = positions.front().data();
    const std::size_t count = positions.size() * 3;
    std::array<float, lanes> low;
    std::array<float, lanes> high;
    for (std::size_t lane = 0; lane < lanes; ++lane)
        low[lane] = high[lane] = values[lane % 3];
    std::size_t at = 0;
    for (; at + lanes <= count; at += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const float value = values[at + lane];
            low[lane] = value < low[lane] ? value : low[lane];
            high[lane] = value > high[lane] ? value : high[lane];
        }
    }
    for (std::size_t lane = 0; lane < lanes; lane += 3) {
        bounds.add(Vec3f(low[lane], low[lane + 1], low[lane + 2]).cast<double>());
        bounds.add(Vec3f(high[lane], high[lane + 1], high[lane + 2]).cast<double>());
    }
    for (; at < count; at += 3)
        bounds.add(Vec3f(values[at], values[at + 1], values[at + 2]).cast<double>());
    return bounds;
}

} // namespace quadrille
