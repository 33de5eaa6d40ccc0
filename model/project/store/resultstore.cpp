// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/resultstore.h"

#include "model/core/error.h"
#include "model/project/store/resultplaces.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// A result that could not be stored.
struct Unstored
{
    fs::path folder; ///< where it was to go
    std::string step;
    std::string key;
    std::shared_ptr<const Result> result;
};

struct Memory
{
    std::mutex mutex;
    std::map<fs::path, Unstored> results; ///< by the file that it was to be
};

Memory& memory()
{
    static Memory memory;
    return memory;
}

fs::path fileIn(const fs::path& folder, const std::string& step)
{
    return folder / (step + ".h5");
}

std::optional<Unstored> inMemory(const std::vector<fs::path>& folders, const std::string& step)
{
    const std::scoped_lock lock(memory().mutex);
    for (const fs::path& folder : folders) {
        if (const auto found = memory().results.find(fileIn(folder, step)); found != memory().results.end())
            return found->second;
    }
    return std::nullopt;
}

void forget(const std::vector<fs::path>& folders, const std::string& step)
{
    const std::scoped_lock lock(memory().mutex);
    for (const fs::path& folder : folders)
        memory().results.erase(fileIn(folder, step));
}

/// The folder first, then the other places of its project.
std::vector<fs::path> placesWith(const fs::path& folder)
{
    std::vector<fs::path> places{folder};
    for (fs::path& other : otherResultFolders(folder))
        places.push_back(std::move(other));
    return places;
}

/// Places that have a file of a step, the newest file first; of two alike the earlier place.
std::vector<fs::path> newestFirst(const std::vector<fs::path>& places, const std::string& step)
{
    std::multimap<fs::file_time_type, fs::path, std::greater<>> found;
    for (const fs::path& place : places) {
        std::error_code error;
        const fs::file_time_type time = fs::last_write_time(fileIn(place, step), error);
        if (!error)
            found.emplace(time, place);
    }
    std::vector<fs::path> sorted;
    for (auto& [time, place] : found)
        sorted.push_back(place);
    return sorted;
}

ResultStore::Entry loadFile(const fs::path& file, const std::string& step, const std::string& key,
                            ResultMemory* memory)
{
    try {
        const ResultHeader header = readResultHeader(file);
        auto result = std::make_shared<const Result>(readResultFile(file));
        if (memory != nullptr && header.step == step)
            memory->note(file, header.key, *result);
        const bool fits = header.key == key && header.step == step;
        return {fits ? ResultStore::State::Fresh : ResultStore::State::OtherKey, std::move(result)};
    } catch (const Error& failure) {
        if (failure.code() != ErrorCode::ResultDamaged && failure.code() != ErrorCode::FileEmpty)
            throw;
        return {.state = ResultStore::State::Damaged};
    }
}

bool isOfStoring(const Error& error)
{
    return error.code() == ErrorCode::WriteFailed || error.code() == ErrorCode::PermissionDenied ||
           error.code() == ErrorCode::BadArgument;
}

/// \return whether it could be stored.
bool tryToStore(const fs::path& folder, const Unstored& unstored)
{
    try {
        writeResultFile(fileIn(folder, unstored.step), {unstored.step, unstored.key}, *unstored.result);
        return true;
    } catch (const Error& error) {
        if (!isOfStoring(error))
            throw;
        return false;
    }
}

} // namespace

fs::path ResultStore::fileOf(const std::string& step) const
{
    return fileIn(m_folder, step);
}

ResultStore::Entry ResultStore::load(const std::string& step, const std::string& key) const
{
    const std::vector<fs::path> places = placesWith(m_folder);
    Entry best;
    if (const auto kept = inMemory(places, step)) {
        best = {kept->key == key ? State::Fresh : State::OtherKey, kept->result};
        if (best.state == State::Fresh || key.empty())
            return best;
    }
    for (const fs::path& place : newestFirst(places, step)) {
        Entry entry = loadFrom(place, step, key);
        const bool isUsable = entry.state == State::Fresh || (key.empty() && entry.state == State::OtherKey);
        if (isUsable)
            return entry;
        if (best.state == State::Missing)
            best = std::move(entry);
    }
    return best;
}

ResultStore::Entry ResultStore::loadFrom(const fs::path& place, const std::string& step,
                                         const std::string& key) const
{
    try {
        return loadFile(fileIn(place, step), step, key, m_memory.get());
    } catch (const Error&) {
        if (place == m_folder)
            throw;
        return {}; // the results of another place are a help, no more
    }
}

ResultStore::Standing ResultStore::standing(const std::string& step, const std::string& key) const
{
    const std::vector<fs::path> places = placesWith(m_folder);
    if (m_memory != nullptr && !inMemory(places, step)) {
        for (const fs::path& place : newestFirst(places, step)) {
            const auto known = m_memory->known(fileIn(place, step));
            if (!known)
                break;
            if (known->key == key)
                return {State::Fresh, known->files};
        }
    }
    const Entry entry = load(step, key);
    return {entry.state, entry.result->files};
}

ResultPointer ResultStore::freshResult(const std::string& step, const std::string& key) const
{
    Entry entry = load(step, key);
    if (entry.state != State::Fresh)
        throw Error(ErrorCode::ResultReplaced, {.values = {{"stage", step}}});
    return std::move(entry.result);
}

bool ResultStore::save(const std::string& step, const std::string& key, ResultPointer result) const
{
    const Unstored unstored{m_folder, step, key, std::move(result)};
    for (fs::path folder = m_folder; !folder.empty(); folder = nextResultFolder(folder)) {
        if (tryToStore(folder, unstored)) {
            if (m_memory != nullptr)
                m_memory->note(fileIn(folder, step), key, *unstored.result);
            forget(placesWith(m_folder), step);
            return true;
        }
    }
    const std::scoped_lock lock(memory().mutex);
    memory().results[fileOf(step)] = unstored;
    return false;
}

void ResultStore::prefer(const std::string& step, const std::string& key) const
{
    const std::vector<fs::path> places = placesWith(m_folder);
    const std::vector<fs::path> sorted = newestFirst(places, step);
    const auto kept = inMemory(places, step);
    if (sorted.size() < 2 && !kept)
        return;
    if (kept ? kept->key == key : loadFrom(sorted.front(), step, key).state == State::Fresh)
        return;
    const Entry entry = load(step, key);
    if (entry.state == State::Fresh)
        save(step, key, entry.result);
}

std::vector<std::string> unstoredResults()
{
    const std::scoped_lock lock(memory().mutex);
    std::vector<std::string> steps;
    for (const auto& [file, unstored] : memory().results)
        steps.push_back(unstored.step);
    return steps;
}

void writeUnstoredResults(const fs::path& projectFile, const fs::path& folder)
{
    const std::vector<fs::path> places = placesWith(cacheFolder(projectFile));
    const auto kept = [] {
        const std::scoped_lock lock(memory().mutex);
        return memory().results;
    }();
    for (const auto& [file, unstored] : kept) {
        if (std::find(places.begin(), places.end(), unstored.folder) != places.end())
            writeResultFile(fileIn(folder, unstored.step), {unstored.step, unstored.key}, *unstored.result);
    }
}

std::size_t storeUnstoredResults()
{
    const auto kept = [] {
        const std::scoped_lock lock(memory().mutex);
        return memory().results;
    }();
    for (const auto& [file, unstored] : kept) {
        for (const fs::path& place : placesWith(unstored.folder)) {
            if (!tryToStore(place, unstored))
                continue;
            const std::scoped_lock lock(memory().mutex);
            const auto now = memory().results.find(file);
            if (now != memory().results.end() && now->second.result == unstored.result)
                memory().results.erase(now);
            break;
        }
    }
    const std::scoped_lock lock(memory().mutex);
    return memory().results.size();
}

} // namespace quadrille
