// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/ruler.h"
#include "widgets/viewport/turntable.h"

#include <QPolygonF>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Where places on the ground and above it appear in a view, and which place a pixel means. Places are in the
/// view's unit, pixels are logical, from the upper left.
struct GroundView
{
    Turntable camera;
    QSizeF size;
    float ground = 0; ///< its height
    Ruler ruler;

    /// Which coordinate points up.
    int upIndex() const { return camera.upAxis == UpAxis::Y ? 1 : 2; }
    QVector3D up() const { return upIndex() == 1 ? QVector3D(0, 1, 0) : QVector3D(0, 0, 1); }
    /// The place right below or above, at the ground's height.
    QVector3D onGround(QVector3D place) const;
    /// None behind the camera.
    std::optional<QPointF> project(const QVector3D& place) const;
    /// Without those behind the camera.
    QPolygonF project(const std::vector<QVector3D>& places) const;
    /// Where the ray through a pixel meets the level plane of a height; none beyond 500 m, at the horizon.
    std::optional<QVector3D> placeAt(const QPointF& pixel, float height) const;
    /// The height at which the pointer's ray passes an upright line; from above only differences count.
    float heightAt(const QPointF& pixel, const QVector3D& foot) const;
    /// How much a pixel is at a place.
    float unitsPerPixel(const QVector3D& place) const;
    /// A level move as Shift (along one axis) and Ctrl (to lines of the grid) want it.
    QVector3D constrained(const QVector3D& from, QVector3D place, Qt::KeyboardModifiers modifiers) const;
};

} // namespace quadrille::widgets
