// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/project.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

struct ImportRequest
{
    std::vector<std::filesystem::path> sources;
    std::filesystem::path mesh; ///< of the character; may be empty
    std::string name;           ///< of the sequence, for a single source; the file's when empty
    std::string character;      ///< added where the project has none of this name; the only one when empty
    std::optional<double> sourceFps;
    std::optional<CoordinateSystem> sourceAxes;
};

struct ImportReport
{
    std::vector<std::string> names; ///< of the sequences that were added
    std::vector<Issue> issues;
    bool isNewProject = false;
};

/// Adds sequences to a project in memory: one for each source, or for each animation clip of it. Each is
/// opened, so that what does not fit its character is refused. Names that exist get a number.
/// \param folder the project file's.
/// \param isNew the project takes the rate of the first source.
/// \throws Error what opening throws; BadArgument where the character is not clear or has another mesh. The
/// project is unchanged then.
ImportReport addSequences(Project& project, const std::filesystem::path& folder, const ImportRequest& request,
                          bool isNew, const Progress& progress = {});

/// The same in a project file, which is made where it does not exist.
ImportReport importSequences(const std::filesystem::path& projectFile, const ImportRequest& request,
                             const Progress& progress = {});

} // namespace quadrille
