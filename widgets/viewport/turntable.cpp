// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/turntable.h"

#include <QtMath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr float shortestDistance = 0.02F;
constexpr float longestDistance = 2e6F; // two kilometres in the smallest unit, millimetres

/// From a frame whose up axis is y into the one asked for.
QVector3D toWorld(const QVector3D& v, UpAxis up)
{
    return up == UpAxis::Y ? v : QVector3D(v.x(), -v.z(), v.y());
}

float halfHeightAtDistanceOne(float fieldOfView)
{
    return std::tan(qDegreesToRadians(fieldOfView) / 2.0F);
}

} // namespace

QVector3D Turntable::position() const
{
    return target - forward() * distance;
}

QVector3D Turntable::forward() const
{
    const float a = qDegreesToRadians(yaw);
    const float b = qDegreesToRadians(pitch);
    return toWorld({-std::sin(a) * std::cos(b), -std::sin(b), -std::cos(a) * std::cos(b)}, upAxis);
}

QVector3D Turntable::right() const
{
    const float a = qDegreesToRadians(yaw);
    return toWorld({std::cos(a), 0.0F, -std::sin(a)}, upAxis);
}

QVector3D Turntable::up() const
{
    return QVector3D::crossProduct(right(), forward());
}

void Turntable::orbit(const QPointF& pixels, const QSizeF& view)
{
    yaw = std::remainder(yaw - 360.0F * static_cast<float>(pixels.x() / view.width()), 360.0F);
    pitch = std::clamp(pitch + 180.0F * static_cast<float>(pixels.y() / view.height()), -90.0F, 90.0F);
}

void Turntable::pan(const QPointF& pixels, const QSizeF& view)
{
    const float scale = metresPerPixel(view);
    target -= right() * (static_cast<float>(pixels.x()) * scale);
    target += up() * (static_cast<float>(pixels.y()) * scale);
}

void Turntable::zoom(float factor, const QPointF& cursor, const QSizeF& view)
{
    const float newDistance = std::clamp(distance * factor, shortestDistance, longestDistance);
    const float applied = newDistance / distance;
    const float scale = metresPerPixel(view);
    const QPointF offset = cursor - QPointF(view.width() / 2.0, view.height() / 2.0);
    const QVector3D under = target + right() * (static_cast<float>(offset.x()) * scale) -
                            up() * (static_cast<float>(offset.y()) * scale);
    target = under + (target - under) * applied;
    distance = newDistance;
}

void Turntable::frame(const QVector3D& lower, const QVector3D& upper, const QSizeF& view)
{
    target = (lower + upper) / 2.0F;
    constexpr float margin = 1.12F;
    const float slope = halfHeightAtDistanceOne(fieldOfView) / margin;
    const float aspect = static_cast<float>(view.width() / std::max(view.height(), 1.0));
    // The nearest place that sees every corner of the box.
    float needed = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const QVector3D d =
            QVector3D((corner & 1) != 0 ? upper.x() : lower.x(), (corner & 2) != 0 ? upper.y() : lower.y(),
                      (corner & 4) != 0 ? upper.z() : lower.z()) -
            target;
        const float across = std::abs(QVector3D::dotProduct(d, right())) / aspect;
        const float high = std::abs(QVector3D::dotProduct(d, up()));
        needed = std::max(needed, std::max(high, across) / slope - QVector3D::dotProduct(d, forward()));
    }
    distance = std::clamp(needed, shortestDistance, longestDistance);
}

void Turntable::look(StandardView view)
{
    switch (view) {
    case StandardView::Front:
        yaw = 0.0F, pitch = 0.0F;
        break;
    case StandardView::Back:
        yaw = 180.0F, pitch = 0.0F;
        break;
    case StandardView::Right:
        yaw = 90.0F, pitch = 0.0F;
        break;
    case StandardView::Left:
        yaw = -90.0F, pitch = 0.0F;
        break;
    case StandardView::Top:
        yaw = 0.0F, pitch = 90.0F;
        break;
    case StandardView::Bottom:
        yaw = 0.0F, pitch = -90.0F;
        break;
    }
}

Ray Turntable::rayThrough(const QPointF& pixel, const QSizeF& view) const
{
    const float perPixel = metresPerPixel(view) / distance;
    const auto x = static_cast<float>(pixel.x() - view.width() / 2.0) * perPixel;
    const auto y = static_cast<float>(view.height() / 2.0 - pixel.y()) * perPixel;
    return {position(), (forward() + right() * x + up() * y).normalized()};
}

bool Turntable::project(const QVector3D& point, const QSizeF& view, QPointF* pixel) const
{
    const QVector3D d = point - position();
    const float depth = QVector3D::dotProduct(d, forward());
    if (depth <= 1e-4F)
        return false;
    const float pixels = distance / (metresPerPixel(view) * depth);
    *pixel = QPointF(view.width() / 2.0 + QVector3D::dotProduct(d, right()) * pixels,
                     view.height() / 2.0 - QVector3D::dotProduct(d, up()) * pixels);
    return true;
}

float Turntable::metresPerPixel(const QSizeF& view) const
{
    return 2.0F * distance * halfHeightAtDistanceOne(fieldOfView) /
           static_cast<float>(std::max(view.height(), 1.0));
}

Turntable Turntable::between(const Turntable& from, const Turntable& to, float t)
{
    Turntable result = to;
    const auto mix = [t](auto a, auto b) { return a + (b - a) * t; };
    result.target = mix(from.target, to.target);
    result.yaw = from.yaw + std::remainder(to.yaw - from.yaw, 360.0F) * t;
    result.pitch = mix(from.pitch, to.pitch);
    result.distance = from.distance * std::pow(to.distance / from.distance, t);
    result.fieldOfView = mix(from.fieldOfView, to.fieldOfView);
    return result;
}

} // namespace quadrille::widgets
