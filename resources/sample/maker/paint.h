// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "resources/sample/maker/body.h"

#include <cstdint>

namespace quadrille {

/// What a figure wears and looks like; colours in sRGB, 0 … 1.
struct Palette
{
    Vec3d shirt{0.13, 0.43, 0.47};
    Vec3d trim{0.93, 0.88, 0.76};
    Vec3d print{0.90, 0.36, 0.25};
    Vec3d trousers{0.20, 0.25, 0.36};
    Vec3d thread{0.85, 0.58, 0.28};
    Vec3d belt{0.33, 0.20, 0.12};
    Vec3d shoes{0.80, 0.29, 0.22};
    Vec3d skin{0.83, 0.62, 0.49};
    Vec3d lips{0.72, 0.42, 0.37};
    Vec3d hair{0.20, 0.125, 0.085};
    Vec3d iris{0.28, 0.38, 0.25};
    std::uint64_t seed = 7;
};

/// A place on the reference figure, with the part it belongs to.
struct PaintPlace
{
    Vec3d p;
    Vec3d normal;
    FigurePart part = FigurePart::Torso;
    bool isHair = false;
};

/// Colour of the clothes at a place.
Vec3d paintClothes(const PaintPlace& place, const Palette& palette);
/// Colour of skin, face or hair at a place.
Vec3d paintSkin(const PaintPlace& place, const Palette& palette);
/// Whatever is there: clothes or skin.
Vec3d paint(const PaintPlace& place, const Palette& palette);

/// How far a sleeve reaches down the arm, metres from the shoulder.
constexpr double sleeveEnd = 0.192;

/// 1 inside |x| < half, falling to 0 over `soft`.
inline double band(double x, double half, double soft)
{
    const double t = (half - std::abs(x)) / soft + 0.5;
    return t <= 0 ? 0.0 : t >= 1 ? 1.0 : t * t * (3 - 2 * t);
}
/// 0 below `edge`, 1 above, over `soft`.
inline double above(double x, double edge, double soft)
{
    const double t = (x - edge) / soft + 0.5;
    return t <= 0 ? 0.0 : t >= 1 ? 1.0 : t * t * (3 - 2 * t);
}
inline Vec3d mix(const Vec3d& a, const Vec3d& b, double t)
{
    return a + t * (b - a);
}

} // namespace quadrille
