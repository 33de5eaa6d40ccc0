// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/animationentry.h"

#include <cmath>
#include <numbers>

namespace quadrille {

SearchSettings searchSettings(const SearchEntry& entry, double fps)
{
    SearchSettings settings;
    if (!entry.isPaper) {
        settings = SearchSettings::calm();
        settings.leastRun = static_cast<int>(std::lround(entry.dwell.value_or(usualDwell) * fps));
        settings.charging.deadZone = entry.deadZone.value_or(settings.charging.deadZone);
        // As much in a second as in a metre and a half, which a brisk walker goes in it.
        constexpr double briskWalk = 1.5;
        settings.steering.perMetre = entry.steering.value_or(usualSteering) * std::numbers::pi / 180;
        settings.steering.perFrame = briskWalk * settings.steering.perMetre / fps;
    }
    settings.beta = entry.beta;
    settings.mu = entry.mu.value_or(settings.mu);
    settings.budget = entry.budget.value_or(settings.budget);
    settings.globalKeys = entry.globalKeys;
    return settings;
}

} // namespace quadrille
