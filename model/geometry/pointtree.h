// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <vector>

namespace quadrille {

/// Finds the nearest of some points: a balanced k-d tree.
class PointTree
{
public:
    /// \param points  at least one; copied.
    explicit PointTree(Positions points);

    /// Index of the nearest point; of those as near any. Cost: O(log points) where they lie apart.
    std::uint32_t nearest(const Vec3f& to) const;

private:
    void build(std::size_t first, std::size_t count);
    struct Best
    {
        float squared;
        std::size_t place;
    };
    void search(std::size_t first, std::size_t count, const Vec3f& to, Best& best) const;

    struct Node
    {
        Vec3f point;
        std::uint32_t index;
        int axis; ///< that divides the points before from those behind
    };
    std::vector<Node> m_nodes; ///< the middle one of each run divides it
};

} // namespace quadrille
