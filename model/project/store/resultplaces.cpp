// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/resultplaces.h"

#include "model/core/contenthash.h"
#include "model/core/file.h"
#include "model/core/message.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>
#include <unistd.h>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// What this process knows of places.
struct Known
{
    std::mutex mutex;
    std::map<fs::path, fs::path> chosen; ///< by project file
    std::map<fs::path, fs::path> owners; ///< project files, by folder of results
    std::set<fs::path> unusable;         ///< folders that could not be written when it was tried
    fs::path root;
};

Known& known()
{
    static Known known;
    return known;
}

fs::path usualRoot()
{
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr ? fs::path(value) : fs::path();
    };
    fs::path cache = variable("XDG_CACHE_HOME");
    if (!cache.is_absolute() && variable("HOME").is_absolute())
        cache = variable("HOME") / ".cache";
    std::error_code error;
    if (!cache.is_absolute())
        cache = fs::temp_directory_path(error);
    return cache / "quadrille" / "results";
}

fs::path absoluteOf(const fs::path& file)
{
    return fs::absolute(file).lexically_normal();
}

fs::path besideOf(const fs::path& projectFile)
{
    fs::path folder = projectFile;
    folder += ".cache";
    return folder;
}

/// A folder of its own for each project, by its path.
fs::path standInOf(const fs::path& projectFile, const fs::path& root)
{
    ContentHasher hasher;
    hasher.add(projectFile.string());
    constexpr std::size_t digits = 16;
    return root / (projectFile.stem().string() + "-" + hasher.hex().substr(0, digits));
}

/// Whether it looks as if files could be made in a folder, or the folder itself. Changes nothing.
bool seemsWritable(fs::path folder)
{
    std::error_code error;
    while (!fs::exists(fs::symlink_status(folder, error)) && folder.has_relative_path())
        folder = folder.parent_path();
    return fs::is_directory(folder, error) && ::access(folder.c_str(), W_OK | X_OK) == 0;
}

/// All places of a project, the one that it should have first. \pre The registry is locked.
std::vector<fs::path> placesOf(const fs::path& projectFile)
{
    std::vector<fs::path> places;
    if (const auto chosen = known().chosen.find(projectFile); chosen != known().chosen.end())
        places.push_back(chosen->second);
    places.push_back(besideOf(projectFile));
    places.push_back(standInOf(projectFile, known().root.empty() ? usualRoot() : known().root));
    for (const fs::path& place : places)
        known().owners[place] = projectFile;
    return places;
}

std::string sizeText(std::uint64_t bytes)
{
    constexpr std::uint64_t megabyte = 1'000'000;
    return std::to_string((bytes + megabyte - 1) / megabyte) + " MB";
}

/// Writes a file to try.
/// \throws Error why nothing can be stored there.
void tryPlace(const fs::path& folder, std::uint64_t bytes)
{
    std::error_code error;
    const bool wasThere = fs::exists(folder, error);
    const fs::path probe = folder / (".try-" + std::to_string(::getpid()));
    try {
        writeAtomically(probe, "Quadrille tries whether this folder can be written.\n");
    } catch (...) {
        if (!wasThere)
            fs::remove(folder, error);
        throw;
    }
    fs::remove(probe, error);
    const fs::space_info space = fs::space(folder, error);
    if (error || space.available >= bytes)
        return;
    if (!wasThere)
        fs::remove(folder, error);
    throw Error(ErrorCode::BadArgument,
                {folder,
                 {},
                 {{"reason", "The results will take about " + sizeText(bytes) + ", and only " +
                                 sizeText(space.available) + " are free on this disk"},
                  {"remedy", QUADRILLE_MESSAGE("Free some space, or choose another folder for results.")}}});
}

} // namespace

ResultPlaces resultPlaces(const fs::path& projectFile)
{
    const fs::path file = absoluteOf(projectFile);
    const std::scoped_lock lock(known().mutex);
    std::vector<fs::path> places = placesOf(file);
    const auto usable = std::find_if(places.begin(), places.end(), [](const fs::path& place) {
        return known().unusable.count(place) == 0 && seemsWritable(place);
    });
    const auto written = usable == places.end() ? places.begin() : usable;
    ResultPlaces found{.written = *written, .others = {}, .isElsewhere = written != places.begin()};
    places.erase(written);
    found.others = std::move(places);
    return found;
}

fs::path cacheFolder(const fs::path& projectFile)
{
    return resultPlaces(projectFile).written;
}

void chooseResultFolder(const fs::path& projectFile, const fs::path& folder)
{
    const std::scoped_lock lock(known().mutex);
    if (folder.empty())
        known().chosen.erase(absoluteOf(projectFile));
    else
        known().chosen[absoluteOf(projectFile)] = absoluteOf(folder);
}

void setResultRoot(const fs::path& folder)
{
    const std::scoped_lock lock(known().mutex);
    known().root = folder.empty() ? fs::path() : absoluteOf(folder);
}

fs::path resultRoot()
{
    const std::scoped_lock lock(known().mutex);
    return known().root.empty() ? usualRoot() : known().root;
}

void prepareResults(const fs::path& projectFile, std::uint64_t bytes)
{
    const auto places = [&] {
        const std::scoped_lock lock(known().mutex);
        return placesOf(absoluteOf(projectFile));
    }();
    std::optional<Error> first;
    for (const fs::path& place : places) {
        try {
            tryPlace(place, bytes);
            const std::scoped_lock lock(known().mutex);
            known().unusable.erase(place);
            return;
        } catch (const Error& error) {
            if (!first)
                first = error;
            const std::scoped_lock lock(known().mutex);
            known().unusable.insert(place);
        }
    }
    throw Error(*first);
}

void recheckResultPlaces(const fs::path& projectFile)
{
    std::vector<fs::path> suspects;
    {
        const std::scoped_lock lock(known().mutex);
        suspects = placesOf(absoluteOf(projectFile));
        std::erase_if(suspects, [](const fs::path& place) { return known().unusable.count(place) == 0; });
    }
    for (const fs::path& place : suspects) {
        std::error_code error;
        const bool wasThere = fs::exists(place, error);
        try {
            tryPlace(place, 0);
        } catch (const Error&) {
            continue;
        }
        if (!wasThere)
            fs::remove(place, error);
        const std::scoped_lock lock(known().mutex);
        known().unusable.erase(place);
    }
}

fs::path nextResultFolder(const fs::path& folder)
{
    fs::path owner;
    {
        const std::scoped_lock lock(known().mutex);
        const auto found = known().owners.find(folder);
        if (found == known().owners.end())
            return {};
        owner = found->second;
        known().unusable.insert(folder);
    }
    const fs::path next = resultPlaces(owner).written;
    const std::scoped_lock lock(known().mutex);
    return known().unusable.count(next) == 0 ? next : fs::path();
}

std::vector<fs::path> otherResultFolders(const fs::path& folder)
{
    const std::scoped_lock lock(known().mutex);
    const auto found = known().owners.find(folder);
    if (found == known().owners.end())
        return {};
    const fs::path owner = found->second;
    std::vector<fs::path> places = placesOf(owner);
    std::erase(places, folder);
    return places;
}

} // namespace quadrille
