// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

#include <span>

namespace quadrille {

/// All importers, in the order in which dialogs list them.
std::span<const std::unique_ptr<Importer>> importers();
/// All exporters, in the order in which dialogs list them.
std::span<const std::unique_ptr<Exporter>> exporters();

/// Finds what a path means: a file, a folder that holds one numbered series of meshes or one mesh, or a
/// pattern (name_####.obj, name_%04d.obj, name_*.obj). A numbered file means that file alone. \throws Error
/// FileNotFound, PermissionDenied, SeriesEmpty, SeriesAmbiguous.
SourceFiles findSource(const std::filesystem::path& path);

/// The series that a numbered file belongs to; the file alone when it has no neighbours.
/// \throws Error FileNotFound.
SourceFiles seriesAround(const std::filesystem::path& file);

/// The importer of a source, by extension and, where that is not enough, by signature.
/// \throws Error FormatUnknown, FormatRefused with what to convert it to.
const Importer& importerFor(const SourceFiles& source);

/// Opens a file, folder or pattern with the importer it needs and converts it to options.to. Gaps in the
/// numbering and an assumed rate become issues. The first and the last frame are read, so that a source that
/// does not hold together is refused here.
ImportResult openSequences(const std::filesystem::path& path, const ImportOptions& options = {},
                           const Progress& progress = {});

/// The exporter that a path's ending asks for.
/// \throws Error FormatUnknown.
const Exporter& exporterFor(const std::filesystem::path& out);

/// Refuses a place for a frame's number ("walk_####.glb") where a format is one file for all frames.
/// \throws Error BadArgument.
void checkOutputName(const FormatInfo& format, const std::filesystem::path& out);

/// Cuts, resamples and converts as the options say, then writes.
ExportResult exportSequence(const MeshSequence& sequence, const std::filesystem::path& out,
                            const ExportOptions& options = {}, const Progress& progress = {});

} // namespace quadrille
