// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/brokenentry.h"
#include "model/project/file/projectfile.h"

namespace quadrille {

/// Reads as much of a project file as can be used. Entries that readProject() would report an error of are
/// kept, see brokenEntries(), with those that need them; what remains has no errors.
/// \return the project, and the problems of the broken entries together with all warnings.
/// \throws Error as readProject: where the text is no JSON, or not that of a project of a known version.
ProjectReading readUsableProject(std::string_view text, const std::filesystem::path& file);

/// The project with its broken entries read again: those that can be used by now are entries like others.
Project withBrokenReadAgain(const Project& project, const std::filesystem::path& file);

/// What the file of a project would be refused for, without its broken entries: errors only. Nothing for a
/// project that readProject() takes.
/// Cost: that of writing and reading the file, without its text.
ProjectProblems problemsWhenSaved(const Project& project);

} // namespace quadrille
