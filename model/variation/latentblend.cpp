// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/latentblend.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace quadrille {

BlendNeighbours blendNeighbours(std::span<const double> learned, double wanted)
{
    if (!(wanted >= 0 && wanted <= 1))
        refuse("the weight of the blend is outside of 0 … 1", "choose a weight between 0 and 1");
    const bool ascends = std::ranges::adjacent_find(learned, std::ranges::greater_equal()) == learned.end();
    if (learned.size() < 2 || !ascends || learned.front() != 0 || learned.back() != 1)
        refuse("the weights of the learned blends do not ascend from 0 to 1",
               "list each weight between 0 and 1 once, in ascending order");
    const auto above = std::ranges::upper_bound(learned.subspan(1, learned.size() - 2), wanted);
    const auto second = static_cast<std::size_t>(above - learned.subspan(1).begin()) + 1;
    const double w1 = learned[second - 1];
    const double w2 = learned[second];
    return {.first = second - 1, .second = second, .share = (wanted - w2) / (w1 - w2)};
}

std::array<double, 4> BlendCell::shares() const
{
    const double a = across.share;
    const double b = along.share;
    return {a * b, (1 - a) * b, a * (1 - b), (1 - a) * (1 - b)};
}

BlendCell blendCell(std::span<const double> learnedAcross, std::span<const double> learnedAlong,
                    double wantedAcross, double wantedAlong)
{
    return {.across = blendNeighbours(learnedAcross, wantedAcross),
            .along = blendNeighbours(learnedAlong, wantedAlong)};
}

RowMatrix latentBlend(std::span<const LatentShare> trajectories)
{
    assert(!trajectories.empty());
    RowMatrix blend = trajectories.front().share * trajectories.front().latents;
    for (const LatentShare& each : trajectories.subspan(1)) {
        assert(each.latents.rows() == blend.rows() && each.latents.cols() == blend.cols());
        blend += each.share * each.latents;
    }
    return blend;
}

} // namespace quadrille
