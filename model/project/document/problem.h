// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <string>
#include <vector>

namespace quadrille {

/// Something that is wrong with a project, its inputs or its results.
struct ProjectProblem
{
    enum class Severity
    {
        Warning, ///< the project works, perhaps not as meant
        Error,   ///< what it names cannot be used
    };
    Severity severity = Severity::Error;
    ErrorCode code = ErrorCode::ProjectInvalid;
    ErrorContext context;
    /// The value it is about, as a JSON pointer into the project file ("/sequences/3/range").
    std::string pointer;
    /// The key is meant, not its value.
    bool atKey = false;

    /// English, one line: "FILE: WHAT REMEDY (WHERE)".
    std::string toString() const { return Error(code, context).what(); }
};

using ProjectProblems = std::vector<ProjectProblem>;

/// A ProjectInvalid error about the value at `pointer`.
/// \param reason what is wrong, without the full stop.
/// \param remedy what to do, a sentence, or empty.
ProjectProblem invalidAt(std::string pointer, std::string reason, std::string remedy = {});
/// The same as a warning.
ProjectProblem warningAt(std::string pointer, std::string reason, std::string remedy = {});

bool hasErrors(const ProjectProblems& problems);

} // namespace quadrille
