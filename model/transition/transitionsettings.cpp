// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/transitionsettings.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace quadrille {

int TransitionSettings::shortest() const
{
    return shortestWindow.value_or(std::max(1, static_cast<int>(std::ceil(fps / 3))));
}

int TransitionSettings::shortestBetween(int sourceFrames, int destinationFrames) const
{
    // What is left between the windows of two transitions can be played as captured for a while.
    constexpr double share = 0.3;
    const auto part = static_cast<int>(std::ceil(share * std::min(sourceFrames, destinationFrames)));
    return shortensInShortTakes ? std::min(shortest(), std::max(part, 1)) : shortest();
}

int TransitionSettings::longest() const
{
    return longestWindow.value_or(std::max(shortest(), static_cast<int>(std::floor(2 * fps))));
}

int TransitionSettings::lengthOf(int cells, int sourceWindow, int destinationWindow) const
{
    return length == TransitionLength::Path ? cells : (sourceWindow + destinationWindow + 1) / 2;
}

void checkSettings(const TransitionSettings& settings)
{
    if (!(settings.fps > 0 && settings.fps <= TransitionSettings::greatestWindow / 2.0))
        refuse("The frame rate of transitions is not between 0 and 2047 frames per second",
               "Give the frame rate of the sequences.");
    if (settings.shortest() < 1)
        refuse("The shortest window of a transition has no frame", "Give at least 1 frame.");
    if (settings.longest() < settings.shortest())
        refuse("The longest window of a transition (" + std::to_string(settings.longest()) +
                   " frames) is shorter than the shortest (" + std::to_string(settings.shortest()) + ")",
               "Give a longest window that is not below the shortest.");
    if (settings.longest() > TransitionSettings::greatestWindow)
        refuse("The longest window of a transition has " + std::to_string(settings.longest()) + " frames",
               "Give at most " + std::to_string(TransitionSettings::greatestWindow) + " frames.");
    if (settings.slope < TransitionSettings::leastSlope || settings.slope > TransitionSettings::greatestSlope)
        refuse("The slope of transitions is " + std::to_string(settings.slope), "Give 2, 3, 4 or 5.");
}

} // namespace quadrille
