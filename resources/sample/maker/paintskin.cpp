// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/noise.h"
#include "resources/sample/maker/paint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

double blob(const Vec3d& p, const Vec3d& centre, double radius)
{
    return std::exp(-(p - centre).squaredNorm() / (radius * radius));
}

Vec3d eye(Vec3d colour, double x, double y, const Palette& palette)
{
    // x grows outwards. The opening is an almond, a little higher outside.
    const double half = 0.0158;
    const double t = std::clamp(x / half, -1.0, 1.0);
    const double upper = 0.0082 * (1 - t * t) * (1 + 0.12 * t) + 0.0006 * t;
    const double lower = -0.0058 * (1 - t * t) + 0.0010 * t;
    const double inside =
        std::min({above(y, lower, 0.0011), above(-y, -upper, 0.0011), band(x, half, 0.001)});
    // Lid shadow, crease and the eye itself.
    colour = mix(colour, colour * 0.74,
                 0.75 * band(y - upper - 0.0052, 0.0015, 0.0022) * band(x, half * 1.05, 0.006));
    colour = mix(colour, colour * 0.86,
                 0.6 * band(y - lower + 0.0040, 0.0012, 0.003) * band(x, half * 0.9, 0.008));
    const double r = std::hypot(x + 0.0002, y - 0.0008);
    Vec3d ball = Vec3d(0.93, 0.91, 0.88) * (1 - 0.18 * std::abs(t) - 0.24 * above(y, upper - 0.003, 0.004));
    const double fibre = valueNoise(std::atan2(y, x) * 6, r * 300, 0, palette.seed + 21);
    Vec3d iris = palette.iris * (1.0 + 0.25 * fibre + 0.5 * above(-y, -0.001, 0.006));
    iris = mix(iris, palette.iris * 0.35, above(r, 0.0056, 0.0012));
    ball = mix(ball, iris, band(r, 0.0064, 0.0011));
    ball = mix(ball, Vec3d(0.03, 0.025, 0.025), band(r, 0.0029, 0.0009));
    ball = mix(ball, Vec3d(1, 1, 1), band(std::hypot(x - 0.0022, y - 0.0034), 0.0013, 0.0009));
    colour = mix(colour, ball, inside);
    // Lashes: a dark upper rim that ends in a small wing.
    const double rim = band(y - upper - 0.0005, 0.0011, 0.0010) * band(x - 0.001, half + 0.001, 0.002);
    colour = mix(colour, palette.hair * 0.55, 0.95 * rim);
    const double lowRim = band(y - lower, 0.0005, 0.0010) * band(x - 0.002, half - 0.001, 0.004);
    return mix(colour, palette.hair * 0.9, 0.45 * lowRim);
}

Vec3d brow(Vec3d colour, double x, double y, const Palette& palette)
{
    const double t = (x - 0.0115) / 0.0385;
    if (t < -0.1 || t > 1.1)
        return colour;
    const double middle = 1.6375 + 0.0068 * std::sin(2.3 * std::max(t, 0.0)) - 0.0035 * t * t;
    const double thickness = 0.0040 * (1 - 0.65 * t * t);
    const double strand = valueNoise(x * 500, (y - 0.6 * x) * 900, 0, palette.seed + 22);
    const double cover = band(y - middle, thickness, 0.0022) * above(t, -0.02, 0.08) * above(-t, -1.0, 0.12);
    return mix(colour, palette.hair * (1.05 + 0.3 * strand), cover * (0.86 + 0.14 * strand));
}

Vec3d mouth(Vec3d colour, double x, double y, const Palette& palette)
{
    const double half = 0.0240;
    const double t = std::min(x / half, 1.0);
    const double line = 1.5508 + 0.0020 * t * t;
    const double top =
        line + (0.0062 - 0.0014 * std::exp(-std::pow(x / 0.0035, 2))) * std::pow(1 - t * t, 0.75);
    const double bottom = line - 0.0080 * std::pow(1 - t * t, 0.65);
    const double inside =
        std::min({above(y, bottom, 0.0016), above(-y, -top, 0.0014), band(x, half, 0.0014)});
    const double crease = valueNoise(x * 700, y * 120, 0, palette.seed + 23);
    Vec3d lip =
        palette.lips * (1 + 0.06 * crease + (y < line ? 0.10 * band(y - line + 0.004, 0.002, 0.004) : -0.10));
    colour = mix(colour, lip, 0.85 * inside);
    colour = mix(colour, palette.lips * 0.42, 0.85 * band(y - line, 0.0006, 0.0012) * band(x, half, 0.004));
    // A hint of a smile and the shadow below the lower lip.
    colour = mix(colour, colour * 0.80,
                 0.6 * band(std::hypot(x - half - 0.001, y - line - 0.0006), 0.0013, 0.003));
    return mix(colour, colour * 0.88, 0.7 * band(std::hypot(x / 2.2, y - bottom + 0.0035), 0.0022, 0.004));
}

Vec3d hairColour(const PaintPlace& place, const Palette& palette)
{
    const Vec3d& p = place.p;
    // Strands run from a parting at the wearer's left backwards and down.
    const double around = std::atan2(p.x() - 0.03, p.y() - 1.62);
    const double strands = 0.6 * valueNoise(around * 55, p.z() * 14 + p.y() * 6, 0, palette.seed + 24) +
                           0.4 * valueNoise(around * 150, p.z() * 30, 1, palette.seed + 25);
    Vec3d colour = palette.hair * (1.05 + 0.38 * strands);
    const double shine = std::exp(-std::pow((p.y() - 1.712 - 0.1 * p.z()) / 0.014, 2));
    colour += Vec3d(0.13, 0.10, 0.075) * shine * (0.7 + 0.5 * strands);
    if (p.z() > -0.02 && p.y() > 1.70)
        colour *= 1 - 0.45 * band(p.x() - 0.030 - 0.06 * (p.z() - 0.05), 0.0016, 0.002);
    return colour;
}

Vec3d face(Vec3d colour, const PaintPlace& place, const Palette& palette)
{
    const Vec3d& p = place.p;
    const double x = std::abs(p.x());
    const Vec3d flush(0.80, 0.44, 0.36);
    const Vec3d m(x, p.y(), p.z());
    double red = 0.34 * blob(m, {0.044, 1.588, 0.070}, 0.024) + 0.32 * blob(m, {0, 1.586, 0.112}, 0.015) +
                 0.40 * blob(m, {0.088, 1.602, -0.006}, 0.024) + 0.10 * blob(m, {0, 1.52, 0.09}, 0.02);
    colour = mix(colour, flush, red);
    // Stubble along jaw and upper lip.
    const double jaw = std::max(0.55 * above(-p.y(), -1.548, 0.03) * above(p.z(), 0.0, 0.04),
                                0.8 * blob(m, {0.008, 1.5645, 0.095}, 0.011)) *
                       above(p.y(), 1.490, 0.03);
    colour = mix(colour, mix(palette.hair, palette.skin, 0.45),
                 jaw * (0.24 + 0.12 * valueNoise(p.x() * 800, p.y() * 800, p.z() * 800, palette.seed + 26)));
    if (p.z() < 0.03)
        return mix(colour, colour * 0.62, 0.8 * blob(m, {0.0895, 1.600, 0.0025}, 0.0085));
    colour = mix(colour, colour * 0.86, 0.8 * blob(m, {0.0165, 1.622, 0.085}, 0.010));
    colour = brow(colour, x, p.y(), palette);
    colour = eye(colour, x - 0.0330, p.y() - 1.6190, palette);
    colour = mouth(colour, x, p.y(), palette);
    colour = mix(colour, Vec3d(0.28, 0.13, 0.10),
                 0.85 * band(std::hypot((x - 0.0068) / 1.5, p.y() - 1.5757), 0.0019, 0.0018));
    return mix(colour, colour * 0.80,
               0.6 * band(std::hypot((x - 0.0195), (p.y() - 1.5835) * 0.6), 0.0022, 0.004));
}

Vec3d hand(Vec3d colour, const PaintPlace& place)
{
    const BodyJoints joints = referenceJoints();
    const Vec3d along = (joints.elbow - joints.shoulder).normalized();
    const Vec3d q = Vec3d(std::abs(place.p.x()), place.p.y(), place.p.z()) - joints.wrist;
    const double way = q.dot(along);
    const Vec3d flush(0.80, 0.47, 0.39);
    const bool isBack =
        Vec3d(std::abs(place.normal.x()), place.normal.y(), place.normal.z()).dot(Vec3d(0.766, 0.643, 0)) >
        0.3;
    double red = 0.22 * band(way - 0.090, 0.006, 0.014) + 0.20 * above(way, 0.155, 0.03);
    if (!isBack)
        red += 0.15;
    colour = mix(colour, flush, red);
    if (isBack) {
        for (const double knuckle : {0.128, 0.150})
            colour = mix(colour, colour * 0.84, 0.6 * band(way - knuckle, 0.0010, 0.0026));
        colour = mix(colour, Vec3d(0.93, 0.75, 0.68), 0.7 * above(way, 0.163, 0.004));
    } else {
        const double life = std::hypot(way - 0.02, q.z() - 0.045) - 0.046;
        colour = mix(colour, colour * 0.82, 0.7 * band(life, 0.0008, 0.002) * (way < 0.09));
        colour = mix(colour, colour * 0.82, 0.6 * band(way - 0.073 - 0.25 * q.z(), 0.0008, 0.002));
    }
    return colour;
}

} // namespace

Vec3d paintSkin(const PaintPlace& place, const Palette& palette)
{
    const Vec3d& p = place.p;
    if (place.part == FigurePart::Head && place.isHair)
        return hairColour(place, palette);
    const double mottled = 0.5 * valueNoise(p.x() * 60, p.y() * 60, p.z() * 60, palette.seed + 30) +
                           0.5 * valueNoise(p.x() * 330, p.y() * 330, p.z() * 330, palette.seed + 31);
    Vec3d colour = palette.skin * (1 + 0.045 * mottled);
    colour.x() *= 1 + 0.012 * valueNoise(p.x() * 35, p.y() * 35, p.z() * 35, palette.seed + 32);
    if (place.part == FigurePart::Head)
        return face(colour, place, palette);
    if (place.part == FigurePart::Hand)
        return hand(colour, place);
    return colour;
}

Vec3d paint(const PaintPlace& place, const Palette& palette)
{
    bool isSkin = place.part == FigurePart::Head || place.part == FigurePart::Hand;
    if (place.part == FigurePart::Arm) {
        const BodyJoints joints = referenceJoints();
        const Vec3d p(std::abs(place.p.x()), place.p.y(), place.p.z());
        isSkin = (p - joints.shoulder).dot((joints.elbow - joints.shoulder).normalized()) > sleeveEnd;
    }
    const Vec3d colour = isSkin ? paintSkin(place, palette) : paintClothes(place, palette);
    return colour.cwiseMax(0.0).cwiseMin(1.0);
}

} // namespace quadrille
