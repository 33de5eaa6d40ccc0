// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/project/media/findmedia.h"
#include "model/project/media/mediacontent.h"

#include <filesystem>
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

/// Contents of all media that are there, by stored path.
/// \throws Error Cancelled. Files that cannot be read are left out.
KnownMedia contentsOfMedia(const Project& project, const std::filesystem::path& folder, FileHashes& hashes,
                           const Progress& progress = {});

/// Notes the contents of a project's media in its cache folder, so that they are found again once they have
/// moved. What is not there now keeps what was noted of it.
/// \throws Error WriteFailed, PermissionDenied, Cancelled.
void noteMedia(const Project& project, const std::filesystem::path& projectFile,
               const Progress& progress = {});

struct RelinkReport
{
    struct Moved
    {
        std::string from; ///< stored paths
        std::string to;
    };
    std::vector<Moved> moved;
    std::vector<FoundMedium> different; ///< only namesakes with another content; left as they are
    std::vector<std::string> missing;   ///< still not found
    /// Several files of that name and none known by content; the nearest was taken.
    std::vector<std::string> ambiguous;
};

/// Finds media that are not where the project says, by content and name, in a folder and its subfolders, and
/// changes their paths in the project; see findMedia.
/// \throws Error FileNotFound (the folder), Cancelled.
RelinkReport relinkMedia(Project& project, const std::filesystem::path& projectFolder,
                         const std::filesystem::path& searchFolder, const KnownMedia& known = {},
                         const Progress& progress = {});

} // namespace quadrille
