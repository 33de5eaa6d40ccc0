// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/clipdependencies.h"

#include "model/core/contains.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"

#include <algorithm>
#include <optional>
#include <set>

namespace quadrille {

namespace {

/// The take that samples vary frame by frame; nothing where it is a blend, which has frames of its own.
std::optional<std::string> singleTake(const SamplesEntry& samples)
{
    return samples.to.empty() ? std::optional(samples.of) : std::nullopt;
}

/// Whether all takes that variations are learned from are frames of the graph that animations of their
/// character walk through: animations that draw from any variations draw from these.
bool isOfGraph(const Project& project, const VariationEntry& variation)
{
    const std::vector<std::string> graph = sequencesOfGraph(project, characterNameOf(project, variation));
    return std::all_of(variation.training.begin(), variation.training.end(),
                       [&](const TrainingEntry& take) { return contains(graph, take.sequence); });
}

/// What some clips are made of, directly and through others, and themselves.
std::set<std::string> withAllParts(const Project& project, std::vector<std::string> waiting)
{
    std::set<std::string> all(waiting.begin(), waiting.end());
    while (!waiting.empty()) {
        const std::string clip = std::move(waiting.back());
        waiting.pop_back();
        for (std::string& shown : shownBy(project, clip)) {
            if (all.insert(shown).second)
                waiting.push_back(std::move(shown));
        }
    }
    return all;
}

} // namespace

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

std::vector<std::string> shownBy(const Project& project, const std::string& clip)
{
    std::vector<std::string> shown;
    if (const auto named = nameOfClip(clip, "sequences")) {
        const SequenceEntry* sequence = findSequence(project, *named);
        if (auto source = sequence ? clipOfSource(sequence->source) : std::nullopt)
            shown.push_back(std::move(*source));
        return shown;
    }
    if (const ProjectionEntry* projection = projectionOfClip(project, clip))
        return {projection->clip};
    for (const std::string& sequence : sequencesOfClip(project, clip))
        shown.push_back("sequences/" + sequence);
    if (const TransferEntry* transfer = transferOfClip(project, clip)) {
        shown.push_back(transfer->clip);
        for (const std::string& sequence : templateSequences(project, *transfer))
            shown.push_back("sequences/" + sequence);
    }
    const auto named = nameOfClip(clip, "animations");
    if (const AnimationEntry* animation = named ? findAnimation(project, *named) : nullptr) {
        for (std::string& variation : clipsDrawnFrom(project, *animation))
            shown.push_back(std::move(variation));
    }
    return shown;
}

Project partsOfClip(const Project& project, const std::string& clip)
{
    const std::set<std::string> clips = withAllParts(project, {clip});
    Project parts;
    parts.settings = project.settings;
    parts.characters = project.characters;
    for (CharacterEntry& character : parts.characters)
        character.notes.clear();
    for (const SequenceEntry& sequence : project.sequences) {
        if (clips.contains("sequences/" + sequence.name))
            parts.sequences.push_back(sequence);
    }
    for (const AnimationEntry& animation : project.animations) {
        if (clips.contains("animations/" + animation.name))
            parts.animations.push_back(animation);
    }
    for (const VariationEntry& variation : project.variations) {
        const std::string prefix = "variations/" + variation.name + "/";
        const auto at = clips.lower_bound(prefix);
        if (at != clips.end() && at->starts_with(prefix))
            parts.variations.push_back(variation);
    }
    for (const LiveEntry& live : project.lives) {
        if (clips.contains("live/" + live.name))
            parts.lives.push_back(live);
    }
    for (const LiveEntry& live : parts.lives) {
        // A space is laid onto a pose of any sequence of its character.
        const Project spaces = partsOfMotionSpaces(project, live.spaces);
        parts.sequences = spaces.sequences;
        for (const MotionSpaceEntry& space : spaces.motionSpaces) {
            if (!contains(parts.motionSpaces, space))
                parts.motionSpaces.push_back(space);
        }
    }
    for (const TransferEntry& transfer : project.transfers) {
        if (clips.contains("transfers/" + transfer.name)) {
            parts.transfers.push_back(transfer);
            parts.transfers.back().truth.clear();
        }
    }
    for (const ProjectionEntry& projection : project.projections) {
        if (clips.contains("projections/" + projection.name))
            parts.projections.push_back(projection);
    }
    if (!parts.variations.empty() || !parts.lives.empty())
        parts.bodyParts = project.bodyParts;
    return parts;
}

Project partsOfMotionSpaces(const Project& project, const std::vector<std::string>& spaces)
{
    Project parts = project;
    std::erase_if(parts.motionSpaces,
                  [&](const MotionSpaceEntry& space) { return !contains(spaces, space.name); });
    parts.lives.clear();
    parts.appearances.clear();
    parts.projections.clear();
    parts.evaluations.clear();
    parts.exports.clear();
    return parts;
}

bool isMadeOfItself(const Project& project, const std::string& clip)
{
    return withAllParts(project, shownBy(project, clip)).contains(clip);
}

} // namespace quadrille
