// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/variedrepeats.h"

#include "model/project/madeclips.h"
#include "model/project/opensequence.h"

#include <algorithm>

namespace quadrille {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The take that samples vary frame by frame; nothing where it is a blend, which has frames of its own.
std::optional<std::string> singleTake(const SamplesEntry& samples)
{
    return samples.to.empty() ? std::optional(samples.of) : std::nullopt;
}

} // namespace

bool isOfGraph(const Project& project, const VariationEntry& variation)
{
    const std::vector<std::string> graph = sequencesOfGraph(project, characterNameOf(project, variation));
    return std::all_of(variation.training.begin(), variation.training.end(),
                       [&](const TrainingEntry& take) { return contains(graph, take.sequence); });
}

std::vector<std::string> clipsDrawnFrom(const Project& project, const AnimationEntry& animation)
{
    std::vector<std::string> clips;
    if (!animation.post.variations)
        return clips;
    const std::string& from = animation.post.variations->from;
    const std::string character = characterNameOf(project, animation);
    const std::vector<std::string> graph = sequencesOfGraph(project, character);
    for (const VariationEntry* variation : learnedVariations(project, character)) {
        if (from.empty() ? !isOfGraph(project, *variation) : variation->name != from)
            continue;
        for (int number = 1; number <= variationCount(*variation); ++number) {
            const auto take = singleTake(variation->samples[placeOfVariation(*variation, number)->set]);
            if (take && contains(graph, *take) && !isDiscarded(*variation, number))
                clips.push_back(variationClip(variation->name, number));
        }
    }
    return clips;
}

} // namespace quadrille
