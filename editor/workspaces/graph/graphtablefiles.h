// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/graph/graphexplorer.h"

#include <filesystem>
#include <vector>

namespace quadrille {

class WriteGuard;

/// Writes what is known of both graphs as CSV files into a folder: their edges, statistics and components,
/// and the comparison over α where there is one. On any thread.
/// \param guard decides what may be written over.
/// \return the files. \throws Error WriteFailed, PermissionDenied, BadArgument (what the guard refuses),
/// Cancelled.
std::vector<std::filesystem::path> writeGraphTables(const CharacterGraph& character,
                                                    const MeasuredGraphs& measured,
                                                    const std::vector<GraphComparison>& comparison,
                                                    const std::filesystem::path& folder, WriteGuard& guard,
                                                    const Progress& progress);

} // namespace quadrille
