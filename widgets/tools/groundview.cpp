// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/groundview.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

QVector3D GroundView::onGround(QVector3D place) const
{
    place[upIndex()] = ground;
    return place;
}

std::optional<QPointF> GroundView::project(const QVector3D& place) const
{
    QPointF pixel;
    return camera.project(place, size, &pixel) ? std::optional(pixel) : std::nullopt;
}

QPolygonF GroundView::project(const std::vector<QVector3D>& places) const
{
    QPolygonF pixels;
    for (const QVector3D& place : places)
        if (const auto pixel = project(place))
            pixels << *pixel;
    return pixels;
}

std::optional<QVector3D> GroundView::placeAt(const QPointF& pixel, float height) const
{
    const Ray ray = camera.rayThrough(pixel, size);
    const int up = upIndex();
    constexpr float farthest = 500.0F; // metres
    const float distance = (height - ray.origin[up]) / ray.direction[up];
    if (!(distance > 0.0F) || distance > ruler.of(farthest))
        return std::nullopt;
    QVector3D place = ray.origin + distance * ray.direction;
    place[up] = height;
    return place;
}

float GroundView::heightAt(const QPointF& pixel, const QVector3D& foot) const
{
    const Ray ray = camera.rayThrough(pixel, size);
    QVector3D normal = camera.forward();
    normal[upIndex()] = 0.0F;
    const float facing = QVector3D::dotProduct(ray.direction, normal);
    if (std::abs(facing) < 0.02F) // seen from above
        return -static_cast<float>(pixel.y()) * unitsPerPixel(foot);
    const float distance = QVector3D::dotProduct(foot - ray.origin, normal) / facing;
    return (ray.origin + distance * ray.direction)[upIndex()];
}

float GroundView::unitsPerPixel(const QVector3D& place) const
{
    const float depth = QVector3D::dotProduct(place - camera.position(), camera.forward());
    return camera.metresPerPixel(size) * std::max(depth, 0.01F) / camera.distance;
}

QVector3D GroundView::constrained(const QVector3D& from, QVector3D place,
                                  Qt::KeyboardModifiers modifiers) const
{
    const int up = upIndex();
    const bool keepsAxis = modifiers.testFlag(Qt::ShiftModifier);
    if (keepsAxis) {
        const int second = 3 - up;
        const QVector3D shift = place - from;
        const int kept = std::abs(shift[0]) >= std::abs(shift[second]) ? second : 0;
        place[kept] = from[kept];
    }
    if (modifiers.testFlag(Qt::ControlModifier)) {
        constexpr float tenPixels = 10.0F;
        const auto middle = static_cast<float>(ruler.middle());
        const float step =
            unitsPerPixel(place) * tenPixels < middle ? middle : static_cast<float>(ruler.coarse());
        for (int axis = 0; axis < 3; ++axis)
            if (axis != up && (place[axis] != from[axis] || !keepsAxis))
                place[axis] = std::round(place[axis] / step) * step;
    }
    return place;
}

} // namespace quadrille::widgets
