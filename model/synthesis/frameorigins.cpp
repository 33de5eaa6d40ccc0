// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/frameorigins.h"

#include <optional>

namespace quadrille {

namespace {

/// The weight of the destination with which an origin lies between two frames; nothing where it does not.
std::optional<double> weightBetween(const FrameOrigin& origin, NodeIndex source, NodeIndex destination)
{
    if (origin.source == source && origin.destination == destination)
        return origin.lambda;
    if (!origin.isCaptured())
        return {};
    if (origin.source == source)
        return 0;
    if (origin.source == destination)
        return 1;
    return {};
}

} // namespace

FrameOrigin originBetween(const FrameOrigin& first, const FrameOrigin& second, double lambda)
{
    const FrameOrigin& nearer = lambda < 0.5 ? first : second;
    if (lambda <= 0 || lambda >= 1 || first == second || first.mirrored != second.mirrored)
        return nearer;
    if (first.isCaptured() && second.isCaptured()) {
        if (first.source == second.source)
            return nearer;
        return {first.source, second.source, lambda, first.mirrored};
    }
    const FrameOrigin& blend = first.isCaptured() ? second : first;
    const auto from = weightBetween(first, blend.source, blend.destination);
    const auto to = weightBetween(second, blend.source, blend.destination);
    if (!from || !to)
        return nearer;
    return {blend.source, blend.destination, (1 - lambda) * *from + lambda * *to, blend.mirrored};
}

} // namespace quadrille
