// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/noise.h"
#include "resources/sample/maker/paint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double texel = 0.0016; ///< softness of painted edges, metres

/// A line of stitches: `across` the distance from the line, `along` the way on it.
double stitches(double across, double along)
{
    const double phase = along / 0.006 - std::floor(along / 0.006);
    return band(across, 0.0011, texel) * band(phase - 0.5, 0.32, 0.2);
}

double weave(const Vec3d& p, std::uint64_t seed)
{
    return 0.55 * valueNoise(p.x() * 420, p.y() * 420, p.z() * 420, seed) +
           0.45 * valueNoise(p.x() * 90, p.y() * 90, p.z() * 90, seed + 1);
}

Vec3d emblem(const Vec3d& colour, double x, double y, const Palette& palette)
{
    const double radius = std::hypot(x, y);
    Vec3d result = mix(colour, palette.trim, band(radius, 0.066, texel));
    result = mix(result, palette.shirt * 0.8, band(radius - 0.0595, 0.0018, texel));
    // A square standing on its tip, four by four fields.
    const double u = (x + y) / 0.0185;
    const double v = (y - x) / 0.0185;
    const double inside = std::min(band(u, 2.0, 0.1), band(v, 2.0, 0.1));
    const auto field = static_cast<int>(std::floor(u)) + static_cast<int>(std::floor(v));
    const Vec3d square = (field & 1) ? palette.print : Vec3d(palette.trousers * 0.9);
    return mix(result, square, inside);
}

Vec3d shirtFront(Vec3d colour, const Vec3d& p, const Palette& palette)
{
    colour = emblem(colour, p.x(), p.y() - 1.268, palette);
    // Placket with three buttons.
    const double inPlacket = band(p.x(), 0.0165, texel) * above(p.y(), 1.358, texel);
    colour = mix(colour, mix(palette.shirt, palette.trim, 0.18), inPlacket);
    const double edge = std::max(band(std::abs(p.x()) - 0.0165, 0.0009, texel) * above(p.y(), 1.358, texel),
                                 band(p.x(), 0.0165, texel) * band(p.y() - 1.358, 0.0009, texel));
    colour = mix(colour, palette.shirt * 0.55, edge);
    colour = mix(colour, palette.trim,
                 0.8 * stitches(std::abs(p.x()) - 0.0130, p.y()) * above(p.y(), 1.362, texel));
    for (const double y : {1.376, 1.403, 1.430}) {
        const double r = std::hypot(p.x(), p.y() - y);
        colour = mix(colour, palette.shirt * 0.5, band(std::hypot(p.x(), p.y() - y + 0.0012), 0.0068, texel));
        colour = mix(colour, palette.trim * 1.03, band(r, 0.0058, texel));
        colour = mix(colour, palette.belt, band(r - 0.0018, 0.0006, 0.001));
    }
    return colour;
}

Vec3d shirt(const PaintPlace& place, const Palette& palette)
{
    const Vec3d& p = place.p;
    Vec3d colour = palette.shirt;
    const BodyJoints joints = referenceJoints();
    const Vec3d fromShoulder(std::abs(p.x()) - joints.shoulder.x(), p.y() - joints.shoulder.y(),
                             p.z() - joints.shoulder.z());
    const double along = fromShoulder.dot((joints.elbow - joints.shoulder).normalized());
    if (place.part == FigurePart::Arm) {
        colour = mix(colour, palette.trim, above(along, 0.166, texel));
        colour = mix(colour, palette.shirt * 0.6, band(along - 0.1655, 0.0009, texel));
        colour = mix(colour, palette.shirt * 0.75, stitches(along - 0.172, p.z() + p.y()));
        colour *= 1 - 0.35 * above(along, 0.189, 0.004);
    } else {
        const bool isFront = p.z() > 0;
        if (isFront)
            colour = shirtFront(colour, p, palette);
        else {
            // Across the back: a yoke seam and a number.
            colour = mix(colour, palette.shirt * 0.6, band(p.y() - 1.375, 0.0009, texel));
            colour = mix(colour, palette.trim, 0.8 * stitches(p.y() - 1.371, p.x()));
            const double bars =
                std::max({band(p.x() - 0.028, 0.009, texel) * band(p.y() - 1.283, 0.037, texel),
                          band(p.x() + 0.022, 0.009, texel) * band(p.y() - 1.265, 0.055, texel),
                          band(p.x(), 0.043, texel) * band(p.y() - 1.254, 0.009, texel)});
            colour = mix(colour, palette.trim, bars);
        }
        // Side and shoulder seams.
        const double side = p.z() + 0.012;
        colour = mix(colour, palette.shirt * 0.6, band(side, 0.0009, texel));
        const double collar = (p.y() - 1.462) * 0.95 + (p.z() + 0.012) * 0.31;
        const double nearNeck = band(std::hypot(p.x(), p.z() + 0.012), 0.092, texel);
        colour = mix(colour, palette.trim, above(collar, -0.016, texel) * nearNeck);
        colour = mix(colour, palette.shirt * 0.55, band(collar + 0.0165, 0.001, texel) * nearNeck);
        colour = mix(colour, palette.shirt * 0.8,
                     stitches(collar + 0.0075, std::atan2(p.x(), p.z()) * 0.08) * nearNeck);
        colour = mix(colour, palette.trim, 0.6 * stitches(p.y() - 1.004, p.x() + p.z()));
    }
    const double armhole = fromShoulder.dot(Vec3d(0.93, -0.37, 0)) - 0.004;
    if (fromShoulder.norm() < 0.14) {
        colour = mix(colour, palette.shirt * 0.6, band(armhole, 0.0010, texel));
        colour = mix(colour, palette.trim, 0.6 * stitches(armhole + 0.006, p.z() + p.y()));
    }
    const double fold = valueNoise(p.x() * 14, p.y() * 26, p.z() * 14, palette.seed + 11);
    return colour * (1 + 0.075 * weave(p, palette.seed) + 0.045 * fold);
}

Vec3d belt(Vec3d colour, const PaintPlace& place, const Palette& palette)
{
    const Vec3d& p = place.p;
    const double height = p.y() - 0.975;
    const double around = std::atan2(p.x(), p.z()) * 0.13;
    Vec3d leather = palette.belt * (1 + 0.12 * weave(p * 0.5, palette.seed + 3));
    leather = mix(leather, palette.thread, 0.7 * stitches(std::abs(height) - 0.0100, around));
    if (p.z() > 0) {
        const double outer = std::max(std::abs(p.x()) / 0.024, std::abs(height) / 0.0155);
        const double brass = band(outer, 1.0, 0.08) * (1 - band(outer, 0.66, 0.08));
        const Vec3d metal = Vec3d(0.85, 0.70, 0.38) * (1 + 12 * height);
        leather = mix(leather, metal, brass);
        leather = mix(leather, metal, band(p.x() - 0.002, 0.002, texel) * band(height, 0.012, texel));
    }
    colour = mix(colour, palette.trousers * 0.45, band(height, 0.0150, texel));
    colour = mix(colour, leather, band(height, 0.0130, texel));
    for (const double at : {0.085, 0.21, 0.36})
        colour = mix(colour, palette.trousers * 1.05,
                     band(std::abs(around) - at, 0.0065, texel) * band(height, 0.0175, texel));
    return colour;
}

Vec3d trousers(const PaintPlace& place, const Palette& palette)
{
    const Vec3d& p = place.p;
    const double x = std::abs(p.x());
    const double twill =
        0.5 * valueNoise((p.x() + p.y()) * 330, (p.y() - p.z()) * 60, p.z() * 330, palette.seed + 5) +
        0.5 * weave(p, palette.seed + 6);
    Vec3d colour = palette.trousers;
    // Worn lighter on thighs and knees.
    const double worn =
        std::exp(-std::pow((p.y() - 0.70) / 0.13, 2)) + 0.7 * std::exp(-std::pow((p.y() - 0.50) / 0.05, 2));
    if (place.normal.z() > 0)
        colour = mix(colour, Vec3d(0.48, 0.55, 0.66), 0.30 * worn * place.normal.z());
    const double middle = p.y() > 0.85 ? 0.0 : -0.02 + 0.026 * std::min((p.y() - 0.07) / 0.44, 1.0);
    const double side = p.z() - middle;
    colour = mix(colour, palette.trousers * 0.55, band(side, 0.0010, texel));
    colour = mix(colour, palette.thread,
                 0.75 * std::max(stitches(side - 0.005, p.y()), stitches(side - 0.009, p.y())));
    if (p.y() > 0.80) {
        colour = mix(colour, palette.trousers * 0.55, band(p.x(), 0.0010, texel));
        if (p.z() > 0) {
            // Fly and slanting front pockets.
            const double fly = std::hypot(std::max(0.0, 0.875 - p.y()), p.x() - 0.0) - 0.028;
            colour = mix(colour, palette.thread, 0.8 * stitches(p.x() > 0 ? fly : 1.0, p.y() + p.x()));
            const double pocket = std::hypot(x - 0.178, (p.y() - 0.965) * 0.72) - 0.066;
            colour = mix(colour, palette.trousers * 0.5, band(pocket, 0.0012, texel));
            colour = mix(colour, palette.thread,
                         0.85 * std::max(stitches(pocket - 0.004, p.y()), stitches(pocket - 0.009, p.y())));
        } else {
            // Back pockets.
            const double dx = std::abs(x - 0.082) - 0.046;
            const double dy = std::abs(p.y() - 0.893) - 0.052 +
                              0.22 * std::max(0.0, std::abs(x - 0.082) - 0.0) * (p.y() < 0.88);
            const double pocket = std::max(dx, dy);
            colour = mix(colour, palette.trousers * 0.6, band(pocket, 0.0012, texel));
            colour = mix(colour, palette.thread,
                         0.85 * std::max(stitches(pocket + 0.0035, p.x() + p.y()),
                                         stitches(pocket + 0.008, p.x() + p.y())));
            const double arc = p.y() - 0.893 - 0.012 * std::cos((x - 0.082) * 68);
            colour = mix(colour, palette.thread, 0.7 * stitches(arc, p.x()) * (pocket < -0.01));
            colour = mix(colour, palette.thread, 0.7 * stitches(p.y() - 0.955 + 0.12 * x, p.x()));
        }
    }
    colour = mix(colour, palette.thread, 0.8 * stitches(p.y() - 0.095, p.x() + p.z()));
    colour = mix(colour, palette.trousers * 0.5, above(-p.y(), -0.071, 0.004));
    const double fold = valueNoise(p.x() * 16, p.y() * 30, p.z() * 16, palette.seed + 12);
    colour *= 1 + 0.15 * twill + 0.06 * fold;
    return belt(colour, place, palette);
}

Vec3d shoe(const PaintPlace& place, const Palette& palette)
{
    const BodyJoints joints = referenceJoints();
    const Vec3d ahead = (joints.toeTip - joints.ankle).cwiseProduct(Vec3d(1, 0, 1)).normalized();
    const Vec3d q(std::abs(place.p.x()) - joints.ankle.x(), place.p.y(), place.p.z() - joints.ankle.z());
    const double along = q.dot(ahead);
    const double across = q.x() * ahead.z() - q.z() * ahead.x();
    const double y = place.p.y();
    if (place.normal.y() < -0.6 && y < 0.02) {
        const double tread = std::sin(along * 420) * std::sin(across * 420);
        return Vec3d(0.52, 0.47, 0.42) * (0.9 + 0.14 * (tread > 0) + 0.05 * weave(place.p, palette.seed + 8));
    }
    Vec3d colour = palette.shoes * (1 + 0.07 * weave(place.p, palette.seed + 8));
    const Vec3d rubber(0.93, 0.92, 0.88);
    // Toe cap, heel patch, tongue and laces.
    colour = mix(colour, rubber * 0.97, above(along, 0.150 - 4 * across * across, 0.002));
    colour = mix(colour, palette.shoes * 0.5, band(along - 0.149 + 4 * across * across, 0.0011, texel));
    colour = mix(colour, palette.shoes * 0.62, above(-along, 0.045, 0.002) * above(y, 0.03, texel));
    if (along > 0.018 && along < 0.128 && y > 0.035) {
        colour = mix(colour, palette.shoes * 0.72, band(across, 0.017, texel));
        const double bar = (along - 0.018) / 0.0155 - std::floor((along - 0.018) / 0.0155);
        const double slant = bar - 0.5 + 8 * across;
        colour = mix(colour, Vec3d(0.96, 0.95, 0.92), band(across, 0.022, texel) * band(slant, 0.22, 0.12));
        colour = mix(colour, Vec3d(0.30, 0.26, 0.24),
                     band(std::abs(across) - 0.0235, 0.0018, texel) * band(bar - 0.5, 0.15, 0.1));
        colour = mix(colour, palette.trim, 0.8 * stitches(std::abs(across) - 0.029, along));
    }
    // A stripe on the side.
    colour = mix(colour, palette.trim,
                 band(along - 0.052 - (y - 0.04) * 0.8, 0.0065, texel) *
                     above(std::abs(across), 0.03, 0.004) * above(y, 0.03, texel));
    colour = mix(colour, palette.shoes * 0.55, above(y, 0.082, texel));
    colour = mix(colour, palette.trim * 0.75, above(y, 0.090, texel));
    const double sole = above(-y, -0.0215, texel);
    Vec3d soleColour = rubber * (1 + 0.05 * weave(place.p, palette.seed + 9));
    soleColour = mix(soleColour, palette.shoes * 0.8, band(y - 0.0165, 0.0013, texel));
    return mix(colour, soleColour, sole);
}

} // namespace

Vec3d paintClothes(const PaintPlace& place, const Palette& palette)
{
    switch (place.part) {
    case FigurePart::Foot:
        return shoe(place, palette);
    case FigurePart::Leg:
        return place.p.y() < 0.068 ? shoe(place, palette) : trousers(place, palette);
    default:
        return place.p.y() < 0.990 && place.part == FigurePart::Torso ? trousers(place, palette)
                                                                      : shirt(place, palette);
    }
}

} // namespace quadrille
