// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/livesettings.h"
#include "model/project/document/animationentry.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// From a tick on, this is wanted. Spaces count as LiveEntry lists them.
struct LiveChange
{
    std::int64_t tick = 0;
    LiveInput input;

    bool operator==(const LiveChange&) const = default;
};

/// A performance that was steered live, by what was wanted at each tick: playing it again gives the same.
struct LiveEntry
{
    std::string name;
    std::vector<std::string> spaces;                  ///< motion spaces of one character
    std::vector<LiveChange> inputs;                   ///< ascending, the first at tick 0
    std::int64_t ticks = 0;                           ///< of the performance
    std::int64_t from = 0;                            ///< the tick of the clip's first frame
    int ticksPerFrame = LiveSettings().ticksPerFrame; ///< the clip has a frame after each of so many ticks
    std::optional<Vec2d> position;                    ///< where it begins; the middle of the ground
    double heading = 0;                               ///< degrees to the left
    int depth = LiveSettings().search.depth;          ///< of the trellis, frames
    double latencyWeight = LiveSettings().search.latencyWeight; ///< λ, for a frame
    double responsiveWeight = LiveSettings().responsiveWeight; ///< λ where latency counts more than likeness
    double fadeSeconds = LiveSettings().fadeSeconds;           ///< in which one space takes over from another
    double secondsAcross =
        LiveSettings().secondsAcross; ///< in which a parameter goes over its range at least
    bool correctsContacts = true;     ///< feet that stand in the takes stand still
    UnknownKeys unknown;

    bool operator==(const LiveEntry&) const = default;
};

} // namespace quadrille
