// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <vector>

namespace quadrille {

/// Deformation transfer (Sumner & Popović 2004) between meshes whose triangles correspond one by one, as it
/// is commonly written: a fourth vertex above each triangle, the normal equations factorised once, right-hand
/// sides from the deformation gradients of the source. The peer of benchmarks.
class PlainDeformationTransfer
{
public:
    PlainDeformationTransfer(const Topology& topology, Positions source, Positions target)
        : m_topology(topology), m_sourceInverses(inverses(source))
    {
        const auto vertices = static_cast<Eigen::Index>(topology.vertexCount());
        const auto count = static_cast<Eigen::Index>(topology.triangles().size());
        const std::vector<Eigen::Matrix3d> inverse = inverses(target);
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index t = 0; t < count; ++t) {
            const Triangle& triangle = topology.triangles()[static_cast<std::size_t>(t)];
            for (Eigen::Index row = 0; row < 3; ++row) {
                const Eigen::RowVector3d weights = inverse[static_cast<std::size_t>(t)].col(row).transpose();
                entries.emplace_back(3 * t + row, triangle[0].value, -weights.sum());
                entries.emplace_back(3 * t + row, triangle[1].value, weights[0]);
                entries.emplace_back(3 * t + row, triangle[2].value, weights[1]);
                entries.emplace_back(3 * t + row, vertices + t, weights[2]);
            }
        }
        // One vertex is held at the origin.
        entries.emplace_back(3 * count, 0, 1.0);
        m_gradients.resize(3 * count + 1, vertices + count);
        m_gradients.setFromTriplets(entries.begin(), entries.end());
        m_factor.compute(Eigen::SparseMatrix<double>(m_gradients.transpose() * m_gradients));
    }

    /// Positions of the target, then of the fourth vertices, for a pose of the source.
    Eigen::MatrixXd pose(Positions source) const
    {
        Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(m_gradients.rows(), 3);
        for (std::size_t t = 0; t < m_sourceInverses.size(); ++t)
            wanted.middleRows<3>(static_cast<Eigen::Index>(3 * t)) =
                (edgesOf(m_topology.triangles()[t], source) * m_sourceInverses[t]).transpose();
        return m_factor.solve(m_gradients.transpose() * wanted);
    }

private:
    static Eigen::Matrix3d edgesOf(const Triangle& triangle, Positions pose)
    {
        const Vec3d at = pose[triangle[0].value].cast<double>();
        Eigen::Matrix3d edges;
        edges.col(0) = pose[triangle[1].value].cast<double>() - at;
        edges.col(1) = pose[triangle[2].value].cast<double>() - at;
        const Vec3d normal = edges.col(0).cross(edges.col(1));
        edges.col(2) = normal / std::sqrt(normal.norm());
        return edges;
    }
    std::vector<Eigen::Matrix3d> inverses(Positions pose) const
    {
        std::vector<Eigen::Matrix3d> all;
        for (const Triangle& triangle : m_topology.triangles())
            all.emplace_back(edgesOf(triangle, pose).inverse());
        return all;
    }

    const Topology& m_topology;
    std::vector<Eigen::Matrix3d> m_sourceInverses;
    Eigen::SparseMatrix<double> m_gradients;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;
};

} // namespace quadrille
