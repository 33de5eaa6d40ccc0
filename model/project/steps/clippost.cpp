// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/clippost.h"

#include "model/project/document/paths.h"
#include "model/sequence/io/registry.h"

#include <algorithm>

namespace quadrille {

namespace {

Symmetry symmetryFor(const AnimationEntry& animation, const CharacterInputs& work,
                     const CharacterFrames& frames, const Progress& progress)
{
    const MeshSequence& any = frames.sequences().front();
    if (const auto files = symmetryFiles(animation, work); !files.empty())
        return readSymmetry(*any.topology, files.front());
    return symmetryOf(*work.opener, work.character, any, progress);
}

} // namespace

Symmetry symmetryOf(SequenceOpener& opener, const std::string& character, const MeshSequence& any,
                    const Progress& progress)
{
    const auto& characters = opener.project().characters;
    const auto entry = std::ranges::find(characters, character, &CharacterEntry::name);
    if (entry != characters.end() && !entry->mesh.empty()) {
        const ImportResult mesh = openSequences(resolvePath(entry->mesh, opener.folder()));
        const Frame rest = mesh.sequences.front().frame(FrameIndex(0));
        if (rest.positions().size() == any.topology->vertexCount())
            return findSymmetry(*any.topology, rest.positions(), {}, progress);
    }
    return findSymmetry(*any.topology, any.frame(FrameIndex(0)).positions(), {}, progress);
}

PostProcessingInputs postProcessingInputs(const AnimationEntry& animation, const CharacterInputs& work,
                                          const CharacterFrames& frames, const Stances& stances)
{
    const ProjectSettings& settings = work.opener->project().settings;
    PostProcessingInputs inputs{.method = {.up = settings.axes.up,
                                           .pose = work.graph.pose,
                                           .transitions = transitionSettings(work.graph, settings.fps),
                                           .interpolation = animation.interpolation},
                                .character = frames};
    if (stances.isKnown())
        inputs.contactsOf = [stances](const Clip& clip) { return contactsOf(clip, stances); };
    inputs.symmetry = [animation, work, frames](const Progress& progress) {
        return symmetryFor(animation, work, frames, progress);
    };
    return inputs;
}

std::vector<std::filesystem::path> symmetryFiles(const AnimationEntry& animation, const CharacterInputs& work)
{
    if (!animation.post.steps.mirror || animation.post.symmetry.empty())
        return {};
    return {resolvePath(animation.post.symmetry, work.opener->folder())};
}

} // namespace quadrille
