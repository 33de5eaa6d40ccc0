// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/writeguard.h"
#include "model/project/document/project.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// A file that an export may write, or the files of a numbered series, however many it has.
struct OutputClaim
{
    NumberedNames names;     ///< of one file: its name in `before`
    bool isNumbered = false; ///< a number stands between
    /// A picture or a material library beside; what is written then is known only when it is written.
    bool isCompanion = false;

    /// "walk.glb", "walk_0000.obj …"
    std::string text() const;
};

/// What an export may write, whatever its clip holds; folders are resolved.
/// \param folder the project file's.
/// \throws Error FormatUnknown; BadArgument (a place for a frame's number in the name of one file).
std::vector<OutputClaim> claimsOf(const Project& project, const ExportEntry& entry,
                                  const std::filesystem::path& folder);

/// A file that both may write; empty when there is none. Pictures beside two exports of one clip are the same
/// pictures.
std::optional<std::string> sharedOutput(const Project& project, const ExportEntry& a, const ExportEntry& b,
                                        const std::filesystem::path& folder);

/// Refuses an export that would write where it must not: over inputs, outside, where another export writes.
/// Looks at names only; what is there at the time is looked at when files are put.
/// \param others the exports of the project; the one called as `entry` is passed over.
/// \throws Error BadArgument, FormatUnknown.
void checkOutputs(const Project& project, const ExportEntry& entry, const std::vector<ExportEntry>& others,
                  const std::filesystem::path& folder, WriteGuard& guard);

} // namespace quadrille
