// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// Where they are kept in Project::unknown; no key of a file, which has no such character.
inline constexpr auto brokenEntriesKey = "\x01"
                                         "broken";

/// A part of a project file that cannot be used, kept as it stands in the file and written back unchanged.
struct BrokenEntry
{
    std::string section; ///< key of the section in the file: "sequences"
    /// Its place in the section's list; empty when the section is no list or broken as a whole.
    std::optional<std::size_t> place;
    UnknownKeys json;
    /// The first thing that is wrong with it, with line and column where it was read from a text.
    ProjectProblem problem;

    /// The entry's own name, where it has one.
    std::string name() const;
    /// "sequences/walk"; by its number from 1 where it has no name: "sequences/3".
    std::string title() const;
};

/// The broken entries of a project, as readUsableProject() found them. They are part of Project::unknown:
/// what is not understood is kept.
std::vector<BrokenEntry> brokenEntries(const Project& project);
void setBrokenEntries(Project& project, const std::vector<BrokenEntry>& entries);
/// Project::unknown without them: the keys of the file that are not known.
UnknownKeys unknownKeys(const Project& project);

/// Titles of all of them, each unique: those of the same title are numbered.
std::vector<std::string> titlesOf(const std::vector<BrokenEntry>& entries);
/// The entry of a title.
std::optional<BrokenEntry> findBroken(const Project& project, const std::string& title);

} // namespace quadrille
