// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <Eigen/Dense>
#include <cmath>
#include <span>

namespace quadrille::test {

/// The rotation that turns b onto a, centroids removed (Kabsch, by SVD).
inline Eigen::Matrix3d plainProcrustes(Positions a, Positions b)
{
    Vec3d meanA = Vec3d::Zero();
    Vec3d meanB = Vec3d::Zero();
    for (std::size_t v = 0; v < a.size(); ++v) {
        meanA += a[v].cast<double>();
        meanB += b[v].cast<double>();
    }
    meanA /= static_cast<double>(a.size());
    meanB /= static_cast<double>(a.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t v = 0; v < a.size(); ++v)
        covariance += (a[v].cast<double>() - meanA) * (b[v].cast<double>() - meanB).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d reflect = Eigen::Matrix3d::Identity();
    reflect(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixU() * reflect * svd.matrixV().transpose();
}

/// SMCAS eq. 1–2 as it is written, in double precision: polar decomposition of every triangle's map by SVD.
inline double plainSurfaceDistance(Positions a, Positions b, std::span<const Triangle> triangles,
                                   double weight)
{
    const Eigen::Matrix3d turn = plainProcrustes(a, b);
    const auto edges = [](Positions p, const Triangle& t) {
        Eigen::Matrix3d e;
        e.col(0) = (p[t[0].value].cast<double>() - p[t[2].value].cast<double>());
        e.col(1) = (p[t[1].value].cast<double>() - p[t[2].value].cast<double>());
        e.col(2) = e.col(0).cross(e.col(1)).normalized();
        return e;
    };
    double sum = 0;
    for (const Triangle& triangle : triangles) {
        const Eigen::Matrix3d map = turn * edges(b, triangle) * edges(a, triangle).inverse();
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
        const double stretch = svd.singularValues().array().log().matrix().norm();
        sum += Eigen::AngleAxisd(rotation).angle() + weight / std::sqrt(2.0) * stretch;
    }
    return sum / static_cast<double>(triangles.size());
}

inline double plainEuclideanDistance(Positions a, Positions b)
{
    const Eigen::Matrix3d turn = plainProcrustes(a, b);
    Vec3d meanA = Vec3d::Zero();
    Vec3d meanB = Vec3d::Zero();
    for (std::size_t v = 0; v < a.size(); ++v) {
        meanA += a[v].cast<double>() / static_cast<double>(a.size());
        meanB += b[v].cast<double>() / static_cast<double>(a.size());
    }
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        sum += ((a[v].cast<double>() - meanA) - turn * (b[v].cast<double>() - meanB)).norm();
    return sum / static_cast<double>(a.size());
}

} // namespace quadrille::test
