// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/costoverview.h"

#include <algorithm>
#include <limits>
#include <tbb/parallel_for.h>
#include <vector>

namespace quadrille {

namespace {

constexpr float noTransition = std::numeric_limits<float>::infinity();

} // namespace

CostRange costRange(TableView<float> cost)
{
    constexpr Eigen::Index looks = 200'000;
    constexpr double shownShare = 0.9; // dearer ones look alike
    const Eigen::Index step = std::max<Eigen::Index>(cost.size() / looks, 1);
    std::vector<float> sample;
    for (Eigen::Index i = 0; i < cost.size(); i += step) {
        if (cost.data()[i] < noTransition)
            sample.push_back(cost.data()[i]);
    }
    if (sample.empty())
        return {};
    const auto high =
        sample.begin() + static_cast<std::ptrdiff_t>(shownShare * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), high, sample.end());
    return {.minimum = *std::min_element(sample.begin(), sample.end()), .maximum = *high};
}

CostOverview costOverview(TableView<float> cost, const FrameLayout& layout, int side)
{
    const NodeIndex frames = layout.frameCount();
    CostOverview overview{.layout = layout, .framesOfCell = 1, .least = {}, .range = costRange(cost)};
    while ((frames + overview.framesOfCell - 1) / overview.framesOfCell > side)
        overview.framesOfCell *= 2;
    const NodeIndex each = overview.framesOfCell;
    const NodeIndex cells = (frames + each - 1) / each;
    overview.least = Table<float>::Constant(cells, cells, noTransition);
    tbb::parallel_for(NodeIndex{0}, cells, [&](NodeIndex row) {
        float* least = &overview.least(row, 0);
        for (NodeIndex i = row * each; i < std::min((row + 1) * each, frames); ++i) {
            const float* costs = &cost.coeffRef(i, 0);
            for (NodeIndex column = 0; column < cells; ++column) {
                for (NodeIndex j = column * each; j < std::min((column + 1) * each, frames); ++j)
                    least[column] = std::min(least[column], costs[j]);
            }
        }
    });
    return overview;
}

} // namespace quadrille
