// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/resultfile.h"
#include "model/project/store/resultmemory.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// The results of a project on disk: NAME.quadrille.cache/STEP.h5. What is not there is looked for in the
/// other places of the project (see resultplaces.h), and what cannot be stored anywhere is kept in memory
/// until it can. Safe from any thread; different steps may be written at once.
class ResultStore
{
public:
    enum class State
    {
        Missing,
        OtherKey, ///< of other inputs, settings or algorithm
        Damaged,
        Fresh,
    };
    struct Entry
    {
        State state = State::Missing;
        /// When fresh, or of another key; empty otherwise. Never null.
        ResultPointer result = std::make_shared<const Result>();
    };
    /// How a step stands, and the files that its result names.
    struct Standing
    {
        State state = State::Missing;
        std::vector<WrittenFile> files;
    };

    /// \param memory  of files that need not be read again to know that they are whole; null: all are read.
    explicit ResultStore(std::filesystem::path folder, std::shared_ptr<ResultMemory> memory = nullptr)
        : m_folder(std::move(folder)), m_memory(std::move(memory))
    {
    }

    std::filesystem::path fileOf(const std::string& step) const;
    /// Reads a result and verifies its checksum. Without a fresh one, the newest of the places.
    /// \throws Error PermissionDenied, ReadFailed.
    Entry load(const std::string& step, const std::string& key) const;
    /// As load, without the content. Cost: one system call where the memory knows the file.
    Standing standing(const std::string& step, const std::string& key) const;
    /// A result that was fresh a moment ago. \throws Error ResultReplaced (somebody else has put another in
    /// its place, or removed it, in the meantime); as load.
    ResultPointer freshResult(const std::string& step, const std::string& key) const;
    /// Stores a result here, else in the next place of the project, else in memory.
    /// \return whether it is on a disk.
    bool save(const std::string& step, const std::string& key, ResultPointer result) const;
    bool save(const std::string& step, const std::string& key, Result result) const
    {
        return save(step, key, std::make_shared<const Result>(std::move(result)));
    }
    /// Makes a fresh result the newest one, where a newer one of another key lies in another place.
    void prefer(const std::string& step, const std::string& key) const;

private:
    Entry loadFrom(const std::filesystem::path& place, const std::string& step, const std::string& key) const;

    std::filesystem::path m_folder;
    std::shared_ptr<ResultMemory> m_memory;
};

/// Steps whose results could not be stored anywhere and are in memory only, of all projects.
std::vector<std::string> unstoredResults();
/// Tries to store them again.
/// \return how many are still in memory only.
std::size_t storeUnstoredResults();
/// Writes those of one project into another folder.
/// \throws Error WriteFailed, PermissionDenied.
void writeUnstoredResults(const std::filesystem::path& projectFile, const std::filesystem::path& folder);

} // namespace quadrille
