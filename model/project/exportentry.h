// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/project.h"
#include "model/sequence/io/format.h"

namespace quadrille {

/// The exporter that an entry asks for by its format or the ending of its path.
/// \throws Error FormatUnknown.
const Exporter& exporterOf(const ExportEntry& entry);

/// The stages whose results an export reads. \return empty where it needs files only.
std::vector<std::string> stagesOf(const Project& project, const ExportEntry& entry);

/// Writes a clip as an entry says.
/// \param folder the project file's.
/// \throws Error as exportSequence.
ExportResult writeExport(const ExportEntry& entry, const MeshSequence& sequence,
                         const ProjectSettings& settings, const std::filesystem::path& folder,
                         const Progress& progress);

} // namespace quadrille
