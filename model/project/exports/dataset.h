// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/exports/exportentry.h"

#include <string>
#include <vector>

namespace quadrille {

/// The results that a data set is described by, beside its clips.
std::vector<std::string> dataSetSteps(const Project& project, const std::string& variation);

// Where the files of a data set go, beside the path of its export.
std::filesystem::path dataSetMember(const std::filesystem::path& out, int number);
std::filesystem::path dataSetLatents(const std::filesystem::path& out, const std::string& part);
std::filesystem::path dataSetDescription(const std::filesystem::path& out);

/// Writes all variations of an entry that the user did not discard, for machine learning: clips as the export
/// says, DIR/NAME_1.pc2, DIR/NAME_2.pc2, …; the latent trajectories of each part, DIR/NAME_PART_latents.npy
/// (variations × reference frames × dimensions); and DIR/NAME.json, which says what each of them varies, with
/// seed, quality, and the captured frames that it follows.
/// \param context  has the results of dataSetSteps.
/// \throws Error as writeExport, and what opening the clips throws.
ExportResult writeDataSet(const ExportEntry& entry, SequenceOpener& opener, const StepContext& context,
                          WriteGuard* guard, const Progress& progress);

} // namespace quadrille
