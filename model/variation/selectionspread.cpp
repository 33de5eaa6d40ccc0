// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/selectionspread.h"

#include "model/core/random.h"

namespace quadrille {

std::vector<PartSpread> selectionSpread(const LearnedMovement& learned,
                                        const std::vector<LatentVariation>& latents,
                                        const VariationSelection& selection, VariationPoses poses,
                                        std::uint64_t seed, const Progress& progress)
{
    const Movement& movement = learned.movement();
    std::vector<std::vector<Vec3f>> made;
    for (const int candidate : selection.accepted) {
        poses.seed = streamSeed(seed, static_cast<std::uint64_t>(candidate));
        made.push_back(variationPoses(learned, latents[static_cast<std::size_t>(candidate)], poses,
                                      Progress(progress.token())));
    }
    const std::vector<Positions> variations(made.begin(), made.end());
    std::vector<Positions> takes;
    for (std::size_t t = 0; t < movement.capturedCount(); ++t)
        takes.emplace_back(movement.take(t).poses);
    return variationSpread(movement.parts, movement.topology->vertexCount(), variations, takes, progress);
}

} // namespace quadrille
