// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/frameprovenance.h"

#include <optional>

namespace quadrille {

namespace {

/// One of the two that a pose lies between.
struct End
{
    NodeIndex frame = 0;
    std::int32_t variation = 0;
    bool operator==(const End&) const = default;
};

End sourceOf(const FrameProvenance& origin)
{
    return {origin.source, origin.sourceVariation};
}

End destinationOf(const FrameProvenance& origin)
{
    return {origin.destination, origin.destinationVariation};
}

/// The weight of the destination with which an origin lies between two ends; nothing where it does not.
std::optional<double> weightBetween(const FrameProvenance& origin, const End& source, const End& destination)
{
    if (sourceOf(origin) == source && destinationOf(origin) == destination)
        return origin.lambda;
    if (!origin.isSingle())
        return {};
    if (sourceOf(origin) == source)
        return 0;
    if (sourceOf(origin) == destination)
        return 1;
    return {};
}

} // namespace

FrameProvenance originBetween(const FrameProvenance& first, const FrameProvenance& second, double lambda)
{
    const FrameProvenance& nearer = lambda < 0.5 ? first : second;
    if (lambda <= 0 || lambda >= 1 || first == second || first.mirrored != second.mirrored)
        return nearer;
    const auto between = [&](const End& source, const End& destination, double weight) {
        return FrameProvenance{source.frame,   destination.frame, weight,
                               first.mirrored, source.variation,  destination.variation};
    };
    if (first.isSingle() && second.isSingle()) {
        if (sourceOf(first) == sourceOf(second))
            return nearer;
        return between(sourceOf(first), sourceOf(second), lambda);
    }
    const FrameProvenance& blend = first.isSingle() ? second : first;
    const auto from = weightBetween(first, sourceOf(blend), destinationOf(blend));
    const auto to = weightBetween(second, sourceOf(blend), destinationOf(blend));
    if (!from || !to)
        return nearer;
    return between(sourceOf(blend), destinationOf(blend), (1 - lambda) * *from + lambda * *to);
}

} // namespace quadrille
