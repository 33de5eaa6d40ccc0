// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QJsonObject>
#include <QString>

namespace quadrille {

/// What a sealed file holds.
struct SealedContents
{
    QJsonObject values; ///< empty where there is no file, or none that can be used
    /// Where a file was put that is damaged or from a newer version of the program; empty otherwise.
    QString asideFile;
};

/// Files of the program's own with values that are handed on unseen, such as Qt's arrangements of windows:
/// they carry the number of their format and a checksum, so that only what was written comes back. A file
/// that cannot be used is put aside (“….aside”), out of the way of the next; one from before there were
/// checksums is taken for an empty one.
SealedContents readSealed(const QString& path, int format);
/// The keys “format” and “checksum” are the file's own.
/// \return whether it could be written; a file that was there stays otherwise.
bool writeSealed(const QString& path, QJsonObject values, int format);

} // namespace quadrille
