// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <array>
#include <initializer_list>
#include <vector>

namespace quadrille {

/// Union of two signed distances, rounded over the distance `k` (polynomial smooth minimum).
double smoothUnion(double a, double b, double k);
/// Intersection of two signed distances, rounded over the distance `k`.
double smoothIntersection(double a, double b, double k);

double sphereDistance(const Vec3d& p, const Vec3d& centre, double radius);
/// Close to the surface only: a bound elsewhere.
double ellipsoidDistance(const Vec3d& p, const Vec3d& centre, const Vec3d& radii);
/// A capsule whose radius changes from `ra` at `a` to `rb` at `b`.
double taperedCapsuleDistance(const Vec3d& p, const Vec3d& a, const Vec3d& b, double ra, double rb);

/// One cross-section of a loft: half an ellipse to the front, half to the back.
struct LoftKey
{
    double at = 0;      ///< along the axis, metres
    double width = 0;   ///< half-width along `across`
    double front = 0;   ///< half-depth along `ahead`
    double back = 0;    ///< half-depth against `ahead`
    double offset = 0;  ///< of the centre along `across`
    double forward = 0; ///< of the centre along `ahead`
};

/// A body of elliptical cross-sections along a straight axis, smooth between its keys.
class Loft
{
public:
    struct Frame
    {
        Vec3d origin = Vec3d::Zero();
        Vec3d along = Vec3d::UnitY();
        Vec3d across = Vec3d::UnitX();
        Vec3d ahead = Vec3d::UnitZ();
    };

    Loft() = default;
    /// \param keys in ascending order along the axis, at least two.
    /// \param exponent of the cross-section: 2 an ellipse, more is boxier.
    Loft(const Frame& frame, const std::vector<LoftKey>& keys, double exponent = 2.0);

    /// Signed distance, exact in the limit of small slopes.
    double distance(const Vec3d& p) const;
    /// A number that `distance` is not below, at a fraction of its cost; far below zero near the surface.
    double atLeast(const Vec3d& p) const;
    /// The cross-section at a place along the axis, ends held.
    LoftKey section(double at) const;

private:
    static constexpr int samples = 160;
    Frame m_frame;
    std::array<LoftKey, samples + 1> m_table;
    double m_first = 0;
    double m_last = 0;
    double m_exponent = 2;
};

} // namespace quadrille
