// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

using Member = double LoftKey::*;
constexpr std::array<Member, 5> members = {&LoftKey::width, &LoftKey::front, &LoftKey::back, &LoftKey::offset,
                                           &LoftKey::forward};

double slope(const std::vector<LoftKey>& keys, std::size_t i, Member member)
{
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, keys.size() - 1);
    return (keys[after].*member - keys[before].*member) / (keys[after].at - keys[before].at);
}

/// Cubic Hermite interpolation with central differences.
LoftKey interpolate(const std::vector<LoftKey>& keys, double at)
{
    std::size_t i = 0;
    while (i + 2 < keys.size() && at > keys[i + 1].at)
        ++i;
    const double span = keys[i + 1].at - keys[i].at;
    const double t = std::clamp((at - keys[i].at) / span, 0.0, 1.0);
    const double t2 = t * t;
    const double t3 = t2 * t;
    LoftKey result;
    result.at = at;
    for (const Member member : members) {
        result.*member =
            (2 * t3 - 3 * t2 + 1) * keys[i].*member + (t3 - 2 * t2 + t) * span * slope(keys, i, member) +
            (3 * t2 - 2 * t3) * keys[i + 1].*member + (t3 - t2) * span * slope(keys, i + 1, member);
    }
    return result;
}

double power(double x, double exponent)
{
    return exponent == 2.0 ? x * x : std::pow(x, exponent);
}

} // namespace

double smoothUnion(double a, double b, double k)
{
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * k * 0.25;
}

double smoothIntersection(double a, double b, double k)
{
    return -smoothUnion(-a, -b, k);
}

double sphereDistance(const Vec3d& p, const Vec3d& centre, double radius)
{
    return (p - centre).norm() - radius;
}

double ellipsoidDistance(const Vec3d& p, const Vec3d& centre, const Vec3d& radii)
{
    const Vec3d q = p - centre;
    const double k0 = q.cwiseQuotient(radii).norm();
    const double k1 = q.cwiseQuotient(radii.cwiseAbs2()).norm();
    return k1 < 1e-9 ? -radii.minCoeff() : k0 * (k0 - 1) / k1;
}

double taperedCapsuleDistance(const Vec3d& p, const Vec3d& a, const Vec3d& b, double ra, double rb)
{
    const Vec3d axis = b - a;
    const double t = std::clamp((p - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    return (p - a - t * axis).norm() - (ra + t * (rb - ra));
}

Loft::Loft(const Frame& frame, const std::vector<LoftKey>& keys, double exponent)
    : m_frame(frame), m_first(keys.front().at), m_last(keys.back().at), m_exponent(exponent)
{
    for (int i = 0; i <= samples; ++i)
        m_table[static_cast<std::size_t>(i)] = interpolate(keys, m_first + (m_last - m_first) * i / samples);
}

LoftKey Loft::section(double at) const
{
    const double x = std::clamp((at - m_first) / (m_last - m_first), 0.0, 1.0) * samples;
    const auto i = std::min(static_cast<std::size_t>(x), static_cast<std::size_t>(samples - 1));
    const double t = x - static_cast<double>(i);
    LoftKey key;
    key.at = at;
    for (const Member member : members)
        key.*member = (1 - t) * m_table[i].*member + t * m_table[i + 1].*member;
    return key;
}

double Loft::distance(const Vec3d& p) const
{
    const Vec3d q = p - m_frame.origin;
    const double at = q.dot(m_frame.along);
    const LoftKey key = section(at);
    const double u = q.dot(m_frame.across) - key.offset;
    const double v = q.dot(m_frame.ahead) - key.forward;
    const double width = std::max(key.width, 1e-4);
    const double depth = std::max(v > 0 ? key.front : key.back, 1e-4);
    const double au = std::abs(u) / width;
    const double av = std::abs(v) / depth;
    const double k = std::pow(power(au, m_exponent) + power(av, m_exponent), 1 / m_exponent);
    double radial = -std::min(width, depth);
    if (k > 1e-6) {
        const double gu = power(au / k, m_exponent - 1) / width;
        const double gv = power(av / k, m_exponent - 1) / depth;
        radial = (k - 1) / std::max(std::hypot(gu, gv), 1e-3);
    }
    const double beyond = std::max(m_first - at, at - m_last);
    if (beyond <= 0)
        return std::max(radial, beyond);
    return std::hypot(std::max(radial, 0.0), beyond);
}

double Loft::atLeast(const Vec3d& p) const
{
    constexpr double anything = -1e9;
    const Vec3d q = p - m_frame.origin;
    const double at = q.dot(m_frame.along);
    if (const double beyond = std::max(m_first - at, at - m_last); beyond > 0)
        return beyond;
    const LoftKey key = section(at);
    const double v = q.dot(m_frame.ahead) - key.forward;
    const double width = std::max(key.width, 1e-4);
    const double depth = std::max(v > 0 ? key.front : key.back, 1e-4);
    // The norm of the superellipse is at least that of its larger part, and its gradient at most that of both
    // parts together.
    const double k = std::max(std::abs(q.dot(m_frame.across) - key.offset) / width, std::abs(v) / depth);
    return k <= 1 ? anything : (k - 1) * width * depth / std::hypot(width, depth);
}

} // namespace quadrille
