// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/media/opensequence.h"
#include "model/sequence/io/bvh.h"

#include <filesystem>

namespace quadrille {

/// The file with the reference joint angles of a sequence: its own, or that of the sequence of which it is a
/// clip; empty where there is none.
std::filesystem::path referenceAnglesFile(const Project& project, const std::filesystem::path& folder,
                                          const SequenceEntry& entry);

/// The reference joint angles of a sequence without the root's, one row for each of its frames. The file
/// begins with the first frame of the sequence's source. Where it has as many frames as the source, they
/// belong together one by one, whatever rates the two claim; otherwise by time. They are cut and brought to
/// the project's rate as the source is.
/// \pre There is a file, see referenceAnglesFile.
/// \throws Error what reading the file and opening the source throw, RangeOutside where the file is too
/// short.
JointAngles referenceAngles(SequenceOpener& opener, const SequenceEntry& entry,
                            const Progress& progress = {});

} // namespace quadrille
