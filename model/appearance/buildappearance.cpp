// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/buildappearance.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

std::int64_t textureComponents(const BuildAppearanceOptions& options)
{
    const double share = std::clamp(options.textureShare, 0.0, 1.0);
    return std::llround(share * static_cast<double>(options.components));
}

BuiltAppearance buildAppearance(const TextureSource& textures, const Topology& topology,
                                const BuildAppearanceOptions& options, FlowCache* cache,
                                const Progress& progress, const Executor& executor)
{
    if (textures.count <= 0 || options.components < 0)
        refuse("An appearance is built from at least one texture, into components",
               "Give sequences that have a texture per frame.");
    const std::shared_ptr<const Image> first = textures.read(0);
    if (!first || first->isEmpty())
        refuse("The first texture is empty", "Choose sequences that have a texture per frame.");
    const ChartLookup charts(usedTexels(topology, first->width, first->height, options.gutter));
    const std::int64_t count = textureComponents(options);
    const bool isAligned = count < options.components;
    const double most = isAligned ? 0.9 : 0.3; // of the time
    const auto alignment =
        isAligned
            ? alignTextures(textures, charts, options.alignment, cache, progress.part(0, most), executor)
            : gatherTextures(textures, charts, options.alignment, progress.part(0, most), executor);
    BuiltAppearance built;
    built.used = charts.used();
    built.grid = alignment->grid();
    built.reference = alignment->reference;
    built.rounds = alignment->rounds;
    built.figures = alignment->figures;
    const auto part = [&](double from, double to) {
        return progress.part(most + from * (1 - most), most + to * (1 - most));
    };
    built.warps =
        principalComponents(alignment->backwardSamples(), options.components - count, part(0, 0.1), executor);
    std::ranges::fill(built.warps.mean, 0.0F);
    if (isAligned)
        realignTextures(textures, charts, built.warps, *alignment, part(0.1, 0.4), executor);
    built.textures = principalComponents(alignment->alignedSamples(), count, part(0.4, 1), executor);
    return built;
}

} // namespace quadrille
