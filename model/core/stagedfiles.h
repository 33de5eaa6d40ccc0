// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/writeguard.h"

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// Files that shall appear in a folder all together or not at all: they are written into a hidden folder
/// beside, and moved when all are done. Without `commit` nothing stays.
class StagedFiles
{
public:
    /// \param folder where the files shall be; missing folders are made.
    /// \param guard  decides what may be put there; null for files of the program's own.
    /// \throws Error PermissionDenied, WriteFailed, BadArgument (outside of the guarded folder).
    explicit StagedFiles(const std::filesystem::path& folder, WriteGuard* guard = nullptr);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Where to write a file of this name for now; a name may have folders before it. Safe from any thread.
    std::filesystem::path add(const std::string& name);
    /// Moves all files to their place, over files of the same name as far as the guard allows.
    /// \return their paths, sorted by name.
    /// \throws Error PermissionDenied, WriteFailed, and what WriteGuard::put throws.
    std::vector<std::filesystem::path> commit();

private:
    std::filesystem::path m_folder;
    WriteGuard* m_guard;
    std::filesystem::path m_staging;
    std::filesystem::path m_madeFolder; ///< the uppermost folder that had to be made; empty when none
    bool m_isDone = false;
    std::mutex m_mutex;
    std::vector<std::string> m_names;
};

/// Runs `write(temporaryPath)` and puts the file into its place, whole or not at all, as the guard allows.
/// \param guard null for files of the program's own.
/// \throws what `write` throws, Error PermissionDenied, WriteFailed, and what WriteGuard::put throws.
void writeGuarded(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& write, WriteGuard* guard);
/// \overload writing bytes.
void writeGuarded(const std::filesystem::path& path, std::string_view content, WriteGuard* guard);

} // namespace quadrille
