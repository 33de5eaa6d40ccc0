// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/procrustes.h"
#include "model/sequence/meshsequence.h"
#include "model/variation/timewarp.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadrille::test {

/// How far the left foot is ahead of the right one in each frame, metres: known from the mesh alone. Which
/// vertices are feet is read from a pose at rest that looks along z, y up.
inline std::vector<double> footAhead(const MeshSequence& sequence, Positions rest)
{
    const float lowest = std::min_element(rest.begin(), rest.end(), [](const Vec3f& a, const Vec3f& b) {
                             return a.y() < b.y();
                         })->y();
    std::vector<double> ahead;
    for (std::int64_t f = 0; f < sequence.frameCount(); ++f) {
        const Frame frame = sequence.frame(FrameIndex(f));
        const RigidMotion onto = rigidProcrustes(frame.positions(), rest);
        double sums[2] = {0, 0};
        double counts[2] = {0, 0};
        for (std::size_t v = 0; v < rest.size(); ++v) {
            if (rest[v].y() > lowest + 0.06F)
                continue;
            const std::size_t side = rest[v].x() > 0 ? 0 : 1;
            sums[side] += onto(frame.positions()[v].cast<double>()).z();
            counts[side] += 1;
        }
        ahead.push_back(sums[0] / counts[0] - sums[1] / counts[1]);
    }
    return ahead;
}

/// Its value at a fraction of a frame.
inline double valueAt(const std::vector<double>& values, double frame)
{
    const auto before =
        static_cast<std::size_t>(std::clamp(frame, 0.0, static_cast<double>(values.size() - 1)));
    const std::size_t after = std::min(before + 1, values.size() - 1);
    const double share = frame - static_cast<double>(before);
    return (1 - share) * values[before] + share * values[after];
}

/// Correlation of two takes' values over the reference frames of their warps: 1 when their phases agree.
inline double agreement(const std::vector<double>& a, const TakeWarp& warpA, const std::vector<double>& b,
                        const TakeWarp& warpB)
{
    const auto count = static_cast<double>(warpA.positions.size());
    double sumA = 0;
    double sumB = 0;
    double squaresA = 0;
    double squaresB = 0;
    double products = 0;
    for (std::size_t f = 0; f < warpA.positions.size(); ++f) {
        const double x = valueAt(a, warpA.positions[f]);
        const double y = valueAt(b, warpB.positions[f]);
        sumA += x;
        sumB += y;
        squaresA += x * x;
        squaresB += y * y;
        products += x * y;
    }
    return (products - sumA * sumB / count) /
           std::sqrt((squaresA - sumA * sumA / count) * (squaresB - sumB * sumB / count));
}

} // namespace quadrille::test
