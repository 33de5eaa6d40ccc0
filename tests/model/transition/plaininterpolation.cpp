// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/transition/plaininterpolation.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <numbers>

namespace quadrille {

namespace {

using Eigen::Matrix3d;
using Points = std::vector<Vec3d>;

Vec3d meanOf(const Points& points)
{
    Vec3d sum = Vec3d::Zero();
    for (const Vec3d& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

/// Columns v1 − v3, v2 − v3 and the unit normal.
Matrix3d edgeFrame(const Points& points, const Triangle& triangle)
{
    Matrix3d frame;
    frame.col(0) = points[triangle[0].value] - points[triangle[2].value];
    frame.col(1) = points[triangle[1].value] - points[triangle[2].value];
    frame.col(2) = frame.col(0).cross(frame.col(1)).normalized();
    return frame;
}

Matrix3d between(const Matrix3d& map, int wholeTurns, double lambda, InterpolationMethod method)
{
    const Eigen::JacobiSVD<Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
    Vec3d stretches = svd.singularValues();
    for (double& stretch : stretches) {
        stretch = method == InterpolationMethod::Slerp ? 1 - lambda + lambda * stretch
                                                       : std::exp(lambda * std::log(stretch));
    }
    const Eigen::AngleAxisd turn(rotation);
    const Matrix3d part =
        Eigen::AngleAxisd(lambda * (turn.angle() + 2 * std::numbers::pi * wholeTurns), turn.axis())
            .toRotationMatrix();
    return part * svd.matrixV() * stretches.asDiagonal() * svd.matrixV().transpose();
}

/// Moves the vertices of each connected component so that their mean is the origin.
void centreComponents(const Topology& topology, Points& points)
{
    const auto count = static_cast<std::size_t>(topology.statistics().components);
    Points sums(count, Vec3d::Zero());
    std::vector<double> sizes(count, 0);
    for (std::size_t v = 0; v < points.size(); ++v) {
        sums[static_cast<std::size_t>(topology.components()[v])] += points[v];
        sizes[static_cast<std::size_t>(topology.components()[v])] += 1;
    }
    for (std::size_t v = 0; v < points.size(); ++v) {
        const auto component = static_cast<std::size_t>(topology.components()[v]);
        points[v] -= sums[component] / sizes[component];
    }
}

Points deformed(const Topology& topology, const Points& rest, const Points& other, double lambda,
                InterpolationMethod method, const std::vector<int>& wholeTurns)
{
    const auto vertexCount = static_cast<Eigen::Index>(rest.size());
    const auto triangleCount = static_cast<Eigen::Index>(topology.triangles().size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd areas(3 * triangleCount);
    Eigen::MatrixX3d gradients(3 * triangleCount, 3);
    Matrix3d differences;
    differences << 1, 0, -1, 0, 1, -1, 0, 0, 0;
    for (Eigen::Index m = 0; m < triangleCount; ++m) {
        const Triangle& triangle = topology.triangles()[static_cast<std::size_t>(m)];
        const Matrix3d frame = edgeFrame(rest, triangle);
        const Matrix3d gradient = frame.transpose().inverse() * differences;
        Matrix3d corners;
        for (Eigen::Index c = 0; c < 3; ++c) {
            const std::uint32_t vertex = triangle[static_cast<std::size_t>(c)].value;
            corners.row(c) = rest[vertex].transpose();
            for (Eigen::Index r = 0; r < 3; ++r)
                entries.emplace_back(3 * m + r, vertex, gradient(r, c));
        }
        areas.segment<3>(3 * m).setConstant(0.5 * frame.col(0).cross(frame.col(1)).norm());
        const Matrix3d map = edgeFrame(other, triangle) * frame.inverse();
        const int turns = wholeTurns.empty() ? 0 : wholeTurns[static_cast<std::size_t>(m)];
        gradients.middleRows<3>(3 * m) = gradient * corners * between(map, turns, lambda, method).transpose();
    }
    Eigen::SparseMatrix<double> G(3 * triangleCount, vertexCount);
    G.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> divergence = G.transpose() * areas.asDiagonal();
    Eigen::SparseMatrix<double> system = divergence * G;
    const Eigen::MatrixX3d right = divergence * gradients;
    // A spring to the origin on one vertex of each component pins it: the solution without it is not changed.
    std::vector<bool> pinned(static_cast<std::size_t>(topology.statistics().components), false);
    for (Eigen::Index v = 0; v < vertexCount; ++v) {
        const auto component = static_cast<std::size_t>(topology.components()[static_cast<std::size_t>(v)]);
        if (!pinned[component])
            system.coeffRef(v, v) += 1;
        pinned[component] = true;
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
    const Eigen::MatrixX3d solution = solver.solve(right);
    Points points;
    for (Eigen::Index v = 0; v < vertexCount; ++v)
        points.emplace_back(solution.row(v).transpose());
    centreComponents(topology, points);
    return points;
}

} // namespace

std::vector<Vec3d> interpolatePlainly(const Topology& topology, Positions source, Positions target,
                                      double lambda, InterpolationMethod method,
                                      const std::vector<int>& wholeTurns)
{
    Points from;
    Points to;
    for (std::size_t v = 0; v < source.size(); ++v) {
        from.emplace_back(source[v].cast<double>());
        to.emplace_back(target[v].cast<double>());
    }
    const Vec3d fromMean = meanOf(from);
    const Vec3d toMean = meanOf(to);
    Matrix3d covariance = Matrix3d::Zero();
    for (std::size_t v = 0; v < from.size(); ++v)
        covariance += (to[v] - toMean) * (from[v] - fromMean).transpose();
    const Eigen::JacobiSVD<Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3d signs = Vec3d::Ones();
    signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    const Matrix3d rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    for (std::size_t v = 0; v < from.size(); ++v) {
        from[v] -= fromMean;
        to[v] = rotation.transpose() * (to[v] - toMean);
    }
    const Points forward = deformed(topology, from, to, lambda, method, wholeTurns);
    const Points backward = deformed(topology, to, from, 1 - lambda, method, wholeTurns);
    Points centred;
    Points centres;
    for (std::size_t v = 0; v < from.size(); ++v) {
        centred.push_back((1 - lambda) * from[v] + lambda * to[v]);
        centres.push_back(centred.back());
    }
    centreComponents(topology, centred);
    const Eigen::AngleAxisd turn(rotation);
    const Matrix3d part = Eigen::AngleAxisd(lambda * turn.angle(), turn.axis()).toRotationMatrix();
    Points out;
    for (std::size_t v = 0; v < from.size(); ++v) {
        const Vec3d local = (1 - lambda) * forward[v] + lambda * backward[v] + (centres[v] - centred[v]);
        out.push_back(part * local + (1 - lambda) * fromMean + lambda * toMean);
    }
    return out;
}

double largestDistance(Positions a, const std::vector<Vec3d>& b)
{
    double largest = 0;
    for (std::size_t v = 0; v < b.size(); ++v)
        largest = std::max(largest, (a[v].cast<double>() - b[v]).norm());
    return largest;
}

} // namespace quadrille
