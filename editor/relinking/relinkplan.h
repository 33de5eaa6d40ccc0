// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/media/findmedia.h"
#include "model/project/media/media.h"

#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// A medium that is not where the open project says, and what was found for it.
struct LostMedium
{
    std::string path;           ///< absolute, as the document holds it
    std::vector<MediaUse> uses; ///< one at least
    FoundMedium found;
    bool isByHand = false; ///< the user chose what was found
    bool isWanted = false; ///< shall take the place of what is lost

    bool isFound() const { return found.match != MediaMatch::Missing; }
    /// True when it is one of several files: a folder, or the pattern of a series.
    bool isFolder() const;
};

/// What is lost and what shall be done about it.
struct RelinkPlan
{
    std::vector<LostMedium> media;
    KnownMedia known; ///< contents by absolute path

    /// Takes over what a search found: the better match wins, of equal ones the newer. What was chosen by
    /// hand stays. What has another content than was noted is not wanted by itself.
    void take(const std::vector<FoundMedium>& found);
    /// Takes over what the user chose for one medium. One that is missing takes back what was chosen.
    void takeByHand(std::size_t medium, const FoundMedium& chosen);
    /// A search in a folder for everything that was not chosen by hand.
    MediaSearch searchIn(const std::filesystem::path& folder) const;
    /// How many were found, by hand or by a search, wanted or not.
    std::size_t foundCount() const;
    /// Old and new path of everything that is wanted.
    std::vector<std::pair<std::string, std::string>> newPaths() const;
};

/// What an open project lacks. Looks at the disk.
/// \param project with absolute paths.
std::vector<MediaUse> missingMedia(const Project& project);
/// The plan of everything that is lost, with nothing found yet, and what the project's cache folder knows.
/// Looks at the disk.
/// \param projectFile empty while it is untitled. \param project  with absolute paths.
RelinkPlan planRelinking(const Project& project, const std::filesystem::path& projectFile);

/// A medium that a user chose, and what a search from there found of the others.
struct ChosenMedium
{
    FoundMedium chosen;
    std::vector<FoundMedium> others;
};
/// Compares a file that was chosen by hand, and looks for the rest in its folder, the folders below, and
/// where they would be had they moved alike. A numbered file stands for its series. Reads the disk; for the
/// thread of a job. \throws Error Cancelled.
ChosenMedium examineChoice(const RelinkPlan& plan, std::size_t medium, const std::filesystem::path& file,
                           const Progress& progress);

} // namespace quadrille
