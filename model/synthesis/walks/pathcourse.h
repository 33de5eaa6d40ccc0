// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/ground.h"
#include "model/synthesis/walks/constraints.h"

#include <vector>

namespace quadrille {

/// The curve of a path by its arc length, and the obstacles beside it. Points are (ground x, ground y,
/// height), metres, with height 0 where heights do not count.
class PathCourse
{
public:
    /// \param metresPerUnit  of the coordinates of captured frames.
    PathCourse(const PathConstraint& path, UpAxis up, double metresPerUnit = 1);

    double length() const { return m_length; }
    double metresPerUnit() const { return m_metresPerUnit; }
    /// Beyond its end the curve goes straight on.
    Vec3d at(double arcLength) const;
    /// The angle of the way to a point a little farther on, radians counter-clockwise from the first axis.
    double directionFrom(double arcLength, double ahead) const;
    /// The point of a captured frame. \param centre  in its coordinates.
    Vec3d pointOf(const Vec3d& centre) const;
    bool hasObstacles() const { return !m_obstacles.empty(); }
    /// The obstacle that a point is too close to; −1: none.
    int obstacleAt(const Vec2d& point) const;

private:
    Ground m_ground;
    bool m_inSpace;
    double m_metresPerUnit;
    double m_length = 0;
    double m_spacing = 1;
    std::vector<Vec3d> m_points; ///< at equal arc lengths
    Vec3d m_direction = Vec3d::Zero();
    std::vector<Obstacle> m_obstacles;

    Vec3d flattened(const Vec3d& point) const;
};

/// Distance of a point from the closed area of an obstacle; 0 inside.
double distanceFrom(const Obstacle& obstacle, const Vec2d& point);

} // namespace quadrille
