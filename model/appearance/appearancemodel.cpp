// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/appearancemodel.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace quadrille {

namespace {

std::vector<float> rowOf(const QuantisedSpace& space, std::size_t sample)
{
    const double* row = space.coefficients.data() + sample * static_cast<std::size_t>(space.count);
    std::vector<float> values;
    std::transform(row, row + space.count, std::back_inserter(values),
                   [](double value) { return static_cast<float>(value); });
    return values;
}

std::vector<float> mixed(const std::vector<float>& first, const std::vector<float>& second, double weight)
{
    std::vector<float> values(std::max(first.size(), second.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double from = i < first.size() ? static_cast<double>(first[i]) : 0;
        const double to = i < second.size() ? static_cast<double>(second[i]) : 0;
        values[i] = static_cast<float>((1 - weight) * from + weight * to);
    }
    return values;
}

} // namespace

AppearanceModel quantised(UsedTexels texels, WarpGrid grid, const LinearSpace& textures,
                          const LinearSpace& warps, std::vector<AppearanceFrame> frames,
                          const Progress& progress)
{
    assert(textures.size() == 3 * static_cast<std::int64_t>(texels.texels.size()));
    assert(warps.size() == 2 * grid.nodes());
    AppearanceModel model;
    model.texels = std::move(texels);
    model.grid = grid;
    model.textures = quantised(textures, progress.part(0, 0.9));
    model.warps = quantised(warps, progress.part(0.9, 1));
    model.frames = std::move(frames);
    assert(model.textures.coefficients.size() ==
           model.frames.size() * static_cast<std::size_t>(model.textures.count));
    assert(model.warps.coefficients.size() ==
           model.frames.size() * static_cast<std::size_t>(model.warps.count));
    return model;
}

AppearanceCoefficients coefficientsOf(const AppearanceModel& model, std::size_t frame)
{
    assert(frame < model.frames.size());
    return {rowOf(model.textures, frame), rowOf(model.warps, frame)};
}

AppearanceCoefficients interpolated(const AppearanceCoefficients& first, const AppearanceCoefficients& second,
                                    double weight)
{
    return {mixed(first.textures, second.textures, weight), mixed(first.warps, second.warps, weight)};
}

} // namespace quadrille
