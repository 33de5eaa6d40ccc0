// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/components.h"
#include "model/synthesis/walks/constraints.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// The frames among some spans that lead to each other: those of the graph's largest strongly connected
/// component; ascending.
std::vector<NodeIndex> connectedFrames(const Digraph& graph, std::span<const WalkSpan> spans);

/// Keys as in SMCAS §4.3.2 (Table 2), drawn at random: frames of a pool, each at most once, to be shown at
/// new times in a new order. The first is wanted at once, the last after `duration`; the times between are a
/// quarter to five quarters of one length before normalisation, whole frames. The same for the same seed, on
/// every machine. \return `count` keys, or as many as the pool has.
std::vector<PoseKey> drawKeys(std::vector<NodeIndex> pool, int count, std::int64_t duration,
                              std::uint64_t seed);

} // namespace quadrille
