// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/walkgraph.h"

#include <string>
#include <vector>

namespace quadrille {

/// The frames that walks come to.
class ReachableSet
{
public:
    /// \param isStart  the sources themselves count; otherwise only where they are come to again.
    ReachableSet(const WalkGraph& graph, const std::vector<NodeIndex>& sources, bool isStart);

    bool contains(NodeIndex node) const { return m_isReached[static_cast<std::size_t>(node)]; }
    /// The frame that can be reached and lies nearest, in its sequence where there is one.
    NodeIndex nearest(NodeIndex node, const FrameLayout& layout) const;

private:
    std::vector<bool> m_isReached;
};

/// The time nearest to the wanted one after which some walk arrives. \param isStart  no time will do as well.
/// \pre Some walk arrives.
std::int64_t nearestArrival(const WalkGraph& graph, const std::vector<NodeIndex>& sources, NodeIndex target,
                            double wanted, bool isStart);

/// A number for messages: at most three decimals, none that say nothing.
std::string shortNumber(double value);

} // namespace quadrille
