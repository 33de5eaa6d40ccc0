// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// The files of a folder by what they form, each list in natural order of names.
struct FolderContent
{
    std::vector<SourceFiles> series; ///< two files or more whose names differ in one number
    std::vector<SourceFiles> singles;
};

/// Groups the files of a folder into numbered series and single files. The number may stand anywhere in the
/// name and may be padded or not.
/// \param extensions lower case with dot; files with other extensions are passed over.
/// \throws Error FileNotFound, PermissionDenied, ReadFailed.
FolderContent scanFolder(const std::filesystem::path& folder, std::span<const std::string> extensions);

/// The only series of a folder; its only file where there is no series.
/// \param path  what was looked for, for messages. \throws Error SeriesEmpty, SeriesAmbiguous.
SourceFiles onlySeries(FolderContent content, const std::filesystem::path& path);

/// Files that a pattern in the last part of the path matches, as one series. `####` and `%04d` stand for a
/// number of any length; `*`, `?` and `[…]` as in a shell.
/// \throws Error FileNotFound (the folder), SeriesEmpty, SeriesAmbiguous.
SourceFiles findPattern(const std::filesystem::path& pattern);

/// True when the last part of the path has a place holder of `findPattern`.
bool isPattern(const std::filesystem::path& path);

/// Whether a file name is one of those that the last part of a pattern means.
bool matchesPattern(const std::string& file, const std::string& pattern);

/// "3, 7–9, 12"; cut short with "…" after a dozen spans.
std::string describeNumbers(std::span<const std::int64_t> numbers);

/// The extension in lower case, with its dot.
std::string lowerExtension(const std::filesystem::path& path);

/// Natural order: "f2" before "f10".
bool naturalLess(std::string_view a, std::string_view b);

} // namespace quadrille
