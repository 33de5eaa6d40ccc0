// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/problem.h"
#include "model/project/document/project.h"

#include <filesystem>
#include <string_view>

namespace quadrille {

/// Reads, migrates and validates a project file.
/// \throws Error file errors, ProjectSyntax, ProjectInvalid, ProjectNewer, each with line and column.
Project loadProject(const std::filesystem::path& file);

struct ProjectReading
{
    Project project;
    /// In the order of the file, each with line and column.
    ProjectProblems problems;
};
/// Reads and migrates a project file and reports everything that is wrong with its text. What is wrong is
/// left at its default. \throws Error file errors, ProjectSyntax, FileEncoding, ProjectNewer, ProjectInvalid
/// where it is no project.
ProjectReading readProject(const std::filesystem::path& file);
/// \overload from text; `file` only names it in problems.
ProjectReading readProject(std::string_view text, const std::filesystem::path& file);

/// Writes atomically; the file that was there before, if it differs, stays as NAME.quadrille.bak.
/// \throws Error WriteFailed, PermissionDenied.
void saveProject(const Project& project, const std::filesystem::path& file);

} // namespace quadrille
