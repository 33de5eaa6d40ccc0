// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/pathcurve.h"

#include "model/synthesis/walks/constraints.h"

namespace quadrille {

namespace {

/// Greatest distance of points of a curve, metres.
constexpr double curveSpacing = 0.02;

} // namespace

std::vector<Vec3d> curveOf(PathCurve curve, const std::vector<Vec3d>& points, double metresPerUnit)
{
    if (points.size() < 2)
        return {};
    const double spacing = curveSpacing / metresPerUnit;
    switch (curve) {
    case PathCurve::Polyline:
        return points;
    case PathCurve::CatmullRom:
        return sampleCurve(points, spacing);
    case PathCurve::Bezier:
        break;
    }
    std::vector<Vec3d> samples;
    for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
        const std::vector<Vec3d> piece =
            sampleBezier(points[i], points[i + 1], points[i + 2], points[i + 3], spacing);
        samples.insert(samples.end(), piece.begin() + (samples.empty() ? 0 : 1), piece.end());
    }
    return samples;
}

} // namespace quadrille
