// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/project.h"
#include "model/sequence/io/format.h"

#include <filesystem>
#include <vector>

namespace quadrille {

/// Writes exports, be they entries of the project or not, and computes first what they show. A rebuild of the
/// project writes the same bytes.
/// \param projectFile  results lie beside it; it need not be there.
/// \throws Error of the stage that failed, of opening and writing, Cancelled.
std::vector<ExportResult> runExports(const Project& project, const std::filesystem::path& projectFile,
                                     const std::vector<ExportEntry>& entries, const Progress& progress = {});

} // namespace quadrille
