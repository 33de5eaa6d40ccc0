// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/movingplace.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

void movePlaceTowards(const SpacePoint& wanted, const SpacePoint& least, const SpacePoint& greatest,
                      double secondsAcross, double seconds, SpacePoint& place, SpacePoint& pace)
{
    constexpr double rampShare = 0.25;
    constexpr double nothing = 1e-9;                                       // of an axis
    const double fastest = 1 / secondsAcross;                              // axes a second
    const double change = fastest / (rampShare * secondsAcross) * seconds; // of that pace in a tick, at most
    double away = 0;                                                       // axes
    for (std::size_t d = 0; d < wanted.size(); ++d) {
        if (greatest[d] > least[d])
            away = std::max(away, std::abs(wanted[d] - place[d]) / (greatest[d] - least[d]));
    }
    // The pace from which it comes to rest in time: it is braked by the same at each tick.
    const double steps = away / (change * seconds);
    const double whole = std::floor((std::sqrt(1 + 8 * steps) - 1) / 2);
    const double braking = (whole / 2 + steps / (whole + 1)) * change;
    const double aim = std::min({fastest, braking, away / seconds});
    SpacePoint changes{};
    double greatestChange = 0;
    for (std::size_t d = 0; d < wanted.size(); ++d) {
        if (greatest[d] <= least[d])
            continue;
        changes[d] = (away > 0 ? (wanted[d] - place[d]) / away * aim : 0) - pace[d];
        greatestChange = std::max(greatestChange, std::abs(changes[d]) / (greatest[d] - least[d]));
    }
    const double share = greatestChange > change ? change / greatestChange : 1;
    const bool isThere = share == 1 && aim * seconds >= away - nothing;
    for (std::size_t d = 0; d < wanted.size(); ++d) {
        pace[d] = greatest[d] > least[d] ? pace[d] + share * changes[d] : 0;
        place[d] = isThere ? wanted[d] : std::clamp(place[d] + pace[d] * seconds, least[d], greatest[d]);
    }
}

double wayGone(double share)
{
    return share * share * (3 - 2 * share);
}

double stepsAFrame(int steps, double secondsAcross, double fps)
{
    constexpr double fastest = 1.5; // of wayGone, in the middle
    return steps / (secondsAcross * fps * fastest);
}

} // namespace quadrille
