// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/labelspread.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

/// Labels that touch, moved as one.
struct Pool
{
    double sum = 0; ///< of the places wanted by the first of them if they stand apart as they must
    int count = 0;

    double mean() const { return sum / count; }
};

} // namespace

std::vector<std::optional<double>> spreadLabels(std::span<const double> wanted, double apart, double length,
                                                std::optional<std::size_t> needed)
{
    std::vector<std::optional<double>> places(wanted.size());
    const auto room = static_cast<std::size_t>(std::max(0.0, std::floor(length / apart)));
    const std::size_t shown = std::min(room, wanted.size());
    std::vector<std::size_t> kept(shown);
    for (std::size_t i = 0; i < shown; ++i)
        kept[i] = i * wanted.size() / shown;
    if (needed && !kept.empty()) // the last that is not behind it
        *std::prev(std::upper_bound(kept.begin(), kept.end(), *needed)) = *needed;

    std::vector<Pool> pools;
    for (std::size_t i = 0; i < shown; ++i) {
        pools.push_back({wanted[kept[i]] - static_cast<double>(i) * apart, 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
            const Pool last = pools.back();
            pools.pop_back();
            pools.back().sum += last.sum;
            pools.back().count += last.count;
        }
    }
    const double first = apart / 2;
    const double last = length - apart / 2 - (static_cast<double>(shown) - 1) * apart;
    std::size_t i = 0;
    for (const Pool& pool : pools) {
        for (int label = 0; label < pool.count; ++label, ++i)
            places[kept[i]] =
                std::clamp(pool.mean(), first, std::max(first, last)) + static_cast<double>(i) * apart;
    }
    return places;
}

} // namespace quadrille::widgets
