// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace quadrille {

/// Where a folder really is: absolute, every symbolic link resolved, also a link whose target is not there,
/// and every "..". What does not exist yet is taken by its name.
std::filesystem::path resolvedFolder(const std::filesystem::path& folder);

/// Where a file of this path would be put: its folder is resolved, its own name is not, since a file that is
/// written takes the place of a link.
std::filesystem::path resolvedPlace(const std::filesystem::path& file);

/// Whether a resolved path is a resolved folder or lies below it.
bool liesIn(const std::filesystem::path& place, const std::filesystem::path& folder);

/// One file, whatever its paths are: links, hard links and other spellings of a name lead to the same.
struct FileIdentity
{
    std::uint64_t device = 0;
    std::uint64_t number = 0;

    auto operator<=>(const FileIdentity&) const = default;
};
/// Of what a path leads to, links followed; empty when there is nothing.
std::optional<FileIdentity> identityOf(const std::filesystem::path& path);

} // namespace quadrille
