// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/clipparts.h"

#include "model/project/opensequence.h"
#include "model/project/paths.h"

#include <set>

namespace quadrille {

namespace {

/// What a clip shows: a sequence its source, an animation the sequences of its graph.
std::vector<std::string> shownBy(const Project& project, const std::string& clip)
{
    std::vector<std::string> shown;
    const auto animated = nameOfClip(clip, "animations");
    const auto named = nameOfClip(clip, "sequences");
    if (const auto* animation = animated ? findAnimation(project, *animated) : nullptr) {
        for (const std::string& sequence : sequencesOfGraph(project, characterNameOf(project, *animation)))
            shown.push_back("sequences/" + sequence);
    } else if (const auto* sequence =
                   clip.starts_with("sequences/") ? findSequence(project, *named) : nullptr) {
        if (auto source = clipOfSource(sequence->source))
            shown.push_back(std::move(*source));
    }
    return shown;
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
    return parts;
}

bool isMadeOfItself(const Project& project, const std::string& clip)
{
    return withAllParts(project, shownBy(project, clip)).contains(clip);
}

} // namespace quadrille
