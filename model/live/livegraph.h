// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/onlinetransition.h"

#include <memory>
#include <vector>

namespace quadrille {

/// The motion spaces of a character and what leads from one to another: a 4D parametric motion graph (IA4D
/// section 3). A plain value, shared by whoever plays it.
struct LiveGraph
{
    double fps = 25; ///< of the project; frames of clips are as far apart
    std::vector<std::shared_ptr<const MotionSpace>> spaces;
    /// By source, then target; null where no transition leads from the one to the other.
    std::vector<std::vector<std::shared_ptr<const SimilarityTable>>> tables;

    const Topology& topology() const { return *spaces.front()->topology; }
    std::size_t vertexCount() const { return spaces.front()->vertexCount(); }
    UpAxis up() const { return spaces.front()->up; }
    bool leads(std::size_t source, std::size_t target) const { return tables[source][target] != nullptr; }
};

/// Compares all spaces with each other.
/// \throws Error BadArgument (no space, spaces of different topologies or axes, fps not positive), Cancelled.
LiveGraph makeLiveGraph(std::vector<std::shared_ptr<const MotionSpace>> spaces, double fps,
                        const SimilaritySettings& settings = {}, const Progress& progress = {});

} // namespace quadrille
