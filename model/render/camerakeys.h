// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/render/camera.h"

#include <span>
#include <vector>

namespace quadrille {

/// Where a camera stands at a time of a clip: around what it looks at, upright.
struct CameraKey
{
    double time = 0; ///< seconds from the clip's first frame
    Vec3d target{0, 0, 0};
    double distance = 4;
    /// Degrees: 0 is in front of a figure that faces the viewer, 90 on the right of the picture that one sees
    /// from there.
    double azimuth = 0;
    double elevation = 0;    ///< degrees above the horizon
    double fieldOfView = 30; ///< vertical, degrees

    bool operator==(const CameraKey&) const = default;
};

/// The camera between its keys: each value goes smoothly from one to the next, never beyond either, stands
/// still where two keys are alike, and turns the shorter way. Before the first key and after the last it
/// stands there. \pre Keys in the order of their times, at least one.
CameraKey cameraAt(std::span<const CameraKey> keys, double time);

Camera toCamera(const CameraKey& key, UpAxis up);
/// The key that looks as a camera does, upright. \pre Its eye is not at its target.
CameraKey toCameraKey(const Camera& camera, UpAxis up, double time);
/// The same key in other coordinates.
CameraKey converted(const CameraKey& key, const CoordinateSystem& from, const CoordinateSystem& to);

} // namespace quadrille
