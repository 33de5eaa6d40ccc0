// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/entryopening.h"

#include "model/sequence/io/registry.h"

#include <algorithm>

namespace quadrille {

namespace {

Texture textureOf(const std::string& path)
{
    return {.file = path};
}

TextureSet texturesOf(const TextureReference& reference)
{
    std::vector<Texture> textures;
    switch (reference.kind) {
    case TextureReference::Kind::None:
        break;
    case TextureReference::Kind::Single:
        return TextureSet::single(textureOf(reference.paths.front()));
    case TextureReference::Kind::PerMaterial:
        std::ranges::transform(reference.paths, std::back_inserter(textures), textureOf);
        return TextureSet::perMaterial(std::move(textures));
    case TextureReference::Kind::PerFrame:
        for (const std::filesystem::path& file : findSource(reference.paths.front()).files)
            textures.push_back({.file = file});
        return TextureSet::perFrame(std::move(textures));
    }
    return {};
}

} // namespace

OpenedEntry openEntry(const SequenceEntry& entry, const CharacterEntry& character,
                      const ProjectSettings& settings, const Progress& progress)
{
    ImportOptions options;
    options.mesh = character.mesh;
    options.fps = entry.sourceFps.value_or(settings.fps);
    options.from = entry.sourceAxes;
    options.to = settings.axes;
    options.clip = entry.clip;
    ImportResult result = openSequences(entry.source, options, progress);
    OpenedEntry opened{std::move(result.sequences.front()), std::move(result.issues)};
    const TextureReference& own = entry.texture;
    const TextureSet textures =
        texturesOf(own.kind == TextureReference::Kind::None ? character.texture : own);
    if (textures.kind() != TextureSet::Kind::None)
        opened.sequence.textures = textures;
    return opened;
}

} // namespace quadrille
