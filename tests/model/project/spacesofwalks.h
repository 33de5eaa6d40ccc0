// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/motionspaceentry.h"
#include "tests/model/variation/tubewalk.h"

namespace quadrille::test {

/// Of two takes of a walk and more, by their speed.
inline MotionSpaceEntry spaceOf(const std::string& name, const std::vector<std::string>& takes,
                                double tolerance = 0.01)
{
    MotionSpaceEntry entry;
    entry.name = name;
    for (const std::string& take : takes)
        entry.takes.emplace_back().sequence = take;
    if (takes.size() > 1)
        entry.parameters.emplace_back().name = "speed";
    entry.tolerance = tolerance;
    return entry;
}

/// The slow and the fast walk of one tube.
inline constexpr TubeWalk slowWalk{};
inline constexpr TubeWalk fastWalk{.period = 16, .step = 0.05, .size = 1.6};

} // namespace quadrille::test
