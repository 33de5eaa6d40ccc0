// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/media/mediacontent.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// How sure it is that a file is the medium that was looked for; from the worst to the best.
enum class MediaMatch
{
    Missing,        ///< nothing was found
    OtherContent,   ///< the name is the same, the content is not the one that the project used
    Name,           ///< the name is the same; the content was never noted
    Content,        ///< the content is the same, under another name
    NameAndContent, ///< both are the same
};

struct FoundMedium
{
    std::string path;           ///< the medium, as the project holds it
    std::filesystem::path file; ///< where it is now: a file, folder or pattern; empty when missing
    MediaMatch match = MediaMatch::Missing;
    /// There are several of that name and none is known by content; the one whose path is most alike was
    /// taken.
    bool isAmbiguous = false;
};

struct MediaSearch
{
    std::vector<std::string> paths; ///< what is looked for, as the project holds it
    KnownMedia known;               ///< what is known of them
    std::filesystem::path folder;   ///< searched with all its subfolders; links to folders are not followed
    /// A medium that is known to have moved, from and to, both absolute: the others are looked for on the
    /// same way, too.
    std::optional<std::pair<std::filesystem::path, std::filesystem::path>> example;
};

/// Looks for media by name and by content; changes nothing. The content of a file is read only where its size
/// is that of a medium whose content is known.
/// \return as many as search.paths, in their order.
/// \throws Error FileNotFound (the folder), Cancelled. Folders and files that cannot be read are passed over.
std::vector<FoundMedium> findMedia(const MediaSearch& search, const Progress& progress = {});

/// Compares one file, folder or pattern that somebody chose with the medium that it shall stand for. `file`
/// is empty when there is nothing.
/// \throws Error Cancelled.
FoundMedium examineMedium(const std::string& path, const std::filesystem::path& chosen,
                          const KnownMedia& known, const Progress& progress = {});

} // namespace quadrille
