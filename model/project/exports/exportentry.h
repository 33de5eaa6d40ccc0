// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/media/opensequence.h"
#include "model/project/steps/buildstep.h"
#include "model/sequence/io/files/format.h"

#include <memory>

namespace quadrille {

/// The exporter that an entry asks for by its format or the ending of its path.
/// \throws Error FormatUnknown.
const Exporter& exporterOf(const ExportEntry& entry);

/// The steps whose results an export reads. \return empty where it needs files only.
std::vector<std::string> stepsOf(const Project& project, const ExportEntry& entry);

/// The sound that is written with an export: that of the animation, into videos; null without one.
const AudioEntry* soundOf(const Project& project, const ExportEntry& entry);
/// The camera keys of pictures and videos: those of the animation, where the entry names no camera itself.
std::vector<CameraKey> cameraKeysOf(const Project& project, const ExportEntry& entry);

/// Whether an entry is about all of "variations/NAME".
bool isDataSet(const ExportEntry& entry);

/// Writes what an entry is about: a clip, a data set of variations, or the player of a performance.
/// \param context  has results of the steps that stepsOf names.
/// \param guard    decides what may be written over.
/// \throws Error as exportSequence, and what opening the clip throws.
ExportResult writeExport(const ExportEntry& entry, const std::shared_ptr<SequenceOpener>& opener,
                         const StepContext& context, WriteGuard& guard, const Progress& progress);

/// Writes a clip as an entry says.
/// \param folder the project file's.
/// \throws Error as exportSequence.
ExportResult writeExport(const ExportEntry& entry, const MeshSequence& sequence, const Project& project,
                         const std::filesystem::path& folder, WriteGuard* guard, const Progress& progress);

} // namespace quadrille
