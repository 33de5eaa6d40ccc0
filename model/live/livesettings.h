// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/transitionsettings.h"
#include "model/parametric/weightspace.h"
#include "model/synthesis/clips/ground.h"

#include <cstddef>

namespace quadrille {

/// What is wanted at a tick.
struct LiveInput
{
    std::size_t space = 0;
    SpacePoint parameters{};   ///< of that space, in their units; kept to their limits
    bool isResponsive = false; ///< latency counts more than likeness

    bool operator==(const LiveInput&) const = default;
};

/// Where playing begins.
struct LiveStart
{
    std::size_t space = 0;
    SpacePoint parameters{};
    double frame = 0;
    GroundMotion root; ///< takes what stands over the origin to where it begins

    bool operator==(const LiveStart&) const = default;
};

struct LiveSettings
{
    int ticksPerFrame = 2;           ///< at least 1; a recorded clip has each of so many ticks
    TransitionSearchSettings search; ///< of transitions
    double responsiveWeight = 40;    ///< λ of IA4D eq. 4 where latency counts more, for a frame
    double fadeSeconds = 0.3;        ///< in which the target's surface takes over from the source's
    double secondsAcross = 1;        ///< in which a place may go over all of its range, at full pace
    double earliestLeave = 0.75;     ///< share of a space without a cycle that is played at least
    double latestArrival = 0.25;     ///< share of a space without a cycle within which it is entered

    bool operator==(const LiveSettings&) const = default;
};

} // namespace quadrille
