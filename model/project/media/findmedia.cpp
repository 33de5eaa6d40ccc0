// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/findmedia.h"

#include "model/core/error.h"
#include "model/sequence/io/files/sourcefiles.h"

#include <algorithm>
#include <set>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

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

/// Where a medium is when it went the way of another.
fs::path onTheSameWay(const fs::path& medium, fs::path from, fs::path to)
{
    do {
        from = from.parent_path();
        to = to.parent_path();
    } while (from.has_relative_path() && to.has_relative_path() && from.filename() == to.filename());
    return (to / medium.lexically_relative(from)).lexically_normal();
}

/// One medium that is looked for, and what may be it.
struct Wanted
{
    std::string path;
    fs::path name;
    const MediaContent* known = nullptr;
    std::vector<fs::path> namesakes;
    std::vector<fs::path> sameSize; ///< of another name
};

class MediaFinder
{
public:
    MediaFinder(const MediaSearch& search, const Progress& progress) : m_search(search), m_progress(progress)
    {
        m_wanted.reserve(search.paths.size()); // the maps point into it
        for (const std::string& path : search.paths) {
            Wanted& wanted = m_wanted.emplace_back();
            wanted.path = path;
            wanted.name = fs::path(path).filename();
            if (const auto known = search.known.find(path); known != search.known.end())
                wanted.known = &known->second;
            if (isPattern(wanted.name)) {
                m_patterns[wanted.name.string()].push_back(&wanted);
                continue;
            }
            m_byName[wanted.name.string()].push_back(&wanted);
            if (wanted.known != nullptr)
                m_bySize[wanted.known->bytes].push_back(&wanted);
        }
    }

    std::vector<FoundMedium> run()
    {
        std::error_code error;
        if (!fs::is_directory(m_search.folder, error))
            throw Error(ErrorCode::FileNotFound, {m_search.folder, {}, {}});
        followExample();
        walk(m_search.folder);
        std::vector<FoundMedium> found;
        for (Wanted& wanted : m_wanted) {
            m_progress.report(static_cast<std::int64_t>(found.size()),
                              static_cast<std::int64_t>(m_wanted.size()));
            found.push_back(best(wanted));
        }
        return found;
    }

    /// Whether a file, folder or pattern is what it shall be.
    MediaMatch compare(const Wanted& wanted, const fs::path& file)
    {
        const bool hasName = file.filename() == wanted.name;
        if (wanted.known == nullptr)
            return MediaMatch::Name;
        if (!isContent(file, *wanted.known))
            return MediaMatch::OtherContent;
        return hasName ? MediaMatch::NameAndContent : MediaMatch::Content;
    }

    const Wanted& first() const { return m_wanted.front(); }

private:
    void followExample()
    {
        if (!m_search.example)
            return;
        for (Wanted& wanted : m_wanted) {
            const fs::path file =
                onTheSameWay(wanted.path, m_search.example->first, m_search.example->second);
            if (mediumExists(file))
                wanted.namesakes.push_back(file);
        }
    }

    void walk(const fs::path& folder)
    {
        std::uintmax_t bytes = 0;
        std::vector<fs::path> subfolders;
        std::error_code error;
        for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
             entry.increment(error)) {
            m_progress.report(0);
            std::error_code unreadable;
            const bool isFile = entry->is_regular_file(unreadable);
            const bool isFolder = !isFile && entry->is_directory(unreadable);
            if (isFile) {
                const std::uintmax_t size = entry->file_size(unreadable);
                bytes += unreadable ? 0 : size;
                offerName(entry->path());
                offerContent(entry->path(), unreadable ? 0 : size);
            } else if (isFolder) {
                offerName(entry->path());
                if (!entry->is_symlink(unreadable))
                    subfolders.push_back(entry->path());
            }
        }
        if (bytes > 0)
            offerContent(folder, bytes);
        offerSeries(folder);
        std::sort(subfolders.begin(), subfolders.end());
        for (const fs::path& subfolder : subfolders)
            walk(subfolder);
    }

    void offerName(const fs::path& path)
    {
        if (const auto wanted = m_byName.find(path.filename().string()); wanted != m_byName.end()) {
            for (Wanted* each : wanted->second)
                each->namesakes.push_back(path);
        }
    }

    void offerContent(const fs::path& path, std::uintmax_t bytes)
    {
        if (const auto wanted = m_bySize.find(bytes); wanted != m_bySize.end()) {
            for (Wanted* each : wanted->second) {
                if (each->name != path.filename())
                    each->sameSize.push_back(path);
            }
        }
    }

    void offerSeries(const fs::path& folder)
    {
        for (const auto& [name, wanted] : m_patterns) {
            if (!mediumExists(folder / name))
                continue;
            for (Wanted* each : wanted)
                each->namesakes.push_back(folder / name);
        }
    }

    FoundMedium best(Wanted& wanted)
    {
        FoundMedium found{wanted.path, {}, MediaMatch::Missing, false};
        std::stable_sort(wanted.namesakes.begin(), wanted.namesakes.end(),
                         [&](const fs::path& a, const fs::path& b) {
                             return sameEnding(a, wanted.path) > sameEnding(b, wanted.path);
                         });
        for (const auto* candidates : {&wanted.namesakes, &wanted.sameSize}) {
            for (const fs::path& candidate : *candidates) {
                const MediaMatch match = compare(wanted, candidate);
                const bool mayStand = match > MediaMatch::OtherContent || candidates == &wanted.namesakes;
                if (mayStand && match > found.match)
                    found = {wanted.path, candidate, match, false};
                if (found.match >= MediaMatch::Content)
                    return found;
            }
        }
        const std::set<fs::path> different(wanted.namesakes.begin(), wanted.namesakes.end());
        found.isAmbiguous = found.match == MediaMatch::Name && different.size() > 1;
        return found;
    }

    bool isContent(const fs::path& medium, const MediaContent& known)
    {
        const std::vector<fs::path> files = filesOfMedium(medium);
        std::uintmax_t bytes = 0;
        for (const fs::path& file : files) {
            std::error_code error;
            const std::uintmax_t size = fs::file_size(file, error);
            bytes += error ? 0 : size;
        }
        if (files.empty() || bytes != known.bytes)
            return false;
        try {
            return contentOf(files, m_hashes, m_progress) == known;
        } catch (const Error& failure) {
            if (failure.code() == ErrorCode::Cancelled)
                throw;
            return false;
        }
    }

    const MediaSearch& m_search;
    const Progress& m_progress;
    std::vector<Wanted> m_wanted;
    std::map<std::string, std::vector<Wanted*>> m_byName; ///< without patterns
    std::map<std::string, std::vector<Wanted*>> m_patterns;
    std::map<std::uintmax_t, std::vector<Wanted*>> m_bySize;
    FileHashes m_hashes;
};

} // namespace

std::vector<FoundMedium> findMedia(const MediaSearch& search, const Progress& progress)
{
    return search.paths.empty() ? std::vector<FoundMedium>() : MediaFinder(search, progress).run();
}

FoundMedium examineMedium(const std::string& path, const fs::path& chosen, const KnownMedia& known,
                          const Progress& progress)
{
    if (!mediumExists(chosen))
        return {path, {}, MediaMatch::Missing, false};
    MediaSearch search;
    search.paths = {path};
    search.known = known;
    MediaFinder finder(search, progress);
    return {path, chosen, finder.compare(finder.first(), chosen), false};
}

} // namespace quadrille
