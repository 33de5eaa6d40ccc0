// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"

namespace quadrille {

struct CheckReport
{
    /// Of the file, its inputs and its results; in this order, each with the place in the file where it has
    /// one.
    ProjectProblems problems;
    std::size_t freshResults = 0;
    std::size_t staleResults = 0;
};

/// Validates a project file, opens every input and verifies the stored results; computes nothing and changes
/// nothing.
/// \param allowsOutside  exports may lie outside of the project's folder.
/// \throws Error file errors, ProjectSyntax, FileEncoding, ProjectNewer, Cancelled.
CheckReport checkProject(const std::filesystem::path& file, const Progress& progress = {},
                         bool allowsOutside = false);

} // namespace quadrille
