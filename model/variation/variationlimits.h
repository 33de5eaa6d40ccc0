// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace quadrille {

/// So far from the nearest pose that was learned from a pose may be in any set, sizes of the figure: 3 cm of
/// a grown-up's mean vertex.
inline constexpr double leastPoseDistance = 0.015;

/// How bad a variation may be.
struct VariationLimits
{
    /// Distance of the worst frame from the nearest pose learned from, in sizes of the figure: 0.08 are 16 cm
    /// of a grown-up's mean vertex. Empty: as far as takes of the same movement are from each other
    /// (VariationQuality::takeDistance), at least leastPoseDistance.
    std::optional<double> poseDistance;
    /// How much faster standing feet may slide than in the take, sizes of the figure a second: half a metre
    /// a second for a grown-up, which a correction of contacts can still take out.
    double skate = 0.25;
    /// Pairs of triangles that go through each other in the worst frame beyond those of the worst frame of
    /// all takes, as a share of all triangles: a variation of one take may bend as far as another one does.
    double intersections = 0.01;
    /// See VariationQuality::volumeChange. An arm that is a fifth too long changes the body by 3 %; takes of
    /// walks and runs differ by 1 %.
    double volumeChange = 0.03;
    /// Triangles of a region of the body that shrink or fold up, a share of them (see SurfaceCollapse).
    double collapse = 0.1;
    /// How much deeper than the take a variation may reach, in sizes of the figure: 0.015 are 3 cm of a
    /// grown-up.
    double sink = 0.015;

    bool operator==(const VariationLimits&) const = default;
};

} // namespace quadrille
