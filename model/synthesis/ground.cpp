// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/ground.h"

#include <cmath>
#include <numbers>

namespace quadrille {

Vec3d Ground::at(const Vec2d& point, double height) const
{
    Vec3d result;
    result[m_up] = height;
    result[(m_up + 1) % 3] = point.x();
    result[(m_up + 2) % 3] = point.y();
    return result;
}

Vec3d GroundMotion::operator()(const Vec3d& point, const Ground& ground) const
{
    return ground.at((*this)(ground.of(point)), ground.heightOf(point));
}

GroundMotion GroundMotion::inverse() const
{
    return {-turn, Eigen::Rotation2Dd(-turn) * -shift};
}

RigidMotion GroundMotion::inSpace(const Ground& ground) const
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(turn, ground.up())), ground.at(shift, 0)};
}

GroundMotion GroundMotion::taking(const Vec2d& from, const Vec2d& to, double turn)
{
    return {turn, to - Eigen::Rotation2Dd(turn) * from};
}

double wrappedAngle(double angle)
{
    const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
    return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

} // namespace quadrille
