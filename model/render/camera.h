// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/bounds.h"
#include "model/core/units.h"
#include "model/sequence/axes.h"

#include <span>

namespace quadrille {

/// A pinhole camera in the coordinates of the scene.
struct Camera
{
    Vec3d eye{0, 0, 5};
    Vec3d target{0, 0, 0};
    /// Need not be perpendicular to the direction of view.
    Vec3d up{0, 1, 0};
    double verticalFovDegrees = 30;
    /// What is nearer or farther, along the direction of view, is cut off.
    double nearDistance = 0.01;
    double farDistance = 1000;

    bool operator==(const Camera&) const = default;
};

/// How `frameAll` looks at a scene.
struct Framing
{
    UpAxis up = UpAxis::Y;
    /// From the scene towards the eye; the zero vector stands for `defaultDirection(up)`.
    Vec3d direction{0, 0, 0};
    double aspect = 1; ///< width / height of the picture
    double verticalFovDegrees = 30;
    double margin = 0.06; ///< of the picture's size, left free on each side

    bool operator==(const Framing&) const = default;
};

Vec3d upVector(UpAxis up);
/// From half left in front of a figure that faces the viewer, a little above: towards the eye.
Vec3d defaultDirection(UpAxis up);

/// The nearest camera that sees all points, the picture centred on them as perspective shows them.
/// Near and far distance enclose the points generously.
/// \pre At least one point, all finite.
Camera frameAll(std::span<const Vec3d> points, const Framing& framing);
/// \overload for the corners of a box. \pre The box is not empty.
Camera frameAll(const Bounds& bounds, const Framing& framing);
/// A camera for `turned`: sees the box from every side, its target on the box's vertical axis.
Camera frameTurntable(const Bounds& bounds, const Framing& framing);

/// The camera turned about the vertical axis through its target; one turn is a full revolution,
/// counter-clockwise seen from above.
Camera turned(const Camera& camera, UpAxis up, double turns);
/// The camera moved with its target.
Camera moved(const Camera& camera, const Vec3d& offset);

/// Sine and cosine of an angle in full turns; only +, −, × and /, so the same bits on every machine.
struct SineCosine
{
    double sine;
    double cosine;
};
SineCosine sineCosine(double turns);

} // namespace quadrille
