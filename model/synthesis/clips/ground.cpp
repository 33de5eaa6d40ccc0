// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/ground.h"

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

GroundMotion partOf(const GroundMotion& motion, double share)
{
    // Exponential map: a turn by θ at an even pace shifts by V(θ)·u, u the shift seen from the moving figure.
    const auto shiftOfTurn = [](double turn) {
        const double cosine = std::abs(turn) < 1e-4 ? turn / 2 : (1 - std::cos(turn)) / turn;
        const double sine = std::abs(turn) < 1e-4 ? 1 - turn * turn / 6 : std::sin(turn) / turn;
        Eigen::Matrix2d matrix;
        matrix << sine, -cosine, cosine, sine;
        return matrix;
    };
    const double turn = wrappedAngle(motion.turn);
    const Vec2d pace = shiftOfTurn(turn).inverse() * motion.shift;
    return {share * turn, shiftOfTurn(share * turn) * (share * pace)};
}

double wrappedAngle(double angle)
{
    constexpr double turn = 2 * std::numbers::pi;
    double wrapped = angle;
    // Within a turn and a half differences are exact: as std::remainder, which takes ten times as long.
    if (std::abs(angle) > turn / 2)
        wrapped =
            std::abs(angle) < 1.5 * turn ? angle - std::copysign(turn, angle) : std::remainder(angle, turn);
    return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

} // namespace quadrille
