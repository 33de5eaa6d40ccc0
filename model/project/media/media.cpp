// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/media.h"

#include "model/core/error.h"
#include "model/project/document/paths.h"
#include "model/project/fields/entrypaths.h"
#include "model/project/store/resultplaces.h"

#include <functional>
#include <map>
#include <set>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Calls a function with every media path of a project; paths may be changed.
void forEachMedium(Project& project, const std::function<void(const StoredPath&)>& visit)
{
    forEachPath(project, [&](const StoredPath& stored) {
        if (!stored.isOutput)
            visit(stored);
    });
}

} // namespace

std::vector<MediaUse> mediaOf(const Project& project, const fs::path& folder)
{
    std::vector<MediaUse> media;
    Project named = project;
    forEachMedium(named, [&](const StoredPath& stored) {
        if (stored.path.empty())
            return;
        const fs::path file = resolvePath(stored.path, folder);
        media.push_back({stored.owner, stored.pointer, stored.path, file, mediumExists(file)});
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
    forEachMedium(project, [&](const StoredPath& stored) {
        if (const auto move = moves.find(stored.path); move != moves.end())
            stored.path = move->second;
    });
    return report;
}

} // namespace quadrille
