// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/appearancework.h"

#include "model/core/contenthash.h"
#include "model/core/file.h"
#include "model/core/imagecoding.h"
#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"
#include "model/project/store/resultplaces.h"

#include <system_error>

namespace quadrille {

namespace {

constexpr auto flowsFolder = "flows";

/// Tells apart what textures show: the same file shows something else once its mark of colours is followed.
std::string contentOf(const Texture& texture, const Progress& progress)
{
    if (texture.file.empty()) {
        ContentHasher hasher;
        hasher.addBytes(std::as_bytes(std::span(texture.load()->pixels)));
        return hasher.hex();
    }
    std::string content = hashFile(texture.file, progress);
    if (texture.marks == ColourMarks::Followed) {
        if (const auto exponent = codingExponent(readFile(texture.file).bytes()))
            content += " " + std::to_string(*exponent);
    }
    return content;
}

} // namespace

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
        hashes.push_back(contentOf(texture, progress));
    }
    const TopologyData& layout = training.topology->data();
    const BuildAppearanceOptions usual = options();
    constexpr std::int64_t version = 2; // raised where the same textures get other flows
    ContentHasher settings;
    settings.add(version);
    settings.add(std::int64_t{usual.gutter});
    settings.add(std::int64_t{usual.alignment.spacing});
    settings.addBytes(std::as_bytes(std::span(layout.uvs)));
    settings.addBytes(std::as_bytes(std::span(layout.triangleUvs)));
    // An entry that was renamed finds what it computed under its name of before.
    std::vector<std::filesystem::path> others;
    std::error_code error;
    for (const auto& each : std::filesystem::directory_iterator(folder().parent_path().parent_path(), error))
        others.push_back(each.path() / folder().filename() / flowsFolder);
    return {folder() / flowsFolder, std::move(hashes), settings.hex(), std::move(others)};
}

} // namespace quadrille
