// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/selfintersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace quadrille {

namespace {

constexpr std::uint32_t leafSize = 4;

bool haveCommonVertex(const Triangle& a, const Triangle& b)
{
    return std::ranges::any_of(a, [&](VertexIndex v) { return v == b[0] || v == b[1] || v == b[2]; });
}

} // namespace

struct SelfIntersections::Box
{
    Eigen::Array4f low;
    Eigen::Array4f high;

    bool meets(const Box& other) const { return (low <= other.high).all() && (other.low <= high).all(); }
    void add(const Box& other)
    {
        low = low.min(other.low);
        high = high.max(other.high);
    }
};

SelfIntersections::SelfIntersections(std::shared_ptr<const Topology> topology, Positions pose)
    : m_topology(std::move(topology)), m_order(m_topology->triangles().size())
{
    std::iota(m_order.begin(), m_order.end(), 0);
    std::vector<Vec3f> middles;
    for (const auto& [a, b, c] : m_topology->triangles())
        middles.emplace_back((pose[a.value] + pose[b.value] + pose[c.value]) / 3);
    build(middles, 0, static_cast<std::uint32_t>(m_order.size()));
}

void SelfIntersections::build(std::vector<Vec3f>& middles, std::uint32_t first, std::uint32_t count)
{
    const std::size_t node = m_nodes.size();
    m_nodes.push_back({first, count, 0});
    if (count <= leafSize)
        return;
    const auto begin = m_order.begin() + first;
    Eigen::AlignedBox3f box;
    for (auto t = begin; t != begin + count; ++t)
        box.extend(middles[*t]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const float ofA = middles[a][axis];
        const float ofB = middles[b][axis];
        return ofA != ofB ? ofA < ofB : a < b;
    });
    build(middles, first, half);
    m_nodes[node].right = static_cast<std::uint32_t>(m_nodes.size());
    build(middles, first + half, count - half);
}

class SelfIntersections::Search
{
public:
    Search(const SelfIntersections& tree, Positions pose);
    std::vector<Pair> pairs();

private:
    void compare(std::uint32_t a, std::uint32_t b);
    void compareLeaves(const Node& a, const Node& b);
    void compareTriangles(std::uint32_t i, std::uint32_t j);

    const SelfIntersections& m_tree;
    Positions m_pose;
    std::vector<Box> m_triangleBoxes; ///< in the tree's order
    std::vector<Box> m_boxes;         ///< of the nodes
    std::vector<std::array<std::uint32_t, 2>> m_stack;
    std::vector<Pair> m_pairs;
};

SelfIntersections::Search::Search(const SelfIntersections& tree, Positions pose)
    : m_tree(tree), m_pose(pose), m_triangleBoxes(tree.m_order.size()), m_boxes(tree.m_nodes.size())
{
    const auto lane = [&](VertexIndex v) {
        const Vec3f& p = pose[v.value];
        return Eigen::Array4f(p.x(), p.y(), p.z(), 0);
    };
    for (std::size_t i = 0; i < m_triangleBoxes.size(); ++i) {
        const auto& [a, b, c] = tree.m_topology->triangles()[tree.m_order[i]];
        m_triangleBoxes[i] = {lane(a).min(lane(b)).min(lane(c)), lane(a).max(lane(b)).max(lane(c))};
    }
    for (std::size_t n = m_boxes.size(); n-- > 0;) {
        const Node& node = tree.m_nodes[n];
        if (node.right != 0) {
            m_boxes[n] = m_boxes[n + 1];
            m_boxes[n].add(m_boxes[node.right]);
            continue;
        }
        m_boxes[n] = m_triangleBoxes[node.first];
        for (std::uint32_t i = 1; i < node.count; ++i)
            m_boxes[n].add(m_triangleBoxes[node.first + i]);
    }
}

std::vector<SelfIntersections::Pair> SelfIntersections::Search::pairs()
{
    m_stack.push_back({0, 0});
    while (!m_stack.empty()) {
        const auto [a, b] = m_stack.back();
        m_stack.pop_back();
        compare(a, b);
    }
    std::ranges::sort(m_pairs);
    return std::move(m_pairs);
}

void SelfIntersections::Search::compare(std::uint32_t a, std::uint32_t b)
{
    const Node& nodeA = m_tree.m_nodes[a];
    const Node& nodeB = m_tree.m_nodes[b];
    if (a == b) {
        if (nodeA.right == 0) {
            compareLeaves(nodeA, nodeA);
            return;
        }
        m_stack.push_back({a + 1, a + 1});
        m_stack.push_back({nodeA.right, nodeA.right});
        m_stack.push_back({a + 1, nodeA.right});
        return;
    }
    if (!m_boxes[a].meets(m_boxes[b]))
        return;
    if (nodeA.right == 0 && nodeB.right == 0) {
        compareLeaves(nodeA, nodeB);
    } else if (nodeB.right == 0 || (nodeA.right != 0 && nodeA.count >= nodeB.count)) {
        m_stack.push_back({a + 1, b});
        m_stack.push_back({nodeA.right, b});
    } else {
        m_stack.push_back({a, b + 1});
        m_stack.push_back({a, nodeB.right});
    }
}

void SelfIntersections::Search::compareLeaves(const Node& a, const Node& b)
{
    for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
        for (std::uint32_t j = &a == &b ? i + 1 : b.first; j < b.first + b.count; ++j) {
            if (m_triangleBoxes[i].meets(m_triangleBoxes[j]))
                compareTriangles(m_tree.m_order[i], m_tree.m_order[j]);
        }
    }
}

void SelfIntersections::Search::compareTriangles(std::uint32_t i, std::uint32_t j)
{
    const Triangle& a = m_tree.m_topology->triangles()[i];
    const Triangle& b = m_tree.m_topology->triangles()[j];
    if (haveCommonVertex(a, b))
        return;
    const auto cornersOf = [this](const Triangle& triangle) {
        return std::array{m_pose[triangle[0].value], m_pose[triangle[1].value], m_pose[triangle[2].value]};
    };
    if (trianglesCross(cornersOf(a), cornersOf(b)))
        m_pairs.push_back({TriangleIndex(std::min(i, j)), TriangleIndex(std::max(i, j))});
}

std::vector<SelfIntersections::Pair> SelfIntersections::find(Positions pose) const
{
    return m_nodes.front().count == 0 ? std::vector<Pair>() : Search(*this, pose).pairs();
}

} // namespace quadrille
