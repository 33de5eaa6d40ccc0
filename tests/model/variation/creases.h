// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace quadrille::test {

/// Tells how sharply a surface bends at its edges.
class EdgeNormals
{
public:
    explicit EdgeNormals(const Topology& topology) : m_topology(topology)
    {
        for (std::size_t t = 0; t < topology.triangles().size(); ++t) {
            for (std::size_t c = 0; c < 3; ++c)
                m_triangles[std::minmax(topology.triangles()[t][c], topology.triangles()[t][(c + 1) % 3])]
                    .push_back(t);
        }
    }

    /// Between the normals of the two triangles at an edge, radians; 0 where there are not two.
    double creaseAt(Positions pose, VertexIndex a, VertexIndex b) const
    {
        const std::vector<std::size_t>& triangles = m_triangles.at(std::minmax(a, b));
        if (triangles.size() != 2)
            return 0;
        const auto normalOf = [&](std::size_t t) -> Vec3d {
            const auto corner = [&](std::size_t c) -> Vec3d {
                return pose[m_topology.triangles()[t][c].value].cast<double>();
            };
            return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        };
        const Vec3d first = normalOf(triangles[0]);
        const Vec3d second = normalOf(triangles[1]);
        return std::atan2(first.cross(second).norm(), first.dot(second));
    }

private:
    const Topology& m_topology;
    std::map<std::pair<VertexIndex, VertexIndex>, std::vector<std::size_t>> m_triangles;
};

} // namespace quadrille::test
