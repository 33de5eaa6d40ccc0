// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/appearancework.h"

#include "model/core/contenthash.h"
#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"
#include "model/project/store/resultplaces.h"

namespace quadrille {

std::filesystem::path AppearanceWork::folder() const
{
    return appearanceFolder(cacheFolder(projectFile), entry.name);
}

BuildStep AppearanceWork::step(std::string name) const
{
    BuildStep made;
    made.name = std::move(name);
    made.dataPrefix = "appearance/" + entry.name;
    made.character = characterNameOf(opener->project(), entry);
    return made;
}

WrittenFile AppearanceWork::written(const std::filesystem::path& file, const Progress& progress) const
{
    return {storedPath(file, opener->folder()), hashFile(file, progress)};
}

BuildAppearanceOptions AppearanceWork::options() const
{
    BuildAppearanceOptions options;
    options.components = entry.components;
    options.textureShare = 1 - entry.warpShare;
    options.alignment.flow.method = entry.flow;
    options.alignment.scratchFolder = folder();
    return options;
}

FlowFiles AppearanceWork::flows(const AppearanceTraining& training, const Progress& progress) const
{
    std::vector<std::string> hashes;
    for (const Texture& texture : training.textures) {
        progress.report(std::ssize(hashes), std::ssize(training.textures));
        ContentHasher hasher;
        if (texture.file.empty())
            hasher.addBytes(std::as_bytes(std::span(texture.load()->pixels)));
        hashes.push_back(texture.file.empty() ? hasher.hex() : hashFile(texture.file, progress));
    }
    const TopologyData& layout = training.topology->data();
    const BuildAppearanceOptions usual = options();
    ContentHasher settings;
    settings.add(std::int64_t{usual.gutter});
    settings.add(std::int64_t{usual.alignment.spacing});
    settings.addBytes(std::as_bytes(std::span(layout.uvs)));
    settings.addBytes(std::as_bytes(std::span(layout.triangleUvs)));
    return {folder() / "flows", std::move(hashes), settings.hex()};
}

} // namespace quadrille
