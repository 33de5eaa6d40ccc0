// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/ranks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace quadrille {

double quantile(std::vector<double> values, double share)
{
    if (values.empty())
        return 0;
    const double place = std::ceil(share * static_cast<double>(values.size())) - 1;
    const auto position = values.begin() + static_cast<std::ptrdiff_t>(std::max(place, 0.0));
    std::ranges::nth_element(values, position);
    return *position;
}

std::vector<double> ranksOf(std::span<const double> values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && values[order[end]] == values[order[first]])
            ++end;
        const double shared = (static_cast<double>(first + end) + 1) / 2;
        for (std::size_t place = first; place < end; ++place)
            ranks[order[place]] = shared;
        first = end;
    }
    return ranks;
}

std::optional<double> rankCorrelation(std::span<const double> a, std::span<const double> b)
{
    assert(a.size() == b.size());
    const std::vector<double> x = ranksOf(a);
    const std::vector<double> y = ranksOf(b);
    const double mean = (static_cast<double>(x.size()) + 1) / 2;
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean) * (x[i] - mean);
        yy += (y[i] - mean) * (y[i] - mean);
        xy += (x[i] - mean) * (y[i] - mean);
    }
    if (xx == 0 || yy == 0)
        return std::nullopt;
    return xy / std::sqrt(xx * yy);
}

std::optional<double> areaUnderCurve(std::span<const double> scores, const std::vector<bool>& isSo)
{
    assert(scores.size() == isSo.size());
    const std::vector<double> ranks = ranksOf(scores);
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (isSo[i]) {
            sum += ranks[i];
            ++count;
        }
    }
    const double others = static_cast<double>(ranks.size()) - count;
    if (count == 0 || others == 0)
        return std::nullopt;
    return (sum - count * (count + 1) / 2) / (count * others);
}

} // namespace quadrille
