// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/format.h"

#include <span>

namespace quadrille {

/// All importers, in the order in which dialogs list them.
std::span<const std::unique_ptr<Importer>> importers();
/// All exporters, in the order in which dialogs list them.
std::span<const std::unique_ptr<Exporter>> exporters();

/// Finds what a path means: a file, a folder that holds one numbered series, or a pattern (name_####.obj,
/// name_%04d.obj, name_*.obj).
/// \throws Error FileNotFound, SeriesEmpty.
SourceFiles findSource(const std::filesystem::path& path);

/// The importer of a source, by extension and, where that is not enough, by signature.
/// \throws Error FormatUnknown, FormatRefused with what to convert it to.
const Importer& importerFor(const SourceFiles& source);

/// Opens a file, folder or pattern with the importer it needs and converts it to options.to.
ImportResult openSequences(const std::filesystem::path& path, const ImportOptions& options = {},
                           const Progress& progress = {});

/// The exporter that a path's ending asks for.
/// \throws Error FormatUnknown.
const Exporter& exporterFor(const std::filesystem::path& out);

/// Cuts, resamples and converts as the options say, then writes.
ExportResult exportSequence(const MeshSequence& sequence, const std::filesystem::path& out,
                            const ExportOptions& options = {}, const Progress& progress = {});

} // namespace quadrille
