// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <filesystem>

namespace quadrille {

// A project that is saved under another name has the same results: they are given to it, so that nothing is
// computed again, with the files that steps wrote among them. They are there all at once or not at all; of a
// step that both have, the one that is given stays. Contents that belong to the folder of the project only
// (where media were, contact sheets) are not given.

/// Gives results by links, at once: the two files share their bytes until one of them is written anew.
/// \return false where the file system has no links, or the two lie on different ones: nothing is given then.
/// \throws Error WriteFailed, PermissionDenied.
bool linkResults(const std::filesystem::path& fromProject, const std::filesystem::path& toProject);

/// Gives results by copying them.
/// \throws Error ReadFailed, WriteFailed, PermissionDenied, Cancelled.
void copyResults(const std::filesystem::path& fromProject, const std::filesystem::path& toProject,
                 const Progress& progress = {});

} // namespace quadrille
