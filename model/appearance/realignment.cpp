// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/alignment.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

std::vector<std::uint8_t> realigned(const Image& texture, std::span<const float> warp,
                                    const ChartLookup& charts, const WarpGrid& grid)
{
    constexpr int iterations = 3;
    const std::vector<std::uint8_t> colours = charts.colours(texture);
    const std::vector<float> wanted(colours.begin(), colours.end());
    const std::vector<Vec2f> toAligned = charts.inverse(warp, grid);
    const std::vector<Vec2f> toTexture = charts.atTexels(warp, grid);
    std::vector<float> aligned = charts.sampled(wanted, toAligned);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        std::vector<float> missing = charts.sampled(aligned, toTexture);
        for (std::size_t i = 0; i < missing.size(); ++i)
            missing[i] = wanted[i] - missing[i];
        const std::vector<float> change = charts.sampled(missing, toAligned);
        for (std::size_t i = 0; i < aligned.size(); ++i)
            aligned[i] = std::clamp(aligned[i] + change[i], 0.0F, 255.0F);
    }
    std::vector<std::uint8_t> rounded(aligned.size());
    std::ranges::transform(aligned, rounded.begin(),
                           [](float value) { return static_cast<std::uint8_t>(std::lround(value)); });
    return rounded;
}

} // namespace

std::vector<float> keptWarp(const LinearSpace& warps, std::int64_t sample)
{
    std::vector<float> kept = warps.mean;
    Eigen::Map<Eigen::VectorXf> sum(kept.data(), std::ssize(kept));
    for (std::int64_t c = 0; c < warps.count(); ++c) {
        const double weight = warps.coefficients[static_cast<std::size_t>(sample * warps.count() + c)];
        sum += static_cast<float>(weight) *
               Eigen::Map<const Eigen::VectorXf>(warps.components.data() + c * warps.size(), warps.size());
    }
    return kept;
}

void realignTextures(const TextureSource& textures, const ChartLookup& charts, const LinearSpace& warps,
                     TextureAlignment& alignment, const Progress& progress, const Executor& executor)
{
    executor.run(makeTasks<std::uint8_t>(
                     textures.count,
                     [&](std::int64_t index, const Progress&) {
                         return realigned(*textures.read(index), keptWarp(warps, index), charts,
                                          alignment.grid());
                     },
                     [&](std::int64_t index, std::span<const std::uint8_t> colours) {
                         alignment.setAligned(index, std::as_bytes(colours));
                     }),
                 progress);
}

} // namespace quadrille
