// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QStringList>
#include <filesystem>

namespace quadrille {

/// How a project was last looked at: comes back when it is opened again. Kept per project beside the user's
/// settings, not in the project file; the window keeps one of its own for when no project is open.
struct Session
{
    QByteArray windowPlace;
    QJsonObject docks; ///< their arrangement in each workspace
    QString workspace;
    QStringList selected;
    QString shownSequence;
    qint64 frame = 0;
    QJsonObject looks; ///< what each workspace keeps, by its id
    QJsonObject view;  ///< camera and shading, as the workspace describes them

    bool operator==(const Session&) const = default;
};

/// A session as it was found.
struct KeptSession
{
    Session session; ///< empty where there is none, or none that can be used
    /// Where one was put that is damaged or from a newer version of the program; empty otherwise.
    QString asideFile;
};

/// The session of a project file, or of the window itself when `project` is empty. Qt believes what it is
/// given as geometry and docks, so only what the program wrote itself gets there (see sealedfile.h). Reads
/// the file; blocks.
KeptSession loadSession(const std::filesystem::path& project);
/// Sessions are a convenience: that one could not be written is not told.
void saveSession(const Session& session, const std::filesystem::path& project);
/// Where the session of a project file, or of the window itself, lies, whether or not it is there.
QString sessionFile(const std::filesystem::path& project);

/// Where the picture of a recent project lies, whether or not it is there.
QString thumbnailFile(const QString& project);

} // namespace quadrille
