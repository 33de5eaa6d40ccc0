// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/liveorigin.h"

#include "model/core/smoothstep.h"
#include "model/parametric/transitionplaces.h"

#include <algorithm>
#include <array>

namespace quadrille {

namespace {

using TakeShares = std::array<double, WeightSpace::mostTakes>;

/// How much of a space's pose each of its takes is.
TakeShares takeShares(const MotionSpace& space, const SpacePoint& place)
{
    const NodeWeights weights = space.weights.at(place);
    TakeShares shares{};
    for (std::size_t n = 0; n < static_cast<std::size_t>(weights.count); ++n) {
        for (const BlendShare& share :
             space.weights.nodes()[static_cast<std::size_t>(weights.nodes[n])].shares)
            shares[share.take] += weights.weights[n] * share.share;
    }
    return shares;
}

/// The frame of a take that a track shows.
LiveProvenance shownOf(const MotionSpace& space, const LiveTrack& track, std::size_t take, double share)
{
    return {track.space, take, nearestFrame(track.phase, space.frameCount(), space.isCyclic), share};
}

/// What a space looks like by itself. Where more than two takes have a share, what the third has does not
/// count: so the second comes in at no weight.
LiveLook lookWithin(const MotionSpace& space, const LiveTrack& track, double ofPose)
{
    const TakeShares shares = takeShares(space, track.place);
    std::array<LiveProvenance, 3> greatest;
    for (std::size_t take = 0; take < space.takes.size(); ++take) {
        LiveProvenance shown = shownOf(space, track, take, ofPose * shares[take]);
        for (LiveProvenance& greater : greatest) {
            if (shown.share > greater.share)
                std::swap(shown, greater);
        }
    }
    const double first = greatest[0].share - greatest[2].share;
    const double second = greatest[1].share - greatest[2].share;
    if (second <= 0)
        return {greatest[0], greatest[0], 0};
    return {greatest[0], greatest[1], second / (first + second)};
}

/// So much of a fade one space is seen alone at its beginning, and the other at its end.
constexpr double aloneShare = 1.0 / 6;

} // namespace

LiveProvenance provenanceOf(const LiveGraph& graph, const LiveState& state)
{
    const LiveTrack& track = state.takenOver() < 0.5 ? state.left : state.track;
    const MotionSpace& space = *graph.spaces[track.space];
    const TakeShares shares = takeShares(space, track.place);
    const auto greatest = std::ranges::max_element(shares);
    return shownOf(space, track, static_cast<std::size_t>(greatest - shares.begin()), *greatest);
}

LiveLook lookOf(const LiveGraph& graph, const LiveState& state)
{
    const double takenOver = state.fade < 1 ? state.takenOver() : 1;
    LiveLook entered = lookWithin(*graph.spaces[state.track.space], state.track, takenOver);
    if (state.fade >= 1)
        return entered;
    LiveLook left = lookWithin(*graph.spaces[state.left.space], state.left, 1 - takenOver);
    if (state.fade < aloneShare) {
        left.weight *= 1 - state.fade / aloneShare;
        return left;
    }
    if (state.fade > 1 - aloneShare) {
        entered.weight *= 1 - (1 - state.fade) / aloneShare;
        return entered;
    }
    const double weight = smoothStep((state.fade - aloneShare) / (1 - 2 * aloneShare));
    return weight < 0.5 ? LiveLook{left.first, entered.first, weight}
                        : LiveLook{entered.first, left.first, 1 - weight};
}

} // namespace quadrille
