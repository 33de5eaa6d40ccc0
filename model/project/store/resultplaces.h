// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace quadrille {

/// Where the results of a project lie: NAME.quadrille.cache beside it, a folder that was chosen for it, or,
/// where nothing can be written beside it, a folder of its own among those of the user's cache. Results are
/// written to one of them and read from all, so that those of a shared project that can only be read count.
/// What this process found out about places holds for all of its threads.
struct ResultPlaces
{
    std::filesystem::path written;             ///< where new results go
    std::vector<std::filesystem::path> others; ///< where results are read, too, if they are there
    bool isElsewhere = false; ///< nothing can be written where it should be: `written` stands in for it
};
ResultPlaces resultPlaces(const std::filesystem::path& projectFile);

/// The folder into which a project's results go: ResultPlaces::written.
std::filesystem::path cacheFolder(const std::filesystem::path& projectFile);

/// Results of this project go into a folder from now on; an empty one undoes it.
void chooseResultFolder(const std::filesystem::path& projectFile, const std::filesystem::path& folder);

/// Where folders that stand in for those beside projects are made; $XDG_CACHE_HOME/quadrille/results when
/// empty.
void setResultRoot(const std::filesystem::path& folder);
std::filesystem::path resultRoot();

/// Makes sure, before anything is computed, that so many bytes of results can be stored, by writing a file to
/// try. Goes on to the next place where one does not do, and comes back to the first once it does again.
/// \throws Error why the first place does not do, where no place does.
void prepareResults(const std::filesystem::path& projectFile, std::uint64_t bytes);

/// Tries again whether places can be written that could not be before; leaves nothing behind. What
/// prepareResults does by itself before something is computed, for those who wait for nothing else.
void recheckResultPlaces(const std::filesystem::path& projectFile);

/// Notes that a folder of results could not be written.
/// \return the next place of its project; empty where there is none.
std::filesystem::path nextResultFolder(const std::filesystem::path& folder);

/// The other places of the project that a folder of results belongs to.
std::vector<std::filesystem::path> otherResultFolders(const std::filesystem::path& folder);

} // namespace quadrille
