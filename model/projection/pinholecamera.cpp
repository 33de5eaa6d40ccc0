// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/projection/pinholecamera.h"

#include "model/core/image.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr int largestPicture = 16384;

bool isFinite(const PinholeCamera& camera)
{
    return std::isfinite(camera.fx) && std::isfinite(camera.fy) && std::isfinite(camera.cx) &&
           std::isfinite(camera.cy) && camera.rotation.allFinite() && camera.translation.allFinite() &&
           std::ranges::all_of(camera.distortion, [](double k) { return std::isfinite(k); });
}

/// The radius at which r · (1 + k1 r² + k2 r⁴ + k3 r⁶) stops to grow.
double foldOf(const std::array<double, 5>& d)
{
    const auto growth = [&](double r) {
        const double s = r * r;
        return 1 + s * (3 * d[0] + s * (5 * d[1] + s * 7 * d[4]));
    };
    constexpr double farthest = 20; // 87 degrees off the axis
    constexpr double step = 1.0 / 256;
    for (double r = step; r < farthest; r += step) {
        if (growth(r) > 0)
            continue;
        double low = r - step;
        double high = r;
        for (int i = 0; i < 40; ++i) {
            const double middle = (low + high) / 2;
            (growth(middle) > 0 ? low : high) = middle;
        }
        return low;
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

std::optional<CameraFault> faultOf(const PinholeCamera& camera)
{
    if (!isFinite(camera))
        return CameraFault{"Not all of its numbers are finite", "Calibrate it again."};
    if (camera.width < 1 || camera.height < 1 || camera.width > largestPicture ||
        camera.height > largestPicture)
        return CameraFault{"Its pictures have " + sizeText(camera.width, camera.height) + " pixels",
                           "Write a width and height from 1 to 16384."};
    if (camera.fx <= 0 || camera.fy <= 0)
        return CameraFault{"Its focal lengths are not positive",
                           "Write them in pixels, as in [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]."};
    // Calibrations are written with few digits.
    constexpr double rounding = 1e-3;
    const Eigen::Matrix3d product = camera.rotation * camera.rotation.transpose();
    if (!product.isApprox(Eigen::Matrix3d::Identity(), rounding))
        return CameraFault{"Its rotation is none: its rows are not of length one and perpendicular",
                           "Write the three rows of the rotation from the world into the camera."};
    if (camera.rotation.determinant() < 0)
        return CameraFault{"Its rotation mirrors",
                           "Write axes that are right-handed: x to the right, y down, z forward."};
    return std::nullopt;
}

CameraLens::CameraLens(const PinholeCamera& camera)
    : m_focal(camera.fx, camera.fy)
    , m_middle(camera.cx, camera.cy)
    , m_distortion(camera.distortion)
    , m_isDistorted(std::ranges::any_of(camera.distortion, [](double k) { return k != 0; }))
    , m_limit(foldOf(camera.distortion))
{
}

Vec2d CameraLens::distorted(const Vec2d& p) const
{
    const auto& [k1, k2, p1, p2, k3] = m_distortion;
    const double s = p.squaredNorm();
    const double radial = 1 + s * (k1 + s * (k2 + s * k3));
    const double xy = 2 * p.x() * p.y();
    return {p.x() * radial + p1 * xy + p2 * (s + 2 * p.x() * p.x()),
            p.y() * radial + p1 * (s + 2 * p.y() * p.y()) + p2 * xy};
}

std::optional<Vec2d> CameraLens::pixelOf(const Vec2d& ideal) const
{
    if (!(ideal.squaredNorm() < m_limit * m_limit)) // nor where it is not a number
        return std::nullopt;
    return m_middle + m_focal.cwiseProduct(m_isDistorted ? distorted(ideal) : ideal);
}

std::optional<Vec2d> CameraLens::idealOf(const Vec2d& pixel) const
{
    const Vec2d wanted = (pixel - m_middle).cwiseQuotient(m_focal);
    if (!m_isDistorted)
        return wanted;
    constexpr double accuracy = 1e-9;
    constexpr double step = 1e-6;
    Vec2d p = wanted;
    // Newton's method, by differences, from within the fold.
    for (int i = 0; i < 50; ++i) {
        if (p.norm() >= m_limit)
            p *= 0.99 * m_limit / p.norm();
        const Vec2d here = distorted(p);
        if ((here - wanted).norm() < accuracy)
            return p;
        Eigen::Matrix2d slope;
        slope.col(0) = (distorted(p + Vec2d(step, 0)) - here) / step;
        slope.col(1) = (distorted(p + Vec2d(0, step)) - here) / step;
        p -= slope.inverse() * (here - wanted);
        if (!p.allFinite())
            break;
    }
    return std::nullopt;
}

} // namespace quadrille
