// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/bakedstate.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

void bakeTrack(auto& bytes, auto& track)
{
    bakeSize(bytes, track.space);
    bytes(track.phase);
    bakePoint(bytes, track.place);
    bakeMotion(bytes, track.root);
}

void bakeChoice(auto& bytes, auto& choice)
{
    bakeAll(bytes, choice.sourceFrames, choice.targetFrames);
    for (auto* frame : {&choice.leavingFrame, &choice.arrivalFrame, &choice.endFrame})
        bakeSize(bytes, *frame);
    bakePoint(bytes, choice.leavingPlace);
    bakePoint(bytes, choice.arrivalPlace);
    bakeAll(bytes, choice.dissimilarity, choice.latencyCost);
}

void bakeState(auto& bytes, auto& state)
{
    bytes(state.tick);
    bakeTrack(bytes, state.track);
    bakeTrack(bytes, state.left);
    bakeAll(bytes, state.fade, state.way);
    bakePoint(bytes, state.pace);
    bakeSize(bytes, state.target);
    bakeChoice(bytes, state.choice);
    bakePoint(bytes, state.wayStart);
    bakePoint(bytes, state.wayGoal);
    bakeAll(bytes, state.wayFrames, state.wayEnd);
    bakeSize(bytes, state.wanted);
    bytes(state.wished);
    bakeSize(bytes, state.home);
    bakePoint(bytes, state.homeParameters);
    bytes(state.decisions);
}

/// Whether a place is one of a space, or not far beside it.
bool isPlace(const SpacePoint& point, const MotionSpace& space)
{
    const auto [least, greatest] = space.weights.range();
    for (std::size_t d = 0; d < point.size(); ++d) {
        const double range = greatest[d] - least[d];
        if (!(point[d] >= least[d] - range && point[d] <= greatest[d] + range))
            return false;
    }
    return true;
}

bool fits(const LiveTrack& track, const LiveGraph& graph)
{
    if (track.space >= graph.spaces.size())
        return false;
    const MotionSpace& space = *graph.spaces[track.space];
    return track.phase >= 0 && track.phase < static_cast<double>(space.frameCount()) &&
           isPlace(track.place, space) && std::isfinite(track.root.turn) && track.root.shift.allFinite();
}

/// What a way needs: places of the space that is played, and of the one that it leads to.
bool fitsItsWay(const LiveState& state, const LiveGraph& graph)
{
    const MotionSpace& played = *graph.spaces[state.track.space];
    const MotionSpace& target = *graph.spaces[state.target];
    const bool goes = std::isfinite(state.wayFrames) && std::isfinite(state.wayEnd);
    switch (state.way) {
    case LiveState::Way::Free:
        return goes;
    case LiveState::Way::Leaving:
        return goes && isPlace(state.wayStart, played) && isPlace(state.choice.leavingPlace, played) &&
               isPlace(state.choice.arrivalPlace, target) && isPlace(state.wayGoal, target) &&
               state.choice.arrivalFrame < target.frameCount();
    case LiveState::Way::Arriving:
        return goes && isPlace(state.wayStart, played) && isPlace(state.wayGoal, played);
    }
    return false;
}

bool fits(const LiveState& state, const LiveGraph& graph)
{
    const std::size_t spaces = graph.spaces.size();
    const auto isFinite = [](double value) { return std::isfinite(value); };
    return fits(state.track, graph) && fits(state.left, graph) && state.fade >= 0 && state.fade <= 1 &&
           state.target < spaces && state.wanted < spaces && state.home < spaces &&
           fitsItsWay(state, graph) && std::ranges::all_of(state.homeParameters, isFinite);
}

} // namespace

LiveStateBytes::LiveStateBytes(const LivePlayer& player) : m_graph(player.sharedGraph())
{
    bakeState(m_writer, player.state());
    m_size = m_writer.bytes().size();
}

void LiveStateBytes::write(const LiveState& state, void* out)
{
    m_writer.clear();
    bakeState(m_writer, state);
    std::memcpy(out, m_writer.bytes().data(), m_size);
}

std::optional<LiveState> LiveStateBytes::read(const void* bytes) const
{
    const std::filesystem::path noFile;
    BakedReader reader({static_cast<const std::byte*>(bytes), m_size}, noFile, 0);
    LiveState state;
    bakeState(reader, state);
    if (!fits(state, *m_graph))
        return std::nullopt;
    return state;
}

} // namespace quadrille
