// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <nanoflann.hpp>
#include <vector>

namespace quadrille {

/// Finds the nearest of some points, by the k-d tree of nanoflann.
class PointTree
{
public:
    /// \param points  at least one; copied.
    explicit PointTree(Positions points) : m_points{{points.begin(), points.end()}} {}

    /// Index of the nearest point; of those as near any. Cost: O(log points) where they lie apart.
    std::uint32_t nearest(const Vec3f& to) const
    {
        std::uint32_t index = 0; // stays so where `to` is not a number
        float squared = 0;
        m_tree.knnSearch(to.data(), 1, &index, &squared);
        return index;
    }

private:
    struct Points
    {
        std::vector<Vec3f> values;

        std::size_t kdtree_get_point_count() const { return values.size(); }
        float kdtree_get_pt(std::uint32_t index, std::size_t axis) const
        {
            return values[index][static_cast<Eigen::Index>(axis)];
        }
        template <typename Box>
        bool kdtree_get_bbox(Box& /*box*/) const
        {
            return false; // it is to find out
        }
    };
    using Distance = nanoflann::L2_Simple_Adaptor<float, Points>;

    Points m_points;
    nanoflann::KDTreeSingleIndexAdaptor<Distance, Points, 3, std::uint32_t> m_tree{3, m_points};
};

} // namespace quadrille
