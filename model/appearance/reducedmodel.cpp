// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/reducedmodel.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

constexpr auto leftOutOfMeans = static_cast<std::uint32_t>(-1);

/// Small texels, and which of them each large one goes into.
struct Reduction
{
    UsedTexels texels;
    std::vector<std::uint32_t> target; ///< per used texel; leftOutOfMeans where it belongs to another chart
};

Reduction reductionOf(const UsedTexels& used, int factor)
{
    Reduction result;
    UsedTexels& small = result.texels;
    small.width = (used.width + factor - 1) / factor;
    small.height = (used.height + factor - 1) / factor;
    small.chartCount = used.chartCount;
    const auto placeOf = [&](std::uint32_t texel) {
        const auto width = static_cast<std::uint32_t>(used.width);
        const auto by = static_cast<std::uint32_t>(factor);
        return texel / width / by * static_cast<std::uint32_t>(small.width) + texel % width / by;
    };
    std::vector<std::uint16_t> chartAt(static_cast<std::size_t>(small.width) *
                                       static_cast<std::size_t>(small.height));
    std::vector<std::uint8_t> coveredAt(chartAt.size());
    for (std::size_t t = 0; t < used.texels.size(); ++t) {
        const std::uint32_t place = placeOf(used.texels[t]);
        // Covered texels say whose it is; gutters only where there are no others.
        if (chartAt[place] == 0 || (coveredAt[place] == 0 && used.covered[t] != 0))
            chartAt[place] = static_cast<std::uint16_t>(used.charts[t] + 1);
        coveredAt[place] |= used.covered[t];
    }
    std::vector<std::uint32_t> indexAt(chartAt.size());
    for (std::size_t place = 0; place < chartAt.size(); ++place) {
        if (chartAt[place] == 0)
            continue;
        indexAt[place] = static_cast<std::uint32_t>(small.texels.size());
        small.texels.push_back(static_cast<std::uint32_t>(place));
        small.charts.push_back(static_cast<std::uint16_t>(chartAt[place] - 1));
        small.covered.push_back(coveredAt[place]);
    }
    for (std::size_t t = 0; t < used.texels.size(); ++t) {
        const std::uint32_t place = placeOf(used.texels[t]);
        result.target.push_back(used.charts[t] + 1 == chartAt[place] ? indexAt[place] : leftOutOfMeans);
    }
    return result;
}

/// Means over the texels that go into each small one. \param valueAt  (index) → value of a large sample.
template <typename ValueAt>
std::vector<float> meansOf(const Reduction& reduction, const ValueAt& valueAt)
{
    std::vector<float> sums(3 * reduction.texels.texels.size());
    std::vector<float> counts(reduction.texels.texels.size());
    for (std::size_t t = 0; t < reduction.target.size(); ++t) {
        const std::size_t target = reduction.target[t];
        if (target == leftOutOfMeans)
            continue;
        for (std::size_t c = 0; c < 3; ++c)
            sums[3 * target + c] += valueAt(static_cast<std::int64_t>(3 * t + c));
        ++counts[target];
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] /= counts[i / 3];
    return sums;
}

/// As many nodes as before, half of a large texel less half of a small one further right and down, where
/// texels have their centres now.
std::vector<float> warpsOfLargerTexels(std::span<const float> nodes, const WarpGrid& grid, int factor)
{
    const float shift =
        static_cast<float>(factor - 1) / static_cast<float>(2 * grid.spacing); // of a node to the next
    std::vector<float> values;
    for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i) {
            const auto at = [&](int column, int row, int axis) {
                const int node =
                    std::min(row, grid.height - 1) * grid.width + std::min(column, grid.width - 1);
                return nodes[2 * static_cast<std::size_t>(node) + static_cast<std::size_t>(axis)];
            };
            for (const int axis : {0, 1}) {
                const float above = std::lerp(at(i, j, axis), at(i + 1, j, axis), shift);
                const float below = std::lerp(at(i, j + 1, axis), at(i + 1, j + 1, axis), shift);
                values.push_back(std::lerp(above, below, shift) / static_cast<float>(factor));
            }
        }
    }
    return values;
}

} // namespace

AppearanceModel reduced(const AppearanceModel& model, int factor, const Progress& progress)
{
    assert(factor >= 1 && model.grid.spacing % factor == 0);
    const Reduction reduction = reductionOf(model.texels, factor);
    const QuantisedSpace& textures = model.textures;
    const std::vector<float> mean = combined(textures, {});
    LinearSpace small{
        .mean = meansOf(reduction, [&](std::int64_t i) { return mean[static_cast<std::size_t>(i)]; }),
        .eigenvalues = textures.eigenvalues,
        .coefficients = textures.coefficients};
    for (std::int64_t c = 0; c < textures.count; ++c) {
        progress.part(0, 0.9).report(c, textures.count);
        const std::vector<float> component =
            meansOf(reduction, [&](std::int64_t i) { return textures.component(c, i); });
        small.components.insert(small.components.end(), component.begin(), component.end());
    }
    AppearanceModel result;
    result.texels = reduction.texels;
    result.textures = quantised(small, progress.part(0.9, 1));
    result.grid = model.grid;
    result.grid.spacing /= factor;
    const auto warps = [&](std::span<const float> nodes) {
        return warpsOfLargerTexels(nodes, model.grid, factor);
    };
    LinearSpace smallWarps{.mean = warps(combined(model.warps, {})),
                           .eigenvalues = model.warps.eigenvalues,
                           .coefficients = model.warps.coefficients};
    std::vector<float> component(static_cast<std::size_t>(model.warps.size));
    for (std::int64_t c = 0; c < model.warps.count; ++c) {
        for (std::size_t i = 0; i < component.size(); ++i)
            component[i] = model.warps.component(c, static_cast<std::int64_t>(i));
        const std::vector<float> values = warps(component);
        smallWarps.components.insert(smallWarps.components.end(), values.begin(), values.end());
    }
    result.warps = quantised(smallWarps);
    result.frames = model.frames;
    return result;
}

} // namespace quadrille
