// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/blendsteps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace quadrille {

namespace {

constexpr double longestStep = 0.4; // seconds
constexpr double shortestStep = 0.2;
constexpr std::size_t mostSteps = 2; // in one blend

/// The frames of one blend, in the clip.
struct Blend
{
    std::size_t first;
    std::size_t last;

    std::size_t count() const { return last - first + 1; }
};

std::vector<Blend> blendsOf(const std::vector<FrameOrigin>& origins)
{
    std::vector<Blend> blends;
    for (std::size_t f = 0; f < origins.size(); ++f) {
        if (origins[f].isSingle())
            continue;
        if (f == 0 || origins[f - 1].isSingle())
            blends.push_back({f, f});
        blends.back().last = f;
    }
    return blends;
}

/// A foot that stands throughout a blend, and how far it is carried.
struct CarriedFoot
{
    std::size_t foot;
    double way;
};

/// Farthest first.
std::vector<CarriedFoot> carriedFeet(const std::vector<std::uint32_t>& standing, const Blend& blend,
                                     const Clip& clip, const Stances& stances)
{
    std::uint32_t throughout = standing[blend.first];
    for (std::size_t f = blend.first; f <= blend.last; ++f)
        throughout &= standing[f];
    std::vector<CarriedFoot> feet;
    for (std::size_t foot = 0; foot < stances.feet.size(); ++foot) {
        if ((throughout >> foot & 1U) == 0)
            continue;
        const double way = carriedWay(clip, stances, foot, blend.first, blend.last);
        if (way > longestCarry)
            feet.push_back({foot, way});
    }
    std::ranges::stable_sort(feet, std::greater(), &CarriedFoot::way);
    return feet;
}

} // namespace

void addSteps(std::vector<std::uint32_t>& standing, const Clip& clip, const Stances& stances)
{
    const auto longest = static_cast<std::size_t>(std::lround(longestStep * clip.fps));
    const auto shortest = static_cast<std::size_t>(std::ceil(shortestStep * clip.fps));
    for (const Blend& blend : blendsOf(clip.origins)) {
        const std::vector<CarriedFoot> feet = carriedFeet(standing, blend, clip, stances);
        // Before, between and behind steps all feet stand for a frame.
        const std::size_t fitting = (blend.count() - 1) / (shortest + 1);
        const std::size_t steps = std::min({feet.size(), fitting, mostSteps});
        if (steps == 0)
            continue;
        const std::size_t length = std::min((blend.count() - 1) / steps - 1, longest);
        std::size_t begin = blend.first + (blend.count() - steps * (length + 1) + 1) / 2;
        for (std::size_t step = 0; step < steps; ++step, begin += length + 1) {
            const std::uint32_t bit = 1U << feet[step].foot;
            const auto swing = std::span(standing).subspan(begin, length);
            if (!std::ranges::all_of(swing, [bit](std::uint32_t on) { return (on & ~bit) != 0; }))
                continue;
            for (std::uint32_t& on : swing)
                on &= ~bit;
        }
    }
}

} // namespace quadrille
