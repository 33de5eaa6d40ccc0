// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/filehashes.h"
#include "model/project/project.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace quadrille {

/// One path that a project names: a file, or the folder or pattern of a series.
struct MediaUse
{
    std::string owner;   ///< "sequences/walk"
    std::string pointer; ///< JSON pointer of the path
    std::string path;    ///< as stored
    std::filesystem::path file;
    bool exists = false;
};

/// All media that a project uses, in the order of the file. Exports are no media.
/// \param folder the project file's.
std::vector<MediaUse> mediaOf(const Project& project, const std::filesystem::path& folder);

/// Content hashes by stored path, as far as they are known: they tell a moved file from a namesake.
using KnownHashes = std::map<std::string, std::string>;

struct RelinkReport
{
    struct Moved
    {
        std::string from; ///< stored paths
        std::string to;
    };
    std::vector<Moved> moved;
    std::vector<std::string> missing; ///< still not found
    /// Several files of that name and none known by content; the nearest was taken.
    std::vector<std::string> ambiguous;
};

/// Finds media that are not where the project says, by content and name, in a folder and its subfolders, and
/// changes their paths in the project. A file of another name counts when its content is the known one.
/// \throws Error FileNotFound (the folder), Cancelled.
RelinkReport relinkMedia(Project& project, const std::filesystem::path& projectFolder,
                         const std::filesystem::path& searchFolder, const KnownHashes& known = {},
                         const Progress& progress = {});

/// The hashes of all media files that are there, for a later relinkMedia. Kept beside the results when a
/// project is rebuilt.
KnownHashes hashMedia(const Project& project, const std::filesystem::path& folder, FileHashes& hashes,
                      const Progress& progress = {});

/// The hashes that the last rebuild noted; empty when there are none.
KnownHashes readMediaHashes(const std::filesystem::path& cacheFolder);
void writeMediaHashes(const KnownHashes& known, const std::filesystem::path& cacheFolder);

} // namespace quadrille
