// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace quadrille {

/// Files that shall appear in a folder all together or not at all: they are written into a hidden folder
/// beside, and moved when all are done. Without `commit` nothing stays.
class StagedFiles
{
public:
    /// \param folder where the files shall be; missing folders are made.
    /// \throws Error PermissionDenied, WriteFailed.
    explicit StagedFiles(const std::filesystem::path& folder);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Where to write a file of this name for now; a name may have folders before it. Safe from any thread.
    std::filesystem::path add(const std::string& name);
    /// Moves all files to their place, over files of the same name.
    /// \return their paths, sorted by name.
    /// \throws Error PermissionDenied, WriteFailed.
    std::vector<std::filesystem::path> commit();

private:
    std::filesystem::path m_folder;
    std::filesystem::path m_staging;
    std::filesystem::path m_madeFolder; ///< the uppermost folder that had to be made; empty when none
    bool m_isDone = false;
    std::mutex m_mutex;
    std::vector<std::string> m_names;
};

/// "NAME_0007.png": a file of a numbered series of `count` files, with at least four digits.
std::string numberedName(const std::filesystem::path& out, std::int64_t number, std::int64_t count);

} // namespace quadrille
