// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfaceview.h"

#include "widgets/tools/pixeldistances.h"
#include "widgets/viewport/surfacepick.h"

#include <QtMath>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::widgets {

namespace {

/// Where an arrow key points on the view; null for other keys.
QPointF directionOf(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return {-1.0, 0.0};
    case Qt::Key_Right:
        return {1.0, 0.0};
    case Qt::Key_Up:
        return {0.0, -1.0};
    case Qt::Key_Down:
        return {0.0, 1.0};
    default:
        return {};
    }
}

/// The vertices that share an edge with a vertex, some of them twice.
std::vector<std::uint32_t> neighboursOf(std::uint32_t vertex, const FigureMesh& mesh)
{
    std::vector<std::uint32_t> neighbours;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            if (triangle[corner] == vertex)
                neighbours.insert(neighbours.end(), {triangle[(corner + 1) % 3], triangle[(corner + 2) % 3]});
    return neighbours;
}

/// Outwards, of length one; null without triangles.
QVector3D normalAt(std::uint32_t vertex, const FigureShape& shape)
{
    QVector3D sum;
    for (const auto& triangle : shape.mesh.triangles)
        if (std::find(triangle.begin(), triangle.end(), vertex) != triangle.end())
            sum += QVector3D::crossProduct(shape.place(triangle[1]) - shape.place(triangle[0]),
                                           shape.place(triangle[2]) - shape.place(triangle[0]));
    return sum.normalized();
}

} // namespace

std::optional<QPointF> SurfaceView::project(const QVector3D& place) const
{
    QPointF pixel;
    return camera.project(place, size, &pixel) ? std::optional(pixel) : std::nullopt;
}

std::optional<SurfacePlace> SurfaceView::placeAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const
{
    const auto hit = pickSurface(shape.mesh, shape.positions, shape.shift, camera.rayThrough(pixel, size));
    if (!hit)
        return std::nullopt;
    return SurfacePlace{.pick = {figure, hit->triangle, hit->vertex, hit->barycentric, hit->point},
                        .snaps = !modifiers.testFlag(Qt::AltModifier)};
}

std::optional<SurfacePlace> SurfaceView::placeAt(std::uint32_t vertex, Qt::KeyboardModifiers modifiers) const
{
    const auto& triangles = shape.mesh.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto corner = std::find(triangles[t].begin(), triangles[t].end(), vertex);
        if (corner == triangles[t].end())
            continue;
        SurfacePlace found;
        found.pick.figure = figure;
        found.pick.triangle = static_cast<std::uint32_t>(t);
        found.pick.vertex = vertex;
        found.pick.barycentric[static_cast<std::size_t>(corner - triangles[t].begin())] = 1.0F;
        found.pick.point = place(vertex);
        found.snaps = !modifiers.testFlag(Qt::AltModifier);
        return found;
    }
    return std::nullopt;
}

std::optional<std::uint32_t> SurfaceView::nearestVertex(const QPointF& pixel) const
{
    std::optional<std::uint32_t> nearest;
    double least = std::numeric_limits<double>::max();
    for (std::uint32_t vertex = 0; vertex < shape.mesh.vertexCount; ++vertex) {
        const auto at = project(vertex);
        if (const double distance = at ? distanceBetween(*at, pixel) : least; distance < least) {
            least = distance;
            nearest = vertex;
        }
    }
    return nearest;
}

std::uint32_t SurfaceView::vertexTowards(std::uint32_t vertex, int key, Qt::KeyboardModifiers modifiers) const
{
    const QPointF direction = directionOf(key);
    const int steps = modifiers.testFlag(Qt::ShiftModifier) ? 5 : 1;
    for (int step = 0; step < steps; ++step) {
        const auto from = project(vertex);
        std::uint32_t best = vertex;
        double bestCosine = 0.3;
        for (const std::uint32_t next : neighboursOf(vertex, shape.mesh)) {
            const auto to = project(next);
            const double length = from && to ? distanceBetween(*from, *to) : 0.0;
            if (length <= 0.0)
                continue;
            if (const double cosine = QPointF::dotProduct(*to - *from, direction) / length;
                cosine > bestCosine) {
                bestCosine = cosine;
                best = next;
            }
        }
        vertex = best;
    }
    return vertex;
}

Turntable SurfaceView::facing(std::uint32_t vertex) const
{
    const QVector3D normal = normalAt(vertex, shape);
    SurfaceView turned = *this;
    Turntable& view = turned.camera;
    const bool isUpright = view.upAxis == UpAxis::Y;
    const float ahead = isUpright ? normal.z() : -normal.y();
    const float rise = isUpright ? normal.y() : normal.z();
    if (std::hypot(normal.x(), ahead) > 0.05F)
        view.yaw = qRadiansToDegrees(std::atan2(normal.x(), ahead));
    constexpr float steepest = 60.0F; // degrees
    view.pitch = std::clamp(qRadiansToDegrees(std::asin(std::clamp(rise, -1.0F, 1.0F))), -steepest, steepest);
    if (const auto pixel = turned.project(vertex); !pixel || !contains(*pixel))
        view.target = place(vertex);
    return view;
}

} // namespace quadrille::widgets
