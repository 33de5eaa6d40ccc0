// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/digraph.h"
#include "model/graph/transitioncosts.h"
#include "model/project/steps/costparts.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/transition/transitiontable.h"

#include <functional>
#include <vector>

namespace quadrille {

/// What an edge of a graph costs, and what that is made of; original edges cost nothing and last a frame.
struct EdgeCost
{
    float cost = 0;
    std::uint16_t length = 1; ///< frames
    CostParts parts;
};

/// Cost and length of all edges of a graph, without their parts (see splitCosts).
std::vector<EdgeCost> costsOfEdges(const Digraph& graph, const TransitionCosts& costs);

/// What the paths of many transitions are sought in; refers to what others hold.
struct EdgePaths
{
    /// What is known of an edge beside its path.
    struct Known
    {
        KnownTransition transition;
        float drift = 0; ///< of footDrifts; 0 where costs do not know it
    };

    const FrameLayout& layout;
    TableView<float> distances; ///< of poses
    const StepDifferences& differences;
    StepWeights weights;
    float greatestStep = 0; ///< what transitions were sought by is at most so much
    TransitionSettings settings;
    const Stances& stances;
    /// By graph and position of the edge. Asked from several threads.
    std::function<Known(std::size_t graph, std::size_t edge)> known;
};

/// Sets what the costs of the transitions of graphs are made of. What two frames differ in is computed for
/// some source frames at a time, as paths of neighbours ask for the same.
/// \param costs  of the edges of each graph: with cost and length. \throws Error Cancelled.
/// Cost: O(frames² · feet + edges · l_max²); memory O(frames) a thread.
void splitCosts(const std::vector<const Digraph*>& graphs, const EdgePaths& paths,
                std::vector<std::vector<EdgeCost>>& costs, const Progress& progress = {});

} // namespace quadrille
