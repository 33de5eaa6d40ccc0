// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/writeguard.h"
#include "model/project/document/project.h"
#include "model/project/results/projectresults.h"
#include "model/sequence/io/files/format.h"

#include <filesystem>
#include <vector>

namespace quadrille {

/// Writes exports, be they entries of the project or not, and computes first what they show. A rebuild of the
/// project writes the same bytes.
/// \param permissions  what the user was asked about, see outputQuestions.
/// \throws Error of the step that failed, of opening and writing, BadArgument, Cancelled.
std::vector<ExportResult> runExports(const WorkingProject& working, const std::vector<ExportEntry>& entries,
                                     const Progress& progress = {}, WritePermissions permissions = {});

/// What is to be asked before exports are written.
struct OutputQuestions
{
    std::vector<std::filesystem::path> foreign;  ///< files that the program did not write as they are
    std::vector<std::filesystem::path> existing; ///< files that are there, foreign ones among them
    std::vector<std::filesystem::path> outside;  ///< folders outside of the project's, resolved, each once
};
/// Looks where exports would write, as far as names say before they are written.
/// \throws Error BadArgument, FormatUnknown, what reading files throws,
/// Cancelled.
OutputQuestions outputQuestions(const Project& project, const std::filesystem::path& projectFile,
                                const std::vector<ExportEntry>& entries, const Progress& progress = {});

} // namespace quadrille
