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
    /// least 1; all where it is empty.
    std::optional<std::int64_t> triangles;

    bool operator==(const PoseDistanceSettings&) const = default;
};

/// Frames of a character up to which graphs compare all of its triangles where they name no number.
inline constexpr std::int64_t mostFramesByAll = 5'000;
/// How many they compare of characters of more frames.
inline constexpr std::int64_t usualTriangles = 1'000;

/// As a graph of so many frames has them.
inline PoseDistanceSettings ofGraph(PoseDistanceSettings settings, std::int64_t frameCount)
{
    if (!settings.triangles && frameCount > mostFramesByAll)
        settings.triangles = usualTriangles;
    return settings;
}

} // namespace quadrille
