// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media.h"

#include "model/core/contenthash.h"
#include "model/core/file.h"
#include "model/project/jsontext.h"
#include "model/project/paths.h"
#include "model/sequence/io/sourcefiles.h"

#include <algorithm>
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
}

bool mediaExists(const fs::path& file)
{
    std::error_code error;
    if (!isPattern(file))
        return fs::exists(file, error);
    try {
        return !findPattern(file).files.empty();
    } catch (const Error&) {
        return false;
    }
}

/// All files and folders below a folder, in a fixed order.
std::vector<fs::path> everythingBelow(const fs::path& folder, const Progress& progress)
{
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw Error(ErrorCode::FileNotFound, {folder, {}, {}});
    std::vector<fs::path> found;
    constexpr auto options = fs::directory_options::skip_permission_denied;
    for (auto entry = fs::recursive_directory_iterator(folder, options, error);
         entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        progress.report(0);
        found.push_back(entry->path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// How many last parts of two paths are the same.
std::size_t sameEnding(const fs::path& a, const fs::path& b)
{
    std::size_t same = 0;
    auto partA = a.end();
    auto partB = b.end();
    while (partA != a.begin() && partB != b.begin() && *--partA == *--partB)
        ++same;
    return same;
}

class Relinker
{
public:
    Relinker(std::vector<fs::path> candidates, const KnownHashes& known, const Progress& progress)
        : m_candidates(std::move(candidates)), m_known(known), m_progress(progress)
    {
    }

    /// Where a medium is now; empty when it was not found.
    fs::path find(const std::string& stored, RelinkReport& report)
    {
        if (isPattern(stored))
            return findSeries(stored);
        const fs::path name = fs::path(stored).filename();
        std::vector<fs::path> namesakes;
        std::copy_if(m_candidates.begin(), m_candidates.end(), std::back_inserter(namesakes),
                     [&](const fs::path& candidate) { return candidate.filename() == name; });
        if (const auto hash = m_known.find(stored); hash != m_known.end()) {
            for (const auto* list : {&namesakes, &m_candidates}) {
                for (const fs::path& candidate : *list) {
                    if (hashOf(candidate) == hash->second)
                        return candidate;
                }
            }
        }
        if (namesakes.empty())
            return {};
        if (namesakes.size() > 1)
            report.ambiguous.push_back(stored);
        return *std::max_element(namesakes.begin(), namesakes.end(),
                                 [&](const fs::path& a, const fs::path& b) {
                                     return sameEnding(a, stored) < sameEnding(b, stored);
                                 });
    }

private:
    fs::path findSeries(const fs::path& pattern) const
    {
        for (const fs::path& candidate : m_candidates) {
            std::error_code error;
            fs::path moved = candidate / pattern.filename();
            if (fs::is_directory(candidate, error) && mediaExists(moved))
                return moved;
        }
        return {};
    }

    const std::string& hashOf(const fs::path& file)
    {
        const auto [entry, isNew] = m_hashes.try_emplace(file);
        std::error_code error;
        if (isNew && fs::is_regular_file(file, error)) {
            try {
                entry->second = hashFile(file, m_progress);
            } catch (const Error& failure) {
                if (failure.code() == ErrorCode::Cancelled)
                    throw;
            }
        }
        return entry->second;
    }

    std::vector<fs::path> m_candidates;
    const KnownHashes& m_known;
    const Progress m_progress;
    std::map<fs::path, std::string> m_hashes;
};

} // namespace

std::vector<MediaUse> mediaOf(const Project& project, const fs::path& folder)
{
    std::vector<MediaUse> media;
    visitMedia(project, [&](const std::string& path, const std::string& owner, const std::string& pointer) {
        if (path.empty())
            return;
        const fs::path file = resolvePath(path, folder);
        media.push_back({owner, pointer, path, file, mediaExists(file)});
    });
    return media;
}

RelinkReport relinkMedia(Project& project, const fs::path& projectFolder, const fs::path& searchFolder,
                         const KnownHashes& known, const Progress& progress)
{
    std::set<std::string> lost;
    for (const MediaUse& use : mediaOf(project, projectFolder)) {
        if (!use.exists)
            lost.insert(use.path);
    }
    RelinkReport report;
    if (lost.empty())
        return report;
    Relinker relinker(everythingBelow(searchFolder, progress), known, Progress(progress.token()));
    std::map<std::string, std::string> moves;
    std::int64_t done = 0;
    for (const std::string& stored : lost) {
        progress.report(done++, static_cast<std::int64_t>(lost.size()));
        const fs::path found = relinker.find(stored, report);
        if (found.empty()) {
            report.missing.push_back(stored);
            continue;
        }
        moves[stored] = storedPath(found, projectFolder);
        report.moved.push_back({stored, moves[stored]});
    }
    visitMedia(project, [&](std::string& path, const std::string&, const std::string&) {
        if (const auto move = moves.find(path); move != moves.end())
            path = move->second;
    });
    return report;
}

KnownHashes hashMedia(const Project& project, const fs::path& folder, FileHashes& hashes,
                      const Progress& progress)
{
    KnownHashes known;
    for (const MediaUse& use : mediaOf(project, folder)) {
        std::error_code error;
        if (fs::is_regular_file(use.file, error))
            known[use.path] = hashes.of(use.file, progress);
    }
    return known;
}

KnownHashes readMediaHashes(const fs::path& cacheFolder)
{
    const fs::path file = cacheFolder / "media.json";
    std::error_code error;
    if (!fs::exists(file, error))
        return {};
    try {
        return parseJson(readFile(file).text(), file).document.get<KnownHashes>();
    } catch (const Error&) {
        return {};
    } catch (const Json::exception&) {
        return {};
    }
}

void writeMediaHashes(const KnownHashes& known, const fs::path& cacheFolder)
{
    writeAtomically(cacheFolder / "media.json", writeJson(Json(known)));
}

} // namespace quadrille
