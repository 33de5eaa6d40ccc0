// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/blends.h"

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace quadrille {

/// A place in a space of one to three parameters; what is beyond its dimension is 0.
using SpacePoint = std::array<double, 3>;

/// Nodes of a space and their shares in a blend: they add up to 1, none is negative.
struct NodeWeights
{
    std::array<int, 4> nodes{};
    std::array<double, 4> weights{};
    int count = 0;

    bool operator==(const NodeWeights&) const = default;
};

/// Where takes lie against each other in a space of blend weights, cut into simplices: intervals, triangles
/// or tetrahedra. Nodes are the takes, then the references that bisection adds, each a blend of takes. A
/// place is a blend of the corners of its simplex; as nodes divide edges in the middle, the shares of takes
/// that follow stay the same however finely it is divided.
class WeightSpace
{
public:
    static constexpr std::size_t mostTakes = 8;

    struct Node
    {
        SpacePoint place{};
        std::vector<BlendShare> shares; ///< of takes, ascending
    };
    struct Simplex
    {
        std::array<int, 4> nodes{}; ///< the first dimension() + 1 count
        /// Takes a place, less that of the first node, to the weights of the others.
        Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
    };

    WeightSpace() = default;
    /// The Delaunay triangulation of the takes' places; of several that are as good, always the same one. One
    /// take alone is a space without a parameter.
    /// \param dimension  1 to 3; 0 for one take.
    /// \throws Error BadArgument (more than mostTakes, two takes at one
    /// place, fewer takes than the dimension asks for, takes on
    /// one line or in one plane). Cost: O(takes^(dimension + 2)).
    WeightSpace(std::span<const SpacePoint> takes, int dimension);
    /// One that was stored, the same in all bits. \param takes  how many of the nodes they are.
    /// \param simplices  the nodes of each. \pre All of it is of a space.
    WeightSpace(int dimension, std::size_t takes, std::vector<Node> nodes,
                std::span<const std::array<int, 4>> simplices);

    int dimension() const { return m_dimension; }
    std::size_t takeCount() const { return m_takeCount; }
    const std::vector<Node>& nodes() const { return m_nodes; }
    const std::vector<Simplex>& simplices() const { return m_simplices; }

    /// The least and the greatest place of the takes on each axis.
    std::array<SpacePoint, 2> range() const;
    /// The two ends of each edge, the smaller first, ascending.
    std::vector<std::array<int, 2>> edges() const;
    /// Divides an edge, and all simplices that have it, in the middle. \return the new node.
    /// \pre It is an edge.
    int bisect(std::array<int, 2> edge);

    /// The nodes that blend to a place; outside of all simplices, to the nearest place within.
    NodeWeights at(const SpacePoint& place) const;
    /// The place that nodes blend to.
    SpacePoint placeOf(const NodeWeights& weights) const;
    /// Shares of the takes, by take.
    std::vector<double> shares(const NodeWeights& weights) const;

private:
    void add(const std::array<int, 4>& nodes);
    NodeWeights nearest(const SpacePoint& place) const;

    int m_dimension = 0;
    std::size_t m_takeCount = 0;
    std::vector<Node> m_nodes;
    std::vector<Simplex> m_simplices;
};

} // namespace quadrille
