// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/groundpoint.h"

#include <algorithm>

namespace quadrille {

Vec3d pointOnGround(const Vec2d& point, UpAxis up)
{
    switch (up) {
    case UpAxis::X:
        return {0, point.x(), point.y()};
    case UpAxis::Y:
        return {point.x(), 0, point.y()};
    case UpAxis::Z:
        break;
    }
    return {point.x(), point.y(), 0};
}

Vec2d pointOfFile(const Vec3d& point, UpAxis up)
{
    switch (up) {
    case UpAxis::X:
        return {point.y(), point.z()};
    case UpAxis::Y:
        return {point.x(), point.z()};
    case UpAxis::Z:
        break;
    }
    return {point.x(), point.y()};
}

double farthestPlace(double metresPerUnit)
{
    constexpr double metres = 10'000;
    constexpr double units = 1e7; // 10 km in millimetres
    return std::min(metres / metresPerUnit, units);
}

} // namespace quadrille
