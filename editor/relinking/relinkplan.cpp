// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/relinking/relinkplan.h"

#include "model/core/error.h"
#include "model/project/media/importsurvey.h"
#include "model/project/store/resultplaces.h"
#include "model/sequence/io/files/sourcefiles.h"

#include <algorithm>
#include <array>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// The series that a file belongs to, as a pattern: with the name that was used so far where that fits.
fs::path seriesOf(const fs::path& file, const fs::path& lost)
{
    const fs::path folder = fs::is_directory(file) ? file : file.parent_path();
    if (mediumExists(folder / lost.filename()))
        return folder / lost.filename();
    try {
        const FoundSources found = findSources(std::array{file});
        return found.sources.size() == 1 ? found.sources.front() : file;
    } catch (const Error&) {
        return file;
    }
}

} // namespace

bool LostMedium::isFolder() const
{
    return !isPattern(path) && !fs::path(path).has_extension();
}

void RelinkPlan::take(const std::vector<FoundMedium>& found)
{
    for (const FoundMedium& each : found) {
        const auto medium = std::ranges::find(media, each.path, &LostMedium::path);
        if (medium == media.end() || medium->isByHand || each.match == MediaMatch::Missing ||
            each.match < medium->found.match)
            continue;
        medium->found = each;
        medium->isWanted = each.match > MediaMatch::OtherContent;
    }
}

void RelinkPlan::takeByHand(std::size_t medium, const FoundMedium& chosen)
{
    LostMedium& lost = media.at(medium);
    lost.found = chosen;
    lost.isByHand = lost.isFound();
    lost.isWanted = lost.isFound();
}

MediaSearch RelinkPlan::searchIn(const fs::path& folder) const
{
    MediaSearch search;
    search.known = known;
    search.folder = folder;
    for (const LostMedium& medium : media) {
        if (!medium.isByHand)
            search.paths.push_back(medium.path);
    }
    return search;
}

std::size_t RelinkPlan::foundCount() const
{
    return static_cast<std::size_t>(std::ranges::count_if(media, &LostMedium::isFound));
}

std::vector<std::pair<std::string, std::string>> RelinkPlan::newPaths() const
{
    std::vector<std::pair<std::string, std::string>> paths;
    for (const LostMedium& medium : media) {
        if (medium.isWanted && medium.isFound())
            paths.emplace_back(medium.path, medium.found.file.lexically_normal().generic_string());
    }
    return paths;
}

std::vector<MediaUse> missingMedia(const Project& project)
{
    std::vector<MediaUse> media = mediaOf(project, {});
    std::erase_if(media, &MediaUse::exists);
    return media;
}

RelinkPlan planRelinking(const Project& project, const fs::path& projectFile)
{
    RelinkPlan plan;
    for (const MediaUse& use : missingMedia(project)) {
        auto medium = std::ranges::find(plan.media, use.path, &LostMedium::path);
        if (medium == plan.media.end()) {
            medium = plan.media.insert(medium, LostMedium{use.path, {}, {}, false, false});
            medium->found.path = use.path;
        }
        medium->uses.push_back(use);
    }
    if (projectFile.empty())
        return plan;
    const fs::path folder = projectFile.parent_path();
    for (const auto& [path, content] : readKnownMedia(cacheFolder(projectFile)))
        plan.known[(folder / path).lexically_normal().generic_string()] = content;
    return plan;
}

ChosenMedium examineChoice(const RelinkPlan& plan, std::size_t medium, const fs::path& file,
                           const Progress& progress)
{
    const LostMedium& lost = plan.media.at(medium);
    const fs::path meant = isPattern(lost.path) ? seriesOf(file, lost.path) : file;
    ChosenMedium result;
    result.chosen = examineMedium(lost.path, meant, plan.known, progress.part(0, 0.2));
    if (result.chosen.match == MediaMatch::Missing)
        return result;
    MediaSearch search = plan.searchIn(meant.parent_path());
    std::erase(search.paths, lost.path);
    search.example = {lost.path, meant};
    result.others = findMedia(search, progress.part(0.2, 1));
    return result;
}

} // namespace quadrille
