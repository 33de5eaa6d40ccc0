// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/components.h"
#include "model/graph/transitioncosts.h"
#include "model/transition/framepair.h"

#include <optional>

namespace quadrille {

/// Frames of one sequence in a row that walks do not come to or do not come back from, and what would help.
struct GraphGap
{
    enum class Kind
    {
        Unreachable, ///< no walk leads there from the largest component
        DeadEnd,     ///< no walk leads from there to the largest component
    };
    Kind kind = Kind::DeadEnd;
    NodeIndex first = 0;
    NodeIndex last = 0; ///< included
    /// The transition of least weight that the graph lacks and that would close the gap; nothing where there
    /// is none.
    std::optional<FramePair> transition;
    double weight = 0; ///< of that transition
    /// The frames of least pose distance between those that are cut off and the others: a take that leads
    /// from the pose of the one to that of the other would close the gap. Nothing where there is a single
    /// frame.
    std::optional<FramePair> take;
    float distance = 0; ///< between the poses of the take's ends, in the unit of the distances

    NodeIndex frameCount() const { return last - first + 1; }
    bool operator==(const GraphGap&) const = default;
};

/// All gaps: dead ends after unreachable frames, each in the order of frames. Where no walk ever comes back,
/// a gap is closed by what leads to an earlier frame of the sequence or to another one.
/// \param connectivity  of the graph. \param distances  frames × frames.
/// Cost: O(frames · frames in gaps).
std::vector<GraphGap> findGaps(const Digraph& graph, const Connectivity& connectivity,
                               const TransitionCosts& costs, TableView<float> distances, double alpha);

} // namespace quadrille
