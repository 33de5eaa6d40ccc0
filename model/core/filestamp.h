// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace quadrille {

/// What shows without reading a file whether it is still the same.
struct FileStamp
{
    std::uint64_t size = 0;
    std::int64_t modified = 0; ///< nanoseconds since 1970
    std::int64_t changed = 0;  ///< of the file's entry; where it was moved or its rights were changed, too
    std::uint64_t number = 0;  ///< another file took its place where it is another

    bool operator==(const FileStamp&) const = default;
    /// The content was not written since, as far as can be seen.
    bool hasContentOf(const FileStamp& other) const
    {
        return size == other.size && modified == other.modified && number == other.number;
    }
};

/// Nothing where there is no file. Cost: one system call.
std::optional<FileStamp> stampOf(const std::filesystem::path& file);

} // namespace quadrille
