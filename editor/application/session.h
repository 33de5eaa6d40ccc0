// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QStringList>
#include <filesystem>

namespace quadrille {

/// How a project was last looked at: comes back when it is opened again. Kept per project beside the user's
/// settings, not in the project file.
struct Session
{
    QByteArray windowGeometry;
    QJsonObject docks; ///< their arrangement in each workspace
    QString workspace;
    QStringList selected;
    QString shownSequence;
    qint64 frame = 0;
    QJsonObject view; ///< camera and shading, as the workspace describes them

    bool operator==(const Session&) const = default;
};

/// The session of a project file; an empty one where there is none or it cannot be read.
Session loadSession(const std::filesystem::path& project);
/// Sessions are a convenience: that one could not be written is not told.
void saveSession(const Session& session, const std::filesystem::path& project);

/// Where the picture of a recent project lies, whether or not it is there.
QString thumbnailFile(const QString& project);

} // namespace quadrille
