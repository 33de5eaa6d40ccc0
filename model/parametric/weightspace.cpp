// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/weightspace.h"

#include "model/core/badargument.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

Vec3d vectorOf(const SpacePoint& place)
{
    return {place[0], place[1], place[2]};
}

/// All ways to choose some of the first numbers, ascending.
std::vector<std::array<int, 4>> choices(int from, int count)
{
    std::vector<std::array<int, 4>> all;
    std::array<int, 4> chosen{};
    for (int i = 0; i < count; ++i)
        chosen[static_cast<std::size_t>(i)] = i;
    while (true) {
        all.push_back(chosen);
        int i = count - 1;
        while (i >= 0 && chosen[static_cast<std::size_t>(i)] == from - count + i)
            --i;
        if (i < 0)
            return all;
        ++chosen[static_cast<std::size_t>(i)];
        for (int j = i + 1; j < count; ++j)
            chosen[static_cast<std::size_t>(j)] = chosen[static_cast<std::size_t>(j - 1)] + 1;
    }
}

/// The rows of the takes' places, each coordinate by its range, the first in a corner.
Eigen::MatrixXd scaledPlaces(std::span<const SpacePoint> takes, int dimension)
{
    Eigen::MatrixXd places(static_cast<Eigen::Index>(takes.size()), dimension);
    for (int d = 0; d < dimension; ++d) {
        for (std::size_t t = 0; t < takes.size(); ++t)
            places(static_cast<Eigen::Index>(t), d) = takes[t][static_cast<std::size_t>(d)];
        const double least = places.col(d).minCoeff();
        const double range = places.col(d).maxCoeff() - least;
        places.col(d) = (places.col(d).array() - least) / (range > 0 ? range : 1);
    }
    return places;
}

constexpr double smallest = 1e-6; ///< of what counts as apart, in ranges

void requirePlaces(const Eigen::MatrixXd& places)
{
    const Eigen::Index dimension = places.cols();
    if (dimension < 1 || dimension > 3)
        refuse("A motion space has from one to three parameters",
               "Give it a parameter for what the takes differ in.");
    if (places.rows() <= dimension)
        refuse("A motion space of " + std::to_string(dimension) + " parameters needs at least " +
                   std::to_string(dimension + 1) + " takes",
               "Add takes, or leave a parameter out.");
    for (Eigen::Index a = 0; a < places.rows(); ++a) {
        for (Eigen::Index b = a + 1; b < places.rows(); ++b) {
            if ((places.row(a) - places.row(b)).norm() < smallest)
                refuse("Takes " + std::to_string(a + 1) + " and " + std::to_string(b + 1) +
                           " of a motion space are at one place",
                       "Leave one of them out, or place it elsewhere.");
        }
    }
    const Eigen::MatrixXd centred = places.rowwise() - places.colwise().mean();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> rank(centred);
    rank.setThreshold(1e-4);
    if (rank.rank() < dimension)
        refuse("The takes of a motion space lie on one line or in one plane of its parameters",
               "Leave out a parameter that follows from the others, or place the takes by hand.");
}

/// A Delaunay triangulation by lifting: simplices whose hyperplane through (p, |p|²) lies below all other
/// points. Places are lifted a little more by their number, so that of several that lie on one sphere always
/// the same simplices come out, and none overlap.
std::vector<std::array<int, 4>> delaunay(const Eigen::MatrixXd& places)
{
    const Eigen::Index dimension = places.cols();
    Eigen::VectorXd lifted(places.rows());
    for (Eigen::Index p = 0; p < places.rows(); ++p) {
        const auto number = static_cast<double>(p + 1);
        lifted[p] = places.row(p).squaredNorm() + 1e-7 * number * number;
    }
    std::vector<std::array<int, 4>> simplices;
    for (const std::array<int, 4>& chosen :
         choices(static_cast<int>(places.rows()), static_cast<int>(dimension) + 1)) {
        Eigen::MatrixXd corners(dimension + 1, dimension + 1);
        Eigen::VectorXd heights(dimension + 1);
        for (Eigen::Index c = 0; c <= dimension; ++c) {
            corners(c, 0) = 1;
            corners.block(c, 1, 1, dimension) = places.row(chosen[static_cast<std::size_t>(c)]);
            heights[c] = lifted[chosen[static_cast<std::size_t>(c)]];
        }
        const Eigen::FullPivLU<Eigen::MatrixXd> solver(corners);
        if (std::abs(solver.determinant()) < 1e-5)
            continue;
        const Eigen::VectorXd plane = solver.solve(heights);
        bool isBelow = true;
        for (Eigen::Index p = 0; p < places.rows(); ++p)
            isBelow = isBelow && lifted[p] - plane[0] - places.row(p).dot(plane.tail(dimension)) > -1e-12;
        if (isBelow)
            simplices.push_back(chosen);
    }
    return simplices;
}

} // namespace

WeightSpace::WeightSpace(std::span<const SpacePoint> takes, int dimension)
    : m_dimension(dimension), m_takeCount(takes.size())
{
    for (std::size_t t = 0; t < takes.size(); ++t)
        m_nodes.push_back({.place = takes[t], .shares = {{t, 1}}});
    if (takes.size() == 1 && dimension == 0) {
        add({});
        return;
    }
    if (takes.size() > mostTakes)
        refuse("A motion space has at most " + std::to_string(mostTakes) + " takes", "Leave some out.");
    const Eigen::MatrixXd places = scaledPlaces(takes, dimension);
    requirePlaces(places);
    for (const std::array<int, 4>& nodes : delaunay(places))
        add(nodes);
}

WeightSpace::WeightSpace(int dimension, std::size_t takes, std::vector<Node> nodes,
                         std::span<const std::array<int, 4>> simplices)
    : m_dimension(dimension), m_takeCount(takes), m_nodes(std::move(nodes))
{
    for (const std::array<int, 4>& simplex : simplices)
        add(simplex);
}

void WeightSpace::add(const std::array<int, 4>& nodes)
{
    Simplex simplex{.nodes = nodes};
    Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();
    const auto placeOfCorner = [&](int corner) {
        return vectorOf(m_nodes[static_cast<std::size_t>(nodes[static_cast<std::size_t>(corner)])].place);
    };
    for (int c = 1; c <= m_dimension; ++c)
        edges.col(c - 1) = placeOfCorner(c) - placeOfCorner(0);
    simplex.inverse = edges.inverse();
    m_simplices.push_back(simplex);
}

std::array<SpacePoint, 2> WeightSpace::range() const
{
    // References lie between takes.
    std::array<SpacePoint, 2> range{m_nodes.front().place, m_nodes.front().place};
    for (std::size_t t = 1; t < m_takeCount; ++t) {
        for (std::size_t d = 0; d < range[0].size(); ++d) {
            range[0][d] = std::min(range[0][d], m_nodes[t].place[d]);
            range[1][d] = std::max(range[1][d], m_nodes[t].place[d]);
        }
    }
    return range;
}

std::vector<std::array<int, 2>> WeightSpace::edges() const
{
    std::vector<std::array<int, 2>> edges;
    for (const Simplex& simplex : m_simplices) {
        for (int a = 0; a <= m_dimension; ++a) {
            for (int b = a + 1; b <= m_dimension; ++b) {
                const int from = simplex.nodes[static_cast<std::size_t>(a)];
                const int to = simplex.nodes[static_cast<std::size_t>(b)];
                edges.push_back({std::min(from, to), std::max(from, to)});
            }
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

int WeightSpace::bisect(std::array<int, 2> edge)
{
    const auto middle = static_cast<int>(m_nodes.size());
    Node node;
    std::vector<double> shares(m_takeCount);
    for (const int end : edge) {
        const Node& from = m_nodes[static_cast<std::size_t>(end)];
        for (std::size_t d = 0; d < node.place.size(); ++d)
            node.place[d] += from.place[d] / 2;
        for (const BlendShare& share : from.shares)
            shares[share.take] += share.share / 2;
    }
    for (std::size_t t = 0; t < m_takeCount; ++t) {
        if (shares[t] > 0)
            node.shares.push_back({t, shares[t]});
    }
    m_nodes.push_back(std::move(node));

    std::vector<Simplex> divided;
    std::swap(divided, m_simplices);
    for (const Simplex& simplex : divided) {
        const auto end = simplex.nodes.begin() + m_dimension + 1;
        const auto from = std::find(simplex.nodes.begin(), end, edge[0]);
        const auto to = std::find(simplex.nodes.begin(), end, edge[1]);
        if (from == end || to == end) {
            m_simplices.push_back(simplex);
            continue;
        }
        for (const auto corner : {from, to}) {
            std::array<int, 4> half = simplex.nodes;
            half[static_cast<std::size_t>(corner - simplex.nodes.begin())] = middle;
            add(half);
        }
    }
    return middle;
}

NodeWeights WeightSpace::at(const SpacePoint& place) const
{
    constexpr double slack = 1e-9; // of rounding: places on an edge are in both simplices
    for (const Simplex& simplex : m_simplices) {
        const Vec3d others =
            simplex.inverse *
            (vectorOf(place) - vectorOf(m_nodes[static_cast<std::size_t>(simplex.nodes[0])].place));
        NodeWeights weights{.nodes = simplex.nodes, .weights = {1}, .count = m_dimension + 1};
        bool isWithin = true;
        for (int c = 1; c <= m_dimension; ++c) {
            const double weight = others[c - 1];
            weights.weights[static_cast<std::size_t>(c)] = std::max(weight, 0.0);
            weights.weights[0] -= weight;
            isWithin = isWithin && weight >= -slack;
        }
        if (!isWithin || weights.weights[0] < -slack)
            continue;
        double sum = 0;
        for (double& weight : weights.weights)
            sum += weight = std::max(weight, 0.0);
        for (double& weight : weights.weights)
            weight /= sum;
        return weights;
    }
    return nearest(place);
}

NodeWeights WeightSpace::nearest(const SpacePoint& place) const
{
    // The nearest place lies on a corner, an edge, a face or in a simplex: it is the foot of the
    // perpendicular on one of them.
    NodeWeights best;
    double least = std::numeric_limits<double>::infinity();
    for (const Simplex& simplex : m_simplices) {
        for (unsigned subset = 1; subset < 1U << static_cast<unsigned>(m_dimension + 1); ++subset) {
            NodeWeights weights;
            for (unsigned c = 0; c <= static_cast<unsigned>(m_dimension); ++c) {
                if ((subset >> c & 1U) != 0)
                    weights.nodes[static_cast<std::size_t>(weights.count++)] = simplex.nodes[c];
            }
            const auto placeOfCorner = [&](int corner) {
                const int node = weights.nodes[static_cast<std::size_t>(corner)];
                return vectorOf(m_nodes[static_cast<std::size_t>(node)].place);
            };
            const Vec3d first = placeOfCorner(0);
            Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
            for (int c = 1; c < weights.count; ++c)
                axes.col(c - 1) = placeOfCorner(c) - first;
            // Columns that are not used stay 0, and so do their shares.
            Eigen::Matrix3d squares = axes.transpose() * axes;
            for (int unused = std::max(weights.count - 1, 0); unused < 3; ++unused)
                squares(unused, unused) = 1;
            const Vec3d shares = squares.inverse() * (axes.transpose() * (vectorOf(place) - first));
            Vec3d foot = first;
            bool isWithin = true;
            weights.weights[0] = 1;
            for (int c = 1; c < weights.count; ++c) {
                weights.weights[static_cast<std::size_t>(c)] = shares[c - 1];
                weights.weights[0] -= shares[c - 1];
                foot += shares[c - 1] * axes.col(c - 1);
                isWithin = isWithin && shares[c - 1] >= 0;
            }
            const double distance = (foot - vectorOf(place)).squaredNorm();
            if (isWithin && weights.weights[0] >= 0 && distance < least) {
                least = distance;
                best = weights;
            }
        }
    }
    return best;
}

SpacePoint WeightSpace::placeOf(const NodeWeights& weights) const
{
    SpacePoint place{};
    for (int n = 0; n < weights.count; ++n) {
        const Node& node = m_nodes[static_cast<std::size_t>(weights.nodes[static_cast<std::size_t>(n)])];
        for (std::size_t d = 0; d < place.size(); ++d)
            place[d] += weights.weights[static_cast<std::size_t>(n)] * node.place[d];
    }
    return place;
}

std::vector<double> WeightSpace::shares(const NodeWeights& weights) const
{
    std::vector<double> shares(m_takeCount);
    for (int n = 0; n < weights.count; ++n) {
        const Node& node = m_nodes[static_cast<std::size_t>(weights.nodes[static_cast<std::size_t>(n)])];
        for (const BlendShare& share : node.shares)
            shares[share.take] += weights.weights[static_cast<std::size_t>(n)] * share.share;
    }
    return shares;
}

} // namespace quadrille
