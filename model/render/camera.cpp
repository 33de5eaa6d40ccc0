// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace quadrille {

namespace {

/// Axes of view: right, up and forward, orthonormal.
struct Frame3
{
    Vec3d right;
    Vec3d up;
    Vec3d forward;
};

Frame3 frameLooking(const Vec3d& forward, const Vec3d& upHint)
{
    Vec3d right = forward.cross(upHint);
    if (right.squaredNorm() < 1e-16 * forward.squaredNorm() * upHint.squaredNorm())
        right = forward.cross(Vec3d(upHint.z(), upHint.x(), upHint.y()));
    right.normalize();
    const Vec3d ahead = forward.normalized();
    return {right, right.cross(ahead), ahead};
}

std::array<Vec3d, 8> corners(const Bounds& bounds)
{
    std::array<Vec3d, 8> points;
    for (unsigned i = 0; i < 8; ++i) {
        points[i] = {(i & 1U) != 0 ? bounds.max.x() : bounds.min.x(),
                     (i & 2U) != 0 ? bounds.max.y() : bounds.min.y(),
                     (i & 4U) != 0 ? bounds.max.z() : bounds.min.z()};
    }
    return points;
}

/// Where the eye lies along an axis so that the outermost points on both sides are seen equally far out.
/// \param z of the eye along `forward`, before all points. \param start a first guess.
double centred(std::span<const Vec3d> points, const Vec3d& axis, const Vec3d& forward, double z, double start)
{
    double eye = start;
    for (int step = 0; step < 24; ++step) { // each step leaves a small share of the error
        double lowest = std::numeric_limits<double>::infinity();
        double highest = -lowest;
        double nearest = lowest;
        for (const Vec3d& point : points) {
            const double depth = forward.dot(point) - z;
            const double slope = (axis.dot(point) - eye) / depth;
            lowest = std::min(lowest, slope);
            highest = std::max(highest, slope);
            nearest = std::min(nearest, depth);
        }
        eye += (lowest + highest) / 2 * nearest;
    }
    return eye;
}

} // namespace

Vec3d upVector(UpAxis up)
{
    return Vec3d::Unit(static_cast<Eigen::Index>(up));
}

Vec3d defaultDirection(UpAxis up)
{
    const Vec3f inYUp(-0.45F, 0.22F, 1.0F);
    return (conversionMatrix({UpAxis::Y, 1}, {up, 1}) * inYUp).cast<double>();
}

Camera frameAll(std::span<const Vec3d> points, const Framing& framing)
{
    Camera camera;
    camera.up = upVector(framing.up);
    camera.verticalFovDegrees = framing.verticalFovDegrees;
    const Vec3d direction = framing.direction.isZero() ? defaultDirection(framing.up) : framing.direction;
    const Frame3 axes = frameLooking(-direction, camera.up);
    const auto [sine, cosine] = sineCosine(framing.verticalFovDegrees / 720.0);
    const double tangentY = sine / cosine * (1 - 2 * framing.margin);
    const double tangentX = tangentY * framing.aspect;

    // Each side plane of the pyramid of view is pushed outwards until it touches the points; where
    // opposite planes meet lies the eye.
    const double none = -std::numeric_limits<double>::infinity();
    double right = none;
    double left = none;
    double top = none;
    double bottom = none;
    double nearest = -none;
    double farthest = none;
    for (const Vec3d& point : points) {
        const double x = axes.right.dot(point);
        const double y = axes.up.dot(point);
        const double z = axes.forward.dot(point);
        right = std::max(right, x - tangentX * z);
        left = std::max(left, -x - tangentX * z);
        top = std::max(top, y - tangentY * z);
        bottom = std::max(bottom, -y - tangentY * z);
        nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
    const double depth = std::min(-(right + left) / (2 * tangentX), -(top + bottom) / (2 * tangentY));
    const double extent = std::max(farthest - nearest, 1e-6);
    // A flat scene seen edge-on, or a single point, would put the eye into it.
    const double z = std::min(depth, nearest - 1e-3 * extent);
    const double x = centred(points, axes.right, axes.forward, z, (right - left) / 2);
    const double y = centred(points, axes.up, axes.forward, z, (top - bottom) / 2);
    camera.eye = axes.right * x + axes.up * y + axes.forward * z;
    const double middle = (nearest + farthest) / 2 - z;
    camera.target = camera.eye + axes.forward * middle;
    camera.nearDistance = std::max((nearest - z) * 0.1, 1e-4 * middle);
    camera.farDistance = (farthest - z) * 10;
    return camera;
}

Camera frameAll(const Bounds& bounds, const Framing& framing)
{
    return frameAll(corners(bounds), framing);
}

Camera frameTurntable(const Bounds& bounds, const Framing& framing)
{
    const Vec3d up = upVector(framing.up);
    const Vec3d half = bounds.size() / 2;
    const double height = half.dot(up);
    const double radius = (half - height * up).norm();
    const Vec3d direction = framing.direction.isZero() ? defaultDirection(framing.up) : framing.direction;
    const Frame3 axes = frameLooking(direction - direction.dot(up) * up, up);
    constexpr int sides = 32;
    std::vector<Vec3d> points;
    for (int i = 0; i < sides; ++i) {
        const auto [sine, cosine] = sineCosine(static_cast<double>(i) / sides);
        const Vec3d rim = bounds.center() + radius * (sine * axes.right + cosine * axes.forward);
        points.emplace_back(rim + height * up);
        points.emplace_back(rim - height * up);
    }
    Camera camera = frameAll(points, framing);
    // The target moves along the line of sight to the vertical axis, so that turning keeps the scene in
    // place.
    const Vec3d sight = (camera.target - camera.eye).normalized();
    const Vec3d flat = sight - sight.dot(up) * up;
    const double along = flat.squaredNorm();
    if (along > 1e-12)
        camera.target = camera.eye + sight * (flat.dot(bounds.center() - camera.eye) / along);
    return camera;
}

Camera turned(const Camera& camera, UpAxis up, double turns)
{
    const auto [sine, cosine] = sineCosine(turns);
    const Vec3d axis = upVector(up);
    const auto turn = [&, s = sine, c = cosine](const Vec3d& v) -> Vec3d {
        const Vec3d along = axis * axis.dot(v);
        return along + (v - along) * c + axis.cross(v) * s;
    };
    Camera result = camera;
    result.eye = camera.target + turn(camera.eye - camera.target);
    result.up = turn(camera.up);
    return result;
}

Camera moved(const Camera& camera, const Vec3d& offset)
{
    Camera result = camera;
    result.eye += offset;
    result.target += offset;
    return result;
}

SineCosine sineCosine(double turns)
{
    const double fraction = turns - std::floor(turns);
    const int octant = static_cast<int>(std::lrint(fraction * 4)) * 2;
    constexpr double tau = 6.283185307179586476925286766559;
    const double x = (fraction - octant / 8.0) * tau; // within ±τ/8
    const double square = x * x;
    double sine = 1;
    double cosine = 1;
    // Taylor series to x^20, by Horner's scheme.
    for (int k = 20; k >= 2; k -= 2) {
        sine = 1 - square / (k * (k + 1)) * sine;
        cosine = 1 - square / (k * (k - 1)) * cosine;
    }
    sine *= x;
    switch (octant & 7) {
    case 2:
        return {cosine, -sine};
    case 4:
        return {-sine, -cosine};
    case 6:
        return {-cosine, sine};
    default:
        return {sine, cosine};
    }
}

} // namespace quadrille
