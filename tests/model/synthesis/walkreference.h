// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/walkgraph.h"

#include <functional>

namespace quadrille::test {

/// Calls back for every walk from a node that takes at most so many frames, itself included.
void everyWalk(const WalkGraph& graph, NodeIndex start, std::int32_t longest,
               const std::function<void(const WalkRoute& route, std::int32_t elapsed, double cost)>& found);

/// The least cost of keys by looking at every walk: legs of at most so many frames each.
double exhaustiveLeg(const WalkGraph& graph, const std::vector<NodeIndex>& sources, NodeIndex target,
                     double wanted, bool isFirst, double beta, std::int32_t longest);
double exhaustiveOverAllKeys(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                             const std::vector<PoseKey>& keys, double beta, std::int32_t longest);

} // namespace quadrille::test
