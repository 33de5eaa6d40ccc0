// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace quadrille {

/// How the distance of two poses is measured, rigid motion removed.
enum class PoseMetric
{
    Surface,   ///< mean rotation of the triangles and weighted mean stretch, radians (SMCAS eq. 1–2)
    Euclidean, ///< mean distance of the vertices, metres (SMCAS Table 1)
};

struct PoseDistanceSettings
{
    PoseMetric metric = PoseMetric::Surface;
    /// w of SMCAS eq. 2: weight of the stretch against the rotation, at least 0. Surface metric only.
    double stretchWeight = 0.01;
    /// How many triangles, by the Euclidean metric vertices, are compared, spread evenly over the surface, at
    /// least 1. Where it is empty all are, or so many as are usual where there are many frames.
    std::optional<std::int64_t> triangles;
    static constexpr std::int64_t mostFramesByAll = 5'000;
    static constexpr std::int64_t usualTriangles = 1'000;

    bool operator==(const PoseDistanceSettings&) const = default;
};

} // namespace quadrille
