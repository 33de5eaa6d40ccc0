// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/sequence/io/ratebeside.h"

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
    std::optional<double> sourceFps; ///< of sources that name none
    std::optional<CoordinateSystem> sourceAxes;
    bool ignoresLock = false; ///< writes although the project is open elsewhere
};

/// At which rate a take is added whose own file names none.
struct TakenRate
{
    std::string sequence;
    double fps = 0;
    std::optional<RateBeside> beside; ///< that says it
    bool isOfOthers = false;          ///< it is that of the character's other takes

    /// Nothing says it: it is a guess.
    bool isGuess() const { return !beside && !isOfOthers; }
    /// English: "“jog” has 30 fps, as in jog.bvh beside it".
    std::string toString() const;
    bool operator==(const TakenRate&) const = default;
};

/// The rate to take for a take whose file names none: what lies beside it says, else that of the other takes
/// of the character, else the project's. \param character  a name; may be one that the project does not have
/// yet.
TakenRate takenRate(std::optional<RateBeside> beside, const Project& project, const std::string& character);

struct ImportReport
{
    std::vector<std::string> names; ///< of the sequences that were added
    std::vector<TakenRate> rates;   ///< of those whose files name none, where no rate was asked for
    std::vector<Issue> issues;
    bool isNewProject = false;
};

/// Adds sequences to a project in memory: one for each source, or for each animation clip of it. Each is
/// opened, so that what does not fit its character is refused. Names that exist get a number. The rate of a
/// take whose file names none is the one that is asked for, else what lies beside it says, else that of the
/// character's other takes.
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
