// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/findtextures.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/mesh/mtl.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string>& imageExtensions()
{
    static const std::vector<std::string> extensions{".png", ".jpg", ".jpeg", ".tif", ".tiff"};
    return extensions;
}

bool isImage(const fs::path& path)
{
    const auto& known = imageExtensions();
    std::error_code error;
    return std::find(known.begin(), known.end(), lowerExtension(path)) != known.end() &&
           fs::is_regular_file(path, error);
}

bool isFolder(const fs::path& path)
{
    std::error_code error;
    return fs::is_directory(path, error);
}

TextureSet setOf(const std::vector<fs::path>& files)
{
    std::vector<Texture> textures;
    textures.reserve(files.size());
    for (const auto& file : files)
        textures.push_back({file, nullptr});
    return TextureSet::perFrame(std::move(textures));
}

/// All pictures of a folder in natural order; preview pictures and masks have other names than numbers only
/// where a series is there, so the longest series wins.
std::vector<fs::path> imagesIn(const fs::path& folder)
{
    const auto content = scanFolder(folder, imageExtensions());
    const auto longest = std::max_element(
        content.series.begin(), content.series.end(),
        [](const SourceFiles& a, const SourceFiles& b) { return a.files.size() < b.files.size(); });
    if (longest != content.series.end())
        return longest->files;
    std::vector<fs::path> files;
    for (const auto& single : content.singles)
        files.push_back(single.files.front());
    return files;
}

/// The pictures of a series beside the take that bear the numbers of its files; empty unless all are there.
std::vector<fs::path> imagesByNumber(const SourceFiles& images, const SourceFiles& take)
{
    std::vector<fs::path> files;
    for (const auto number : take.numbers) {
        const auto at = std::lower_bound(images.numbers.begin(), images.numbers.end(), number);
        if (at == images.numbers.end() || *at != number)
            return {};
        files.push_back(images.files[static_cast<std::size_t>(at - images.numbers.begin())]);
    }
    return files;
}

[[noreturn]] void throwCount(const fs::path& path, std::size_t found, std::int64_t expected)
{
    throw Error(ErrorCode::ImageCountMismatch,
                {path, {}, {{"found", std::to_string(found)}, {"expected", std::to_string(expected)}}});
}

TextureSet texturesNamedByUser(const TextureSearch& search)
{
    if (isImage(search.named))
        return TextureSet::single({search.named, nullptr});
    std::error_code error;
    if (fs::is_regular_file(search.named, error))
        throw Error(ErrorCode::ImageUnreadable, {search.named, {}, {}});
    const auto files = isFolder(search.named) ? imagesIn(search.named) : findPattern(search.named).files;
    if (static_cast<std::int64_t>(files.size()) == search.frameCount)
        return setOf(files);
    if (files.size() == 1)
        return TextureSet::single({files.front(), nullptr});
    throwCount(search.named, files.size(), search.frameCount);
}

/// Folders that may hold the textures of a take, the most special first.
std::vector<fs::path> textureFolders(const SourceFiles& take)
{
    const fs::path folder = take.files.front().parent_path();
    const fs::path name = take.isSeries() ? folder.filename() : fs::path(take.stem);
    std::vector<fs::path> folders{folder / "textures" / take.stem};
    if (take.isSeries()) {
        folders.push_back(folder / "textures");
        folders.push_back(folder.parent_path() / "textures" / name);
    }
    return folders;
}

} // namespace

FoundTextures findTextures(const TextureSearch& search)
{
    if (!search.named.empty())
        return {texturesNamedByUser(search), {}};
    FoundTextures found{search.ofMesh, {}};
    for (const auto& folder : textureFolders(search.take)) {
        if (!isFolder(folder))
            continue;
        const auto files = imagesIn(folder);
        if (static_cast<std::int64_t>(files.size()) == search.frameCount)
            return {setOf(files), {}};
        if (!files.empty()) {
            found.issues.push_back({.code = Issue::Code::TextureCountDiffers,
                                    .context = {search.take.path,
                                                {},
                                                {{"found", std::to_string(files.size())},
                                                 {"path", folder.string()},
                                                 {"expected", std::to_string(search.frameCount)}}}});
        }
    }
    if (!search.take.isSeries())
        return found;
    for (const auto& images : scanFolder(search.take.files.front().parent_path(), imageExtensions()).series) {
        if (const auto files = imagesByNumber(images, search.take); !files.empty())
            return {setOf(files), std::move(found.issues)};
    }
    return found;
}

FoundTextures texturesNamedBy(const MeshFile& mesh, const fs::path& file)
{
    const fs::path folder = file.parent_path();
    FoundTextures found;
    const auto missing = [&](const std::string& name) {
        found.issues.push_back(
            {.code = Issue::Code::TextureMissing, .context = {file, {}, {{"path", name}}}});
    };
    std::vector<std::string> names = mesh.textures;
    if (!mesh.materialLibraries.empty()) {
        std::map<std::string, std::string> maps;
        for (const auto& library : mesh.materialLibraries) {
            const fs::path path = resolveNamedFile(folder, library);
            if (path.empty())
                missing(library);
            else
                maps.merge(readColourMaps(readFile(path).text()));
        }
        for (const auto& material : mesh.topology.materials) {
            const auto map = maps.find(material);
            names.push_back(map == maps.end() ? std::string() : map->second);
        }
        // A mesh that uses no material still means the only picture of its library.
        if (mesh.topology.materials.empty() && maps.size() == 1)
            names.push_back(maps.begin()->second);
    }
    std::vector<Texture> textures;
    for (const auto& name : names) {
        textures.push_back({name.empty() ? fs::path() : resolveNamedFile(folder, name), nullptr});
        if (!name.empty() && textures.back().isEmpty())
            missing(name);
    }
    const bool any =
        std::any_of(textures.begin(), textures.end(), [](const Texture& t) { return !t.isEmpty(); });
    if (any) {
        found.textures = textures.size() == 1 ? TextureSet::single(std::move(textures.front()))
                                              : TextureSet::perMaterial(std::move(textures));
        return found;
    }
    for (const fs::path& stem : {file.stem(), fs::path("texture")}) {
        for (const auto& extension : imageExtensions()) {
            const fs::path beside = folder / (stem.string() + extension);
            if (isImage(beside)) {
                found.textures = TextureSet::single({beside, nullptr});
                return found;
            }
        }
    }
    return found;
}

} // namespace quadrille
