// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media.h"

#include "model/core/error.h"
#include "model/project/buildstep.h"
#include "model/project/paths.h"

#include <map>
#include <set>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Calls `visit(path, owner, pointer)` with every media path of a project; paths may be changed.
template <typename ProjectType, typename Visit>
void visitMedia(ProjectType& project, const Visit& visit)
{
    const auto visitTexture = [&](auto& texture, const std::string& owner, const std::string& pointer) {
        for (auto& path : texture.paths)
            visit(path, owner, pointer + "/texture");
    };
    for (std::size_t i = 0; i < project.characters.size(); ++i) {
        auto& character = project.characters[i];
        const std::string owner = "characters/" + character.name;
        const std::string pointer = "/characters/" + std::to_string(i);
        visit(character.mesh, owner, pointer + "/mesh");
        visitTexture(character.texture, owner, pointer);
    }
    for (std::size_t i = 0; i < project.sequences.size(); ++i) {
        auto& sequence = project.sequences[i];
        const std::string owner = "sequences/" + sequence.name;
        const std::string pointer = "/sequences/" + std::to_string(i);
        if (!clipOfSource(sequence.source))
            visit(sequence.source, owner, pointer + "/source");
        visitTexture(sequence.texture, owner, pointer);
        visit(sequence.jointAngles, owner, pointer + "/joint_angles");
    }
    for (std::size_t i = 0; i < project.animations.size(); ++i) {
        auto& animation = project.animations[i];
        if (animation.audio)
            visit(animation.audio->file, "animations/" + animation.name,
                  "/animations/" + std::to_string(i) + "/audio/file");
    }
}

} // namespace

std::vector<MediaUse> mediaOf(const Project& project, const fs::path& folder)
{
    std::vector<MediaUse> media;
    visitMedia(project, [&](const std::string& path, const std::string& owner, const std::string& pointer) {
        if (path.empty())
            return;
        const fs::path file = resolvePath(path, folder);
        media.push_back({owner, pointer, path, file, mediumExists(file)});
    });
    return media;
}

KnownMedia contentsOfMedia(const Project& project, const fs::path& folder, FileHashes& hashes,
                           const Progress& progress)
{
    KnownMedia known;
    const std::vector<MediaUse> media = mediaOf(project, folder);
    std::int64_t done = 0;
    for (const MediaUse& use : media) {
        progress.report(done++, static_cast<std::int64_t>(media.size()));
        const std::vector<fs::path> files = filesOfMedium(use.file);
        if (files.empty() || known.contains(use.path))
            continue;
        try {
            known[use.path] = contentOf(files, hashes, Progress(progress.token()));
        } catch (const Error& error) {
            if (error.code() == ErrorCode::Cancelled)
                throw;
        }
    }
    return known;
}

void noteMedia(const Project& project, const fs::path& projectFile, const Progress& progress)
{
    const fs::path cache = cacheFolder(projectFile);
    FileHashes hashes(cache / "hashes.json");
    KnownMedia known = contentsOfMedia(project, projectFolder(projectFile), hashes, progress);
    const KnownMedia before = readKnownMedia(cache);
    known.insert(before.begin(), before.end());
    if (known != before)
        writeKnownMedia(known, cache);
    hashes.save();
}

RelinkReport relinkMedia(Project& project, const fs::path& projectFolder, const fs::path& searchFolder,
                         const KnownMedia& known, const Progress& progress)
{
    std::set<std::string> lost;
    for (const MediaUse& use : mediaOf(project, projectFolder)) {
        if (!use.exists)
            lost.insert(use.path);
    }
    const MediaSearch search{{lost.begin(), lost.end()}, known, searchFolder, std::nullopt};
    RelinkReport report;
    std::map<std::string, std::string> moves;
    for (const FoundMedium& found : findMedia(search, progress)) {
        if (found.match == MediaMatch::Missing) {
            report.missing.push_back(found.path);
        } else if (found.match == MediaMatch::OtherContent) {
            report.different.push_back(found);
        } else {
            moves[found.path] = storedPath(found.file, projectFolder);
            report.moved.push_back({found.path, moves[found.path]});
        }
        if (found.isAmbiguous)
            report.ambiguous.push_back(found.path);
    }
    visitMedia(project, [&](std::string& path, const std::string&, const std::string&) {
        if (const auto move = moves.find(path); move != moves.end())
            path = move->second;
    });
    return report;
}

} // namespace quadrille
