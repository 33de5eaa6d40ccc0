// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/digraph.h"

namespace quadrille {

/// What of a graph can be reached from where.
struct Connectivity
{
    /// The strongly connected components, every node in one: the largest first (of two alike the one with the
    /// earlier frame), frames ascending.
    std::vector<std::vector<NodeIndex>> components;
    /// Frames that no walk reaches from the largest component, ascending. Where no component has two frames,
    /// so that no walk ever comes back, all frames, here and in `deadEnds`.
    std::vector<NodeIndex> unreachable;
    /// Frames from which no walk leads to the largest component, ascending: past them there is no way back.
    std::vector<NodeIndex> deadEnds;
};

/// Cost: O(nodes + edges).
Connectivity connectivity(const Digraph& graph);

} // namespace quadrille
