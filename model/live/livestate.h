// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/smoothstep.h"
#include "model/live/livesettings.h"

#include <array>
#include <cstdint>

namespace quadrille {

/// A space while it is played.
struct LiveTrack
{
    std::size_t space = 0;
    double phase = 0; ///< in frames, as blendedPose
    SpacePoint place{};
    GroundMotion root; ///< takes the pose of the phase to where it is over the ground

    bool operator==(const LiveTrack&) const = default;
};

/// All that a player knows at a tick: poses follow from it. A small plain value, so that each tick of a
/// performance can be kept and gone back to.
struct LiveState
{
    /// What a place does.
    enum class Way
    {
        Free,    ///< it goes to where parameters want it
        Leaving, ///< a transition was found: it goes to the place where the space is left
        Arriving ///< the transition was made: it goes on to the place that was wanted
    };

    std::int64_t tick = 0;
    LiveTrack track;
    LiveTrack left;  ///< that fades out
    double fade = 1; ///< 0 at a switch, 1 once nothing is seen of what was left
    Way way = Way::Free;
    SpacePoint pace{};      ///< of the track's place, in its axes a second
    std::size_t target = 0; ///< of Leaving
    TransitionChoice choice;
    SpacePoint wayStart{};   ///< the place where the way began
    SpacePoint wayGoal{};    ///< where Arriving ends
    double wayFrames = 0;    ///< how many frames of it are done
    double wayEnd = 0;       ///< and how many there are
    std::size_t wanted = 0;  ///< the space that is wanted,
    std::int64_t wished = 0; ///< and the first tick at which it was
    std::size_t home = 0;    ///< the last space with a cycle: from one without it goes there
    SpacePoint homeParameters{};
    std::int64_t decisions = 0; ///< that were made

    /// How much of the pose is of the track, 0 … 1.
    double takenOver() const { return smoothStep(fade); }

    bool operator==(const LiveState&) const = default;
};

/// Why a transition was made: the ways that were found, the best first.
struct LiveDecision
{
    static constexpr std::size_t mostChoices = 6;

    std::int64_t tick = 0;   ///< at which the search was made
    std::int64_t wished = 0; ///< the first tick at which the target was wanted, the same or earlier
    std::size_t source = 0;
    std::size_t target = 0;
    SpaceState state; ///< of the source
    TransitionGoal goal;
    bool isResponsive = false;
    std::array<TransitionChoice, mostChoices> choices;
    std::size_t count = 0; ///< of choices

    /// From the wish until the target is where it is wanted. \param ticksPerFrame  of the player.
    double latencyFrames(int ticksPerFrame) const
    {
        return static_cast<double>(tick - wished) / ticksPerFrame + choices[0].sourceFrames +
               choices[0].targetFrames;
    }
    /// The best of those that go on in the source for longer than the one that was chosen; null where that is
    /// none of them.
    const TransitionChoice* goingOn() const;
};

} // namespace quadrille
