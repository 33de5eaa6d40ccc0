// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/arclayout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace quadrille::widgets {

namespace {

int sequenceOf(const std::vector<int>& starts, int frame)
{
    return static_cast<int>(std::upper_bound(starts.begin(), starts.end(), frame) - starts.begin()) - 1;
}

} // namespace

std::vector<ArcBundle> bundleArcs(const std::vector<Arc>& arcs, const std::vector<int>& starts,
                                  int framesEach, int most)
{
    using Pair = std::pair<int, int>;
    const int each = std::max(framesEach, 1);
    std::unordered_map<std::uint64_t, ArcBundle> bundles;
    for (const Arc& arc : arcs) {
        const auto place =
            (static_cast<std::uint64_t>(arc.from / each) << 32U) | static_cast<std::uint64_t>(arc.to / each);
        const auto [at, isNew] = bundles.try_emplace(place, ArcBundle{arc, 1});
        if (isNew)
            continue;
        ++at->second.count;
        if (arc.weight < at->second.lightest.weight)
            at->second.lightest = arc;
    }
    std::map<Pair, std::vector<ArcBundle>> byPair;
    for (const auto& [place, bundle] : bundles)
        byPair[{sequenceOf(starts, bundle.lightest.from), sequenceOf(starts, bundle.lightest.to)}].push_back(
            bundle);
    const auto isBefore = [](const ArcBundle& a, const ArcBundle& b) {
        return std::tuple(a.lightest.weight, a.lightest.from, a.lightest.to) <
               std::tuple(b.lightest.weight, b.lightest.from, b.lightest.to);
    };
    // Ranks come before weights: the n-th of every pair is taken before the next of any.
    std::vector<std::tuple<std::size_t, float, const ArcBundle*>> ranked;
    for (auto& [pair, own] : byPair) {
        const auto kept = std::min(own.size(), static_cast<std::size_t>(std::max(most, 0)));
        std::partial_sort(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(kept), own.end(), isBefore);
        for (std::size_t rank = 0; rank < kept; ++rank)
            ranked.emplace_back(rank, own[rank].lightest.weight, &own[rank]);
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
        return std::pair(std::get<0>(a), std::get<1>(a)) < std::pair(std::get<0>(b), std::get<1>(b));
    });
    std::vector<ArcBundle> kept;
    for (const auto& [rank, weight, bundle] : ranked)
        if (static_cast<int>(kept.size()) < most)
            kept.push_back(*bundle);
    std::sort(kept.begin(), kept.end(), [](const ArcBundle& a, const ArcBundle& b) {
        return std::pair(a.lightest.from, a.lightest.to) < std::pair(b.lightest.from, b.lightest.to);
    });
    return kept;
}

QRectF ArcCurve::ellipse() const
{
    const double reach = std::abs(height);
    return {std::min(from, to), base - reach, std::abs(to - from), 2 * reach};
}

double ArcCurve::distance(const QPointF& point) const
{
    const double radius = std::max(std::abs(to - from) / 2, 1.0);
    const double reach = std::max(std::abs(height), 1.0);
    const double x = (point.x() - (from + to) / 2) / radius;
    const double y = (height >= 0 ? base - point.y() : point.y() - base) / reach;
    if (y < 0)
        return std::hypot(point.x() - (std::abs(point.x() - from) < std::abs(point.x() - to) ? from : to),
                          point.y() - base);
    // The value of the ellipse's equation over its gradient: near the curve, the distance.
    const double level = x * x + y * y;
    const double slope = 2 * std::hypot(x / radius, y / reach);
    return slope > 0 ? std::abs(level - 1) / slope : std::min(radius, reach);
}

} // namespace quadrille::widgets
