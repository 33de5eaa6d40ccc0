// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/geometry/procrustes.h"
#include "model/sequence/axes.h"

#include <Eigen/Geometry>

namespace quadrille {

/// The ground seen from above: two axes of it, of which the second lies a quarter turn counter-clockwise from
/// the first. They are z and x where y is up, x and y where z is up, y and z where x is up.
class Ground
{
public:
    explicit Ground(UpAxis up) : m_up(static_cast<Eigen::Index>(up)) {}

    Vec2d of(const Vec3d& point) const { return {point[(m_up + 1) % 3], point[(m_up + 2) % 3]}; }
    double heightOf(const Vec3d& point) const { return point[m_up]; }
    Vec3d at(const Vec2d& point, double height) const;
    /// 0, 1 or 2.
    Eigen::Index upAxis() const { return m_up; }
    Vec3d up() const { return Vec3d::Unit(m_up); }

private:
    Eigen::Index m_up;
};

/// A rigid motion over the ground: a turn about the up axis through the origin, then a shift.
struct GroundMotion
{
    double turn = 0;             ///< radians, counter-clockwise seen from above
    Vec2d shift = Vec2d::Zero(); ///< metres

    Vec2d operator()(const Vec2d& point) const { return Eigen::Rotation2Dd(turn) * point + shift; }
    /// The point moved over the ground; its height stays.
    Vec3d operator()(const Vec3d& point, const Ground& ground) const;
    /// First the other motion, then this one.
    GroundMotion operator*(const GroundMotion& other) const
    {
        return {turn + other.turn, (*this)(other.shift)};
    }
    GroundMotion inverse() const;
    RigidMotion inSpace(const Ground& ground) const;

    bool operator==(const GroundMotion&) const = default;

    /// The motion that turns by an angle and takes a point to another.
    static GroundMotion taking(const Vec2d& from, const Vec2d& to, double turn);
};

/// A share of a motion along a straight line, or a circle where it turns; shares add up. The turn counts as
/// the one in (−π, π] that means the same.
GroundMotion partOf(const GroundMotion& motion, double share);

/// The angle in (−π, π] that means the same, radians.
double wrappedAngle(double angle);

} // namespace quadrille
