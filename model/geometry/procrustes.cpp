// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/procrustes.h"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Horn's matrix: its eigenvector of the largest eigenvalue is the quaternion (w, x, y, z).
Eigen::Matrix4d hornMatrix(const Eigen::Matrix3d& s)
{
    Eigen::Matrix4d n;
    n(0, 0) = s(0, 0) + s(1, 1) + s(2, 2);
    n(1, 1) = s(0, 0) - s(1, 1) - s(2, 2);
    n(2, 2) = s(1, 1) - s(0, 0) - s(2, 2);
    n(3, 3) = s(2, 2) - s(0, 0) - s(1, 1);
    n(0, 1) = n(1, 0) = s(2, 1) - s(1, 2);
    n(0, 2) = n(2, 0) = s(0, 2) - s(2, 0);
    n(0, 3) = n(3, 0) = s(1, 0) - s(0, 1);
    n(1, 2) = n(2, 1) = s(0, 1) + s(1, 0);
    n(1, 3) = n(3, 1) = s(0, 2) + s(2, 0);
    n(2, 3) = n(3, 2) = s(1, 2) + s(2, 1);
    return n;
}

Eigen::Quaterniond withPositiveW(const Eigen::Vector4d& v)
{
    const Eigen::Vector4d unit = v.normalized() * (v[0] < 0 ? -1 : 1);
    return {unit[0], unit[1], unit[2], unit[3]};
}

/// The vector nearest to no rotation among those that belong to the largest eigenvalue.
Eigen::Quaterniond smallestOfTheBest(const Eigen::Matrix4d& horn, double scale)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(horn);
    const Eigen::Vector4d& values = solver.eigenvalues(); // increasing
    Eigen::Vector4d nearest = Eigen::Vector4d::Zero();
    for (int k = 3; k >= 0 && values[k] >= values[3] - 1e-12 * scale; --k)
        nearest += solver.eigenvectors().col(k) * solver.eigenvectors()(0, k);
    if (nearest.squaredNorm() < 1e-20)
        return withPositiveW(solver.eigenvectors().col(3));
    return withPositiveW(nearest);
}

} // namespace

Eigen::Quaterniond rotationOfCovariance(const Eigen::Matrix3d& covariance)
{
    const double scale = covariance.norm();
    if (!(scale > 0))
        return Eigen::Quaterniond::Identity();
    const Eigen::Matrix3d s = covariance / scale;
    Eigen::Matrix4d horn = hornMatrix(s);

    // Newton from above on λ⁴ + c2·λ² + c1·λ + c0, whose largest root is at most the sum of the singular
    // values.
    const double c2 = -2 * s.squaredNorm();
    const double c1 = -8 * s.determinant();
    const double c0 = horn.determinant();
    double root = std::sqrt(3.0);
    for (int iteration = 0; iteration < 30; ++iteration) {
        const double square = root * root;
        const double slope = (4 * square + 2 * c2) * root + c1;
        if (!(slope > 1e-9))
            return smallestOfTheBest(horn, 1);
        const double step = (((square + c2) * root + c1) * root + c0) / slope;
        root -= step;
        if (std::abs(step) < 1e-15)
            break;
    }
    // Every column of the adjugate is a multiple of the eigenvector: take the longest.
    Eigen::Matrix4d shifted = horn;
    shifted.diagonal().array() -= root;
    const double a = shifted(2, 2) * shifted(3, 3) - shifted(2, 3) * shifted(2, 3);
    const double b = shifted(1, 2) * shifted(3, 3) - shifted(1, 3) * shifted(2, 3);
    const double c = shifted(1, 2) * shifted(2, 3) - shifted(1, 3) * shifted(2, 2);
    const double d = shifted(0, 2) * shifted(3, 3) - shifted(0, 3) * shifted(2, 3);
    const double e = shifted(0, 2) * shifted(2, 3) - shifted(0, 3) * shifted(2, 2);
    const double f = shifted(0, 2) * shifted(1, 3) - shifted(0, 3) * shifted(1, 2);
    const double g = shifted(0, 1) * shifted(1, 2) - shifted(0, 2) * shifted(1, 1);
    const double h = shifted(0, 1) * shifted(1, 3) - shifted(0, 3) * shifted(1, 1);
    const double p = shifted(0, 0) * shifted(1, 1) - shifted(0, 1) * shifted(0, 1);
    const double q = shifted(0, 0) * shifted(1, 2) - shifted(0, 2) * shifted(0, 1);
    const double r = shifted(0, 0) * shifted(1, 3) - shifted(0, 3) * shifted(0, 1);
    Eigen::Matrix4d adjugate;
    adjugate(0, 0) = shifted(1, 1) * a - shifted(1, 2) * b + shifted(1, 3) * c;
    adjugate(1, 1) = shifted(0, 0) * a - shifted(0, 2) * d + shifted(0, 3) * e;
    adjugate(0, 1) = -(shifted(0, 1) * a - shifted(0, 2) * b + shifted(0, 3) * c);
    adjugate(0, 2) = shifted(0, 1) * b - shifted(1, 1) * d + shifted(1, 3) * f;
    adjugate(0, 3) = -(shifted(0, 1) * c - shifted(1, 1) * e + shifted(1, 2) * f);
    adjugate(1, 2) = -(shifted(0, 0) * b - shifted(0, 1) * d + shifted(0, 3) * f);
    adjugate(1, 3) = shifted(0, 0) * c - shifted(0, 1) * e + shifted(0, 2) * f;
    adjugate(2, 2) = shifted(3, 3) * p - shifted(1, 3) * r + shifted(0, 3) * h;
    adjugate(3, 3) = shifted(2, 2) * p - shifted(1, 2) * q + shifted(0, 2) * g;
    adjugate(2, 3) = -(shifted(2, 3) * p - shifted(1, 3) * q + shifted(0, 3) * g);
    adjugate.triangularView<Eigen::StrictlyLower>() = adjugate.transpose();
    int longest = 0;
    adjugate.diagonal().cwiseAbs().maxCoeff(&longest);
    if (!(std::abs(adjugate(longest, longest)) > 1e-3))
        return smallestOfTheBest(horn, 1);
    return withPositiveW(adjugate.col(longest));
}

Vec3d centroid(Positions positions)
{
    Vec3d sum = Vec3d::Zero();
    for (const Vec3f& p : positions)
        sum += p.cast<double>();
    return positions.empty() ? sum : Vec3d(sum / static_cast<double>(positions.size()));
}

RigidMotion rigidProcrustes(Positions moved, Positions target)
{
    assert(moved.size() == target.size());
    const Vec3d from = centroid(moved);
    const Vec3d to = centroid(target);
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t v = 0; v < moved.size(); ++v)
        covariance += (target[v].cast<double>() - to) * (moved[v].cast<double>() - from).transpose();
    const Eigen::Quaterniond rotation = rotationOfCovariance(covariance);
    return {rotation, to - rotation * from};
}

RigidMotion rigidProcrustes(Positions moved, Positions target, std::span<const double> weights)
{
    assert(moved.size() == target.size() && moved.size() == weights.size());
    Vec3d from = Vec3d::Zero();
    Vec3d to = Vec3d::Zero();
    double sum = 0;
    for (std::size_t v = 0; v < moved.size(); ++v) {
        from += weights[v] * moved[v].cast<double>();
        to += weights[v] * target[v].cast<double>();
        sum += weights[v];
    }
    from /= sum;
    to /= sum;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t v = 0; v < moved.size(); ++v) {
        covariance +=
            weights[v] * (target[v].cast<double>() - to) * (moved[v].cast<double>() - from).transpose();
    }
    const Eigen::Quaterniond rotation = rotationOfCovariance(covariance);
    return {rotation, to - rotation * from};
}

} // namespace quadrille
