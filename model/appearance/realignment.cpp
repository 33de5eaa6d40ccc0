// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/alignment.h"
#include "model/appearance/decodekernels.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

std::vector<std::uint8_t> realigned(const Image& texture, std::span<const float> warp,
                                    const ChartLookup& charts, const WarpGrid& grid)
{
    constexpr int iterations = 3;
    std::vector<std::uint8_t> colours = charts.colours(texture);
    std::vector<float> wanted(colours.begin(), colours.end());
    wanted.push_back(0); // see ChartLookup::sample
    const std::vector<Vec2f> toAligned = charts.inverse(warp, grid);
    const std::vector<Vec2f> toTexture = charts.atTexels(warp, grid);
    std::vector<float> aligned(wanted.size());
    std::vector<float> missing(wanted.size());
    std::vector<float> change(wanted.size());
    charts.sample(wanted, toAligned, aligned);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        charts.sample(aligned, toTexture, missing);
        for (std::size_t i = 0; i < missing.size(); ++i)
            missing[i] = wanted[i] - missing[i];
        charts.sample(missing, toAligned, change);
        for (std::size_t i = 0; i < aligned.size(); ++i)
            aligned[i] = std::clamp(aligned[i] + change[i], 0.0F, 255.0F);
    }
    roundToBytes(aligned.data(), static_cast<int>(colours.size()), colours.data());
    return colours;
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
