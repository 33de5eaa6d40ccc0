// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/transitionplaces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

namespace quadrille {

TransitionPlaces transitionPlaces(const WeightSpace& space, int steps)
{
    TransitionPlaces found{.dimension = space.dimension()};
    const auto dimension = static_cast<std::size_t>(space.dimension());
    const std::array<SpacePoint, 2> range = space.range();
    const SpacePoint& least = range[0];
    const SpacePoint& greatest = range[1];
    for (std::size_t d = 0; d < dimension; ++d)
        found.step[d] = (greatest[d] - least[d]) / steps;

    std::set<std::array<std::int64_t, 3>> known;
    const auto add = [&](const SpacePoint& place, const NodeWeights& weights) {
        std::array<std::int64_t, 3> rounded{};
        for (std::size_t d = 0; d < dimension; ++d)
            rounded[d] = std::llround((place[d] - least[d]) / found.step[d] * 1e6);
        if (!known.insert(rounded).second)
            return;
        found.places.push_back(place);
        found.weights.push_back(weights);
    };
    for (std::size_t n = 0; n < space.nodes().size(); ++n)
        add(space.nodes()[n].place, {.nodes = {static_cast<int>(n)}, .weights = {1}, .count = 1});
    std::array<int, 3> at{};
    while (dimension > 0) {
        SpacePoint place{};
        for (std::size_t d = 0; d < dimension; ++d)
            place[d] = least[d] + at[d] * found.step[d];
        const NodeWeights weights = space.at(place);
        add(space.placeOf(weights), weights);
        std::size_t axis = dimension;
        while (axis > 0 && at[axis - 1] == steps)
            at[--axis] = 0;
        if (axis == 0)
            break;
        ++at[axis - 1];
    }
    return found;
}

std::size_t nearestFrame(double frame, std::size_t frames, bool isCyclic)
{
    const auto nearest = static_cast<std::size_t>(std::max(std::floor(frame + 0.5), 0.0));
    return isCyclic ? nearest % frames : std::min(nearest, frames - 1);
}

int framesBetween(const TransitionPlaces& places, const SpacePoint& from, const SpacePoint& to,
                  double stepsAFrame)
{
    constexpr double slack = 1e-6; // of rounding, frames
    double steps = 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(places.dimension); ++d)
        steps = std::max(steps, std::abs(to[d] - from[d]) / places.step[d]);
    return static_cast<int>(std::ceil(steps / stepsAFrame - slack));
}

} // namespace quadrille
