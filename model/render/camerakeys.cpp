// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/camerakeys.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

constexpr std::size_t valueCount = 7;
using Values = std::array<double, valueCount>;

/// What is interpolated: the distance by its logarithm, so that nearing looks even.
Values valuesOf(const CameraKey& key)
{
    return {key.target.x(), key.target.y(), key.target.z(), std::log(key.distance),
            key.azimuth,    key.elevation,  key.fieldOfView};
}

/// The angle that is the same direction and at most half a turn away from another.
double near(double degrees, double other)
{
    return degrees - 360 * std::round((degrees - other) / 360);
}

/// Slope at a point between two others: the harmonic mean of both sides' (Fritsch and Butland 1984), so that
/// the curve stays monotone; 0 where it turns.
double slopeBetween(double before, double after, double timeBefore, double timeAfter)
{
    if (!(before * after > 0))
        return 0;
    const double weightBefore = 2 * timeAfter + timeBefore;
    const double weightAfter = timeAfter + 2 * timeBefore;
    return (weightBefore + weightAfter) / (weightBefore / before + weightAfter / after);
}

/// Keys whose azimuths go the shorter way, from the first on.
class Track
{
public:
    explicit Track(std::span<const CameraKey> keys) : m_keys(keys), m_values(keys.size())
    {
        double azimuth = keys.front().azimuth;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            m_values[i] = valuesOf(keys[i]);
            azimuth = near(keys[i].azimuth, azimuth);
            m_values[i][4] = azimuth;
        }
    }

    Values at(std::size_t i, double time) const
    {
        const double length = lengthFrom(i);
        const double s = (time - m_keys[i].time) / length;
        const double rest = 1 - s;
        Values result{};
        for (std::size_t v = 0; v < valueCount; ++v)
            result[v] = rest * rest * (1 + 2 * s) * m_values[i][v] +
                        s * s * (3 - 2 * s) * m_values[i + 1][v] +
                        length * s * rest * (rest * slope(i, v) - s * slope(i + 1, v));
        return result;
    }

private:
    double lengthFrom(std::size_t i) const { return m_keys[i + 1].time - m_keys[i].time; }
    double secant(std::size_t i, std::size_t v) const
    {
        return (m_values[i + 1][v] - m_values[i][v]) / lengthFrom(i);
    }
    /// The camera sets off and arrives softly.
    double slope(std::size_t i, std::size_t v) const
    {
        if (i == 0 || i + 1 == m_keys.size())
            return 0;
        return slopeBetween(secant(i - 1, v), secant(i, v), lengthFrom(i - 1), lengthFrom(i));
    }

    std::span<const CameraKey> m_keys;
    std::vector<Values> m_values;
};

/// The axes that azimuths are counted from: to the right, up, and towards the viewer.
Eigen::Matrix3d viewerAxes(UpAxis up)
{
    return conversionMatrix({UpAxis::Y, 1}, {up, 1}).cast<double>();
}

} // namespace

CameraKey cameraAt(std::span<const CameraKey> keys, double time)
{
    assert(!keys.empty());
    const auto next = std::upper_bound(keys.begin(), keys.end(), time,
                                       [](double t, const CameraKey& key) { return t < key.time; });
    if (next == keys.begin() || next == keys.end()) {
        CameraKey key = next == keys.begin() ? keys.front() : keys.back();
        key.time = time;
        return key;
    }
    const Values values = Track(keys).at(static_cast<std::size_t>(next - keys.begin()) - 1, time);
    return {.time = time,
            .target = {values[0], values[1], values[2]},
            .distance = std::exp(values[3]),
            .azimuth = near(values[4], 0),
            .elevation = values[5],
            .fieldOfView = values[6]};
}

Camera toCamera(const CameraKey& key, UpAxis up)
{
    const Eigen::Matrix3d axes = viewerAxes(up);
    const SineCosine azimuth = sineCosine(key.azimuth / 360);
    const SineCosine elevation = sineCosine(key.elevation / 360);
    const Vec3d sideways = axes.col(0) * azimuth.sine + axes.col(2) * azimuth.cosine;
    const Vec3d direction = sideways * elevation.cosine + axes.col(1) * elevation.sine;
    return {.eye = key.target + direction * key.distance,
            .target = key.target,
            // Right above the figure, up in the picture is away from the viewer.
            .up = axes.col(1) * elevation.cosine - sideways * elevation.sine,
            .verticalFovDegrees = key.fieldOfView,
            .nearDistance = key.distance / 100,
            .farDistance = key.distance * 1000};
}

CameraKey toCameraKey(const Camera& camera, UpAxis up, double time)
{
    const Vec3d seen = viewerAxes(up).transpose() * (camera.eye - camera.target);
    constexpr double degrees = 180 / std::numbers::pi;
    return {.time = time,
            .target = camera.target,
            .distance = seen.norm(),
            .azimuth = std::atan2(seen.x(), seen.z()) * degrees,
            .elevation = std::atan2(seen.y(), std::hypot(seen.x(), seen.z())) * degrees,
            .fieldOfView = camera.verticalFovDegrees};
}

CameraKey converted(const CameraKey& key, const CoordinateSystem& from, const CoordinateSystem& to)
{
    const Eigen::Matrix3d matrix = conversionMatrix(from, to).cast<double>();
    CameraKey result = key;
    result.target = matrix * key.target;
    result.distance = key.distance * matrix.col(0).norm();
    return result;
}

} // namespace quadrille
