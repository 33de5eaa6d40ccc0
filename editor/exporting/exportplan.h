// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/sequence/io/files/format.h"

#include <QString>
#include <QStringList>
#include <vector>

namespace quadrille {

/// What an export dialog decides: one entry, and the clips that it is repeated for.
struct ExportPlan
{
    QStringList clips; ///< "sequences/NAME", "animations/NAME", or "variations/NAME" for all of them
    /// The entry of the first clip; the others' differ by name, `what` and file name only.
    ExportEntry entry;
    /// The entry of the project that is edited; empty for a new one.
    QString edited;
    bool isKept = true; ///< in the project, so that a rebuild repeats it

    /// \pre The entry's format is that of an exporter.
    const FormatInfo& format() const;
    /// Motion spaces to be played by games, in place of a clip: only of performances.
    bool isPlayer() const;
    bool isPicture() const;
    /// The entries that are written, one for each clip. Where there are several, all frames of each are
    /// written.
    std::vector<ExportEntry> entries() const;
    /// Files that an entry will write, for people: one, or first and last of a series. \param frames  that
    /// will be written.
    QString filesText(const ExportEntry& entry, std::int64_t frames) const;
};

/// A new export of some clips in a format, beside the project or in a folder, to a file that is not there
/// yet. Looks at the disk. \pre There is a clip, and an exporter of the format.
ExportPlan planExport(const QStringList& clips, const std::string& format, const QString& folder);
/// The same path with the ending of another format.
std::string withEndingOf(const std::string& path, const FormatInfo& format);

} // namespace quadrille
