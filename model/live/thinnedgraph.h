// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/livegraph.h"

#include <cstddef>
#include <memory>

namespace quadrille {

/// The graph with no more than so many vertices, one after every few, as linear blends: where it goes over
/// the ground is nearly the same, and a transition costs less. Tables are shared.
std::shared_ptr<const LiveGraph> thinnedGraph(const LiveGraph& graph, std::size_t mostVertices);

} // namespace quadrille
