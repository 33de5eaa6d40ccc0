// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/pointtree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace quadrille {

PointTree::PointTree(Positions points)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        m_nodes.push_back({points[i], static_cast<std::uint32_t>(i), 0});
    build(0, m_nodes.size());
}

void PointTree::build(std::size_t first, std::size_t count)
{
    if (count == 0)
        return;
    const auto begin = m_nodes.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    Eigen::AlignedBox3f box;
    for (auto node = begin; node != end; ++node)
        box.extend(node->point);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t half = count / 2;
    const auto middle = begin + static_cast<std::ptrdiff_t>(half);
    std::nth_element(begin, middle, end,
                     [axis](const Node& a, const Node& b) { return a.point[axis] < b.point[axis]; });
    middle->axis = static_cast<int>(axis);
    build(first, half);
    build(first + half + 1, count - half - 1);
}

void PointTree::search(std::size_t first, std::size_t count, const Vec3f& to, Best& best) const
{
    if (count == 0)
        return;
    const std::size_t half = count / 2;
    const Node& node = m_nodes[first + half];
    const float squared = (node.point - to).squaredNorm();
    if (squared < best.squared)
        best = {squared, first + half};
    const float beyond = to[node.axis] - node.point[node.axis];
    const std::size_t behind = first + half + 1;
    const std::size_t behindCount = count - half - 1;
    if (beyond < 0) {
        search(first, half, to, best);
        if (beyond * beyond < best.squared)
            search(behind, behindCount, to, best);
    } else {
        search(behind, behindCount, to, best);
        if (beyond * beyond < best.squared)
            search(first, half, to, best);
    }
}

std::uint32_t PointTree::nearest(const Vec3f& to) const
{
    Best best{std::numeric_limits<float>::infinity(), m_nodes.size() / 2};
    search(0, m_nodes.size(), to, best);
    return m_nodes[best.place].index;
}

} // namespace quadrille
