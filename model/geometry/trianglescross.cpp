// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/selfintersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

int signOf(double value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The sum of numbers without rounding, as numbers that do not overlap (Shewchuk's expansions).
class ExactSum
{
public:
    void add(double term)
    {
        double rest = term;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_count; ++i) {
            const double sum = rest + m_parts[i];
            const double part = sum - rest;
            const double error = (rest - (sum - part)) + (m_parts[i] - part);
            rest = sum;
            if (error != 0)
                m_parts[kept++] = error;
        }
        m_parts[kept++] = rest;
        m_count = kept;
    }
    int sign() const { return signOf(m_parts[m_count - 1]); }

private:
    std::array<double, 25> m_parts{};
    std::size_t m_count = 0;
};

int exactOrientation(const Vec3d& u, const Vec3d& v, const Vec3d& w)
{
    ExactSum sum;
    const auto addProduct = [&sum](double x, double y, double z) {
        const double xy = x * y;
        const double rest = std::fma(x, y, -xy);
        for (const double factor : {xy, rest}) {
            const double product = factor * z;
            sum.add(product);
            sum.add(std::fma(factor, z, -product));
        }
    };
    for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 0, 1}}) {
        addProduct(u[i], v[j], w[k]);
        addProduct(-u[i], v[k], w[j]);
    }
    return sum.sign();
}

/// On which side of the plane through a, b, c a point lies: 1 where they turn counter-clockwise, −1 on the
/// other side, 0 in the plane.
int sideOf(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& point)
{
    const Vec3d u = a - point;
    const Vec3d v = b - point;
    const Vec3d w = c - point;
    const double determinant = u.dot(v.cross(w));
    const Vec3d largest = u.cwiseAbs().cwiseMax(v.cwiseAbs()).cwiseMax(w.cwiseAbs());
    // Rounding stays below this share of the largest product.
    if (std::abs(determinant) > 1e-14 * largest.prod())
        return -signOf(determinant);
    return -exactOrientation(u, v, w);
}

/// A triangle and on which sides of another one's plane its corners lie.
struct Sided
{
    std::array<Vec3d, 3> corners;
    std::array<int, 3> sides{};

    bool crossesPlane() const
    {
        const auto [low, high] = std::ranges::minmax(sides);
        return low < 0 && high > 0;
    }
    /// Brings the corner to the front that has no other one on its side.
    void bringApexToFront()
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const int side = sides[i];
            if (side != 0 && sides[(i + 1) % 3] != side && sides[(i + 2) % 3] != side) {
                std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(i), corners.end());
                std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(i), sides.end());
                return;
            }
        }
    }
};

} // namespace

bool trianglesCross(const std::array<Vec3f, 3>& first, const std::array<Vec3f, 3>& second)
{
    Sided a;
    Sided b;
    for (std::size_t i = 0; i < 3; ++i) {
        a.corners[i] = first[i].cast<double>();
        b.corners[i] = second[i].cast<double>();
    }
    const auto setSides = [](Sided& of, const Sided& plane) {
        for (std::size_t i = 0; i < 3; ++i)
            of.sides[i] = sideOf(plane.corners[0], plane.corners[1], plane.corners[2], of.corners[i]);
    };
    setSides(a, b);
    if (!a.crossesPlane())
        return false;
    setSides(b, a);
    if (!b.crossesPlane())
        return false;
    a.bringApexToFront();
    b.bringApexToFront();
    // With both apexes on the positive sides, the planes' common line runs through both triangles in one
    // direction, and the ends of the stretches in which it does are compared.
    if (a.sides[0] < 0)
        std::swap(b.corners[1], b.corners[2]);
    if (b.sides[0] < 0)
        std::swap(a.corners[1], a.corners[2]);
    const auto& [p1, q1, r1] = a.corners;
    const auto& [p2, q2, r2] = b.corners;
    return sideOf(p1, q1, p2, q2) < 0 && sideOf(p1, r1, r2, p2) < 0;
}

} // namespace quadrille
