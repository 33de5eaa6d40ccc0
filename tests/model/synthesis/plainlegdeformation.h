// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/finishing/footpath.h"

#include <Eigen/Dense>
#include <Eigen/SparseLU>
#include <algorithm>
#include <map>
#include <set>

namespace quadrille::test {

/// As-rigid-as-possible deformation of a leg as a textbook has it: everything anew at each call, general
/// linear solver, rotations by singular value decomposition.
inline void deformLegPlainly(const Topology& topology, const std::vector<std::uint32_t>& leg,
                             const std::vector<std::uint32_t>& foot, Positions reference,
                             const FootShift& shift, const Ground& ground, MutablePositions pose)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> weights;
    for (const Triangle& t : topology.triangles()) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = t[(c + 1) % 3].value;
            const std::uint32_t b = t[(c + 2) % 3].value;
            const Vec3d u = (reference[a] - reference[t[c].value]).cast<double>();
            const Vec3d v = (reference[b] - reference[t[c].value]).cast<double>();
            const double weight = std::clamp(0.5 * u.dot(v) / u.cross(v).norm(), 0.05, 5.0);
            weights[{a, b}] += weight;
            weights[{b, a}] += weight;
        }
    }
    const std::set<std::uint32_t> moved(foot.begin(), foot.end());
    std::map<std::uint32_t, int> rows;
    for (const std::uint32_t v : leg) {
        if (!moved.contains(v))
            rows.emplace(v, static_cast<int>(rows.size()));
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [edge, weight] : weights) {
        const auto row = rows.find(edge.first);
        if (row == rows.end())
            continue;
        entries.emplace_back(row->second, row->second, weight);
        if (const auto column = rows.find(edge.second); column != rows.end())
            entries.emplace_back(row->second, column->second, -weight);
    }
    const auto size = static_cast<Eigen::Index>(rows.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);

    std::vector<Vec3d> rest;
    for (const Vec3f& p : pose)
        rest.push_back(p.cast<double>());
    std::vector<Vec3d> now = rest;
    for (const std::uint32_t v : foot)
        now[v] = shift(rest[v], ground);
    // Harmonic field between foot and hip.
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    for (const auto& [edge, weight] : weights) {
        if (rows.contains(edge.first) && moved.contains(edge.second))
            right[rows[edge.first]] += weight;
    }
    const Eigen::VectorXd field = solver.solve(right);
    for (const auto& [v, row] : rows)
        now[v] += field[row] * (shift(rest[v], ground) - rest[v]);

    std::vector<Eigen::Matrix3d> rotations(pose.size(), Eigen::Matrix3d::Identity());
    for (const std::uint32_t v : foot)
        rotations[v] = Eigen::AngleAxisd(shift.turn, ground.up()).toRotationMatrix();
    for (int round = 0; round < 8; ++round) {
        std::map<std::uint32_t, Eigen::Matrix3d> covariances;
        for (const auto& [edge, weight] : weights) {
            const auto [a, b] = edge;
            if (!rows.contains(a))
                continue;
            auto [place, isNew] = covariances.try_emplace(a, Eigen::Matrix3d::Zero());
            place->second += weight * (rest[b] - rest[a]) * (now[b] - now[a]).transpose();
        }
        for (const auto& [v, covariance] : covariances) {
            const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                                        Eigen::ComputeFullU | Eigen::ComputeFullV);
            Eigen::Matrix3d flip = Eigen::Matrix3d::Identity();
            flip(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
            rotations[v] = svd.matrixV() * flip * svd.matrixU().transpose();
        }
        Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(size, 3);
        for (const auto& [edge, weight] : weights) {
            const auto [a, b] = edge;
            const auto row = rows.find(a);
            if (row == rows.end())
                continue;
            Vec3d part = 0.5 * weight * ((rotations[a] + rotations[b]) * (rest[a] - rest[b]));
            if (!rows.contains(b))
                part += weight * now[b];
            sums.row(row->second) += part.transpose();
        }
        const Eigen::MatrixXd solved = solver.solve(sums);
        for (const auto& [v, row] : rows)
            now[v] = solved.row(row).transpose();
    }
    for (std::size_t v = 0; v < now.size(); ++v)
        pose[v] = now[v].cast<float>();
}

} // namespace quadrille::test
