// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QSizeF>
#include <QVector3D>

namespace quadrille::widgets {

enum class UpAxis
{
    Y,
    Z
};

/// The views of keys 1, 3 and 7 and their opposites.
enum class StandardView
{
    Front,
    Back,
    Right,
    Left,
    Top,
    Bottom
};

/// A ray in the world. `direction` has length one.
struct Ray
{
    QVector3D origin;
    QVector3D direction;
};

/// A camera that turns about an upright axis through its target, as a value. Angles are degrees.
struct Turntable
{
    QVector3D target{0.0F, 0.9F, 0.0F};
    float yaw = 25.0F;   ///< 0 looks at the figure's front, 90 at its left side (from +x)
    float pitch = 12.0F; ///< −90 … 90, positive looks down
    float distance = 4.0F;
    float fieldOfView = 30.0F; ///< vertical
    UpAxis upAxis = UpAxis::Y;

    bool operator==(const Turntable&) const = default;

    /// Where the eye is.
    QVector3D position() const;
    /// Length one, as that of `right` and `up`.
    QVector3D forward() const;
    QVector3D right() const;
    QVector3D up() const;

    /// Turns as if the view's surface were dragged; a full width is 360 degrees.
    void orbit(const QPointF& pixels, const QSizeF& view);
    /// Shifts so that what lies at the target's depth stays under the pointer.
    void pan(const QPointF& pixels, const QSizeF& view);
    /// Changes the distance by a factor; what lies at the target's depth under `cursor` stays there.
    void zoom(float factor, const QPointF& cursor, const QSizeF& view);
    /// Points at the middle of a box and steps back until it fills the view.
    void frame(const QVector3D& lower, const QVector3D& upper, const QSizeF& view);
    /// Target and distance stay.
    void look(StandardView view);

    /// The ray through a pixel of the view.
    Ray rayThrough(const QPointF& pixel, const QSizeF& view) const;
    /// Where a point appears, in pixels from the upper left. \return false when it is behind the camera.
    bool project(const QVector3D& point, const QSizeF& view, QPointF* pixel) const;
    /// How long a pixel is at the target's depth, in the unit of the target.
    float metresPerPixel(const QSizeF& view) const;

    /// Between two cameras, t = 0 … 1; turns the shorter way round.
    static Turntable between(const Turntable& from, const Turntable& to, float t);
};

} // namespace quadrille::widgets
