// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>

namespace quadrille {

/// Content hashes of files. What was hashed once is looked up by path, size, times and file number as long as
/// these stand, so that asking again costs one system call a file. Safe from any thread.
class FileHashes
{
public:
    /// \param memo file that remembers hashes between runs; it may be missing or damaged. Empty: none.
    explicit FileHashes(std::filesystem::path memo = {});

    /// The hash of one file's content.
    /// \throws Error file errors, Cancelled.
    std::string of(const std::filesystem::path& file, const Progress& progress = {});
    /// Writes the memo if there is something new in it; a failure is no failure, only slower next time.
    void save();

private:
    struct Known
    {
        std::string stamp; ///< of the file's state when it was hashed
        std::string hash;
    };

    std::filesystem::path m_memo;
    std::mutex m_mutex;
    std::map<std::string, Known> m_known;
    bool m_changed = false;
};

} // namespace quadrille
