// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/media/filehashes.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace quadrille {

/// What tells a moved medium from a namesake: of a series, of all its files in their order, whatever they are
/// called.
struct MediaContent
{
    std::uint64_t bytes = 0;
    std::string hash;

    bool operator==(const MediaContent&) const = default;
};

/// Contents by path, as the project holds it; only of media that were there once.
using KnownMedia = std::map<std::string, MediaContent>;

/// True when there is a file or folder, or something that a pattern matches.
bool mediumExists(const std::filesystem::path& medium);

/// The files of a medium: itself, what its pattern matches, or the files of a folder without those below;
/// in natural order. Empty when there are none.
std::vector<std::filesystem::path> filesOfMedium(const std::filesystem::path& medium);

/// \throws Error file errors, Cancelled.
MediaContent contentOf(const std::vector<std::filesystem::path>& files, FileHashes& hashes,
                       const Progress& progress = {});

/// What the project's cache folder knows; empty when it knows nothing.
KnownMedia readKnownMedia(const std::filesystem::path& cacheFolder);
void writeKnownMedia(const KnownMedia& known, const std::filesystem::path& cacheFolder);

} // namespace quadrille
