// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/livegraph.h"
#include "model/live/livestate.h"

namespace quadrille {

/// A captured frame that is a part of a pose.
struct LiveProvenance
{
    std::size_t space = 0;
    std::size_t take = 0;
    std::size_t frame = 0; ///< of the space
    double share = 0;

    bool operator==(const LiveProvenance&) const = default;
};

/// Two captured frames whose looks a pose fades between. Nothing jumps while frames follow each other: within
/// a space a take comes in, as the second, at no weight, and the two change places at 0.5; while one space
/// takes over from another, first one take of the old space alone is left, then it fades into one of the new
/// space, whose second comes in last.
struct LiveLook
{
    LiveProvenance first;
    LiveProvenance second; ///< the same as the first where that is seen alone
    double weight = 0;     ///< of the second, 0 … 0.5
};

/// The captured frame that a pose is most like: of the take with the greatest share in the space that is
/// seen more. \return with its share in that space.
LiveProvenance provenanceOf(const LiveGraph& graph, const LiveState& state);

/// What a pose looks like, with shares of all of the pose. Allocates nothing.
LiveLook lookOf(const LiveGraph& graph, const LiveState& state);

} // namespace quadrille
