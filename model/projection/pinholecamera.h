// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <array>
#include <optional>
#include <string>

namespace quadrille {

/// A calibrated camera as OpenCV has it. Its axes are x to the right, y down and z forward; the middle of a
/// picture's upper left pixel is (0, 0).
struct PinholeCamera
{
    std::string name;
    int width = 0; ///< of its pictures, pixels
    int height = 0;
    double fx = 0; ///< focal lengths, pixels
    double fy = 0;
    double cx = 0; ///< where the axis of view meets the picture, pixels
    double cy = 0;
    std::array<double, 5> distortion{}; ///< k1, k2, p1, p2, k3
    /// From the world into the camera: rotation · point + translation.
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Vec3d translation = Vec3d::Zero();

    bool operator==(const PinholeCamera&) const = default;
    Vec3d inCamera(const Vec3d& world) const { return rotation * world + translation; }
    /// Its place in the world.
    Vec3d centre() const { return -rotation.transpose() * translation; }
};

/// What makes a camera useless, and what to do about it; nothing where it is fit for use.
struct CameraFault
{
    std::string reason;
    std::string remedy;
};
std::optional<CameraFault> faultOf(const PinholeCamera& camera);

/// Where a camera's lens shows things. Ideal places are (x / z, y / z) of a point in the camera.
class CameraLens
{
public:
    /// \pre The camera has no fault.
    explicit CameraLens(const PinholeCamera& camera);

    /// \return pixels, also outside of the picture; nothing at places so far out that the model of
    /// distortion folds back, and would show them twice.
    std::optional<Vec2d> pixelOf(const Vec2d& ideal) const;
    /// The ideal place that is shown at a pixel; nothing where none is. By iteration, to 10⁻⁹.
    std::optional<Vec2d> idealOf(const Vec2d& pixel) const;
    /// The pixel of a point in the camera; nothing where it is not before the camera, and as pixelOf.
    std::optional<Vec2d> project(const Vec3d& inCamera) const
    {
        return inCamera.z() > 0 ? pixelOf(inCamera.head<2>() / inCamera.z()) : std::nullopt;
    }
    bool isDistorted() const { return m_isDistorted; }
    /// How far out ideal places may lie; infinite where nothing folds.
    double limit() const { return m_limit; }

private:
    Vec2d distorted(const Vec2d& ideal) const;

    Vec2d m_focal;
    Vec2d m_middle;
    std::array<double, 5> m_distortion;
    bool m_isDistorted;
    double m_limit;
};

} // namespace quadrille
