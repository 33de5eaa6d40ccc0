// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/blends.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <charconv>

namespace quadrille {

namespace {

std::vector<std::size_t> cornersOf(const MovementBlend& blend)
{
    std::vector<std::size_t> corners{blend.from, blend.to};
    if (blend.across)
        corners.insert(corners.end(), {blend.across->from, blend.across->to});
    return corners;
}

void checkWeights(const std::vector<double>& weights)
{
    double before = 0;
    for (const double weight : weights) {
        if (!(weight > before && weight < 1))
            refuse("The weights of a blend are not ascending between 0 and 1",
                   "Write weights like [0.25, 0.5, 0.75].");
        before = weight;
    }
}

/// Weights with both ends.
std::vector<double> withEnds(const std::vector<double>& weights)
{
    std::vector<double> all{0};
    all.insert(all.end(), weights.begin(), weights.end());
    all.push_back(1);
    return all;
}

std::string toText(double number)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

} // namespace

std::vector<Preblend> preblendsOf(std::span<const MovementBlend> blends)
{
    std::vector<Preblend> points;
    for (std::size_t b = 0; b < blends.size(); ++b) {
        const MovementBlend& blend = blends[b];
        if (!blend.across) {
            for (const double weight : blend.weights)
                points.push_back({b, weight, 0});
            continue;
        }
        for (const double across : withEnds(blend.across->weights)) {
            for (const double weight : withEnds(blend.weights)) {
                const bool isCorner = (weight == 0 || weight == 1) && (across == 0 || across == 1);
                if (!isCorner)
                    points.push_back({b, weight, across});
            }
        }
    }
    return points;
}

std::vector<BlendShare> squareShares(const std::array<std::size_t, 4>& corners, double weight, double across)
{
    const std::array<double, 4> shares{(1 - weight) * (1 - across), weight * (1 - across),
                                       (1 - weight) * across, weight * across};
    std::vector<BlendShare> some;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        if (shares[c] != 0)
            some.push_back({corners[c], shares[c]});
    }
    return some;
}

std::vector<BlendShare> sharesOf(const MovementBlend& blend, const Preblend& point)
{
    const AcrossBlend across = blend.across.value_or(AcrossBlend{blend.from, blend.to, {}});
    return squareShares({blend.from, blend.to, across.from, across.to}, point.weight, point.across);
}

std::string preblendName(const MovementBlend& blend, const Preblend& point,
                         const std::vector<std::string>& takes)
{
    const auto pair = [&](std::size_t from, std::size_t to) { return takes.at(from) + "–" + takes.at(to); };
    const std::vector<BlendShare> shares = sharesOf(blend, point);
    if (shares.size() == 2)
        return pair(shares[0].take, shares[1].take) + " " + toText(shares[1].share);
    return pair(blend.from, blend.to) + " × " + pair(blend.across->from, blend.across->to) + " " +
           toText(point.weight) + " " + toText(point.across);
}

void checkBlends(std::span<const MovementBlend> blends, std::size_t takes)
{
    for (const MovementBlend& blend : blends) {
        std::vector<std::size_t> corners = cornersOf(blend);
        std::ranges::sort(corners);
        if (std::ranges::adjacent_find(corners) != corners.end() || corners.back() >= takes)
            refuse("A blend is not between different takes", "Name two or four of those that are learned.");
        checkWeights(blend.weights);
        if (blend.across)
            checkWeights(blend.across->weights);
    }
}

} // namespace quadrille
