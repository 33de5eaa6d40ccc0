// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/session.h"

#include "editor/application/sealedfile.h"
#include "editor/documents/projectpaths.h"

#include <QCryptographicHash>
#include <QDir>
#include <QJsonArray>
#include <QStandardPaths>

namespace quadrille {

namespace {

constexpr int sessionFormat = 2;

/// A file name that stands for a project file.
QString keyOf(const QString& project)
{
    const QByteArray hash = QCryptographicHash::hash(project.toUtf8(), QCryptographicHash::Sha1);
    return QString::fromLatin1(hash.toHex().left(20));
}

QString dataFile(const QString& folder, const QString& key, const QString& ending)
{
    const QDir base(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
    base.mkpath(folder);
    return base.filePath(QStringLiteral("%1/%2.%3").arg(folder, key, ending));
}

QByteArray bytes(const QJsonValue& value)
{
    return QByteArray::fromBase64(value.toString().toLatin1());
}

QString text(const QByteArray& bytes)
{
    return QString::fromLatin1(bytes.toBase64());
}

Session sessionFrom(const QJsonObject& stored)
{
    Session session;
    session.windowPlace = bytes(stored["windowPlace"]);
    session.docks = stored["docks"].toObject();
    session.workspace = stored["workspace"].toString();
    const QJsonArray selected = stored["selected"].toArray();
    for (const auto& name : selected)
        session.selected += name.toString();
    session.shownSequence = stored["shownSequence"].toString();
    session.frame = stored["frame"].toInteger();
    session.looks = stored["looks"].toObject();
    session.view = stored["view"].toObject();
    return session;
}

} // namespace

QString sessionFile(const std::filesystem::path& project)
{
    return dataFile(QStringLiteral("sessions"),
                    project.empty() ? QStringLiteral("window") : keyOf(toQString(project)),
                    QStringLiteral("json"));
}

KeptSession loadSession(const std::filesystem::path& project)
{
    const SealedContents stored = readSealed(sessionFile(project), sessionFormat);
    return {sessionFrom(stored.values), stored.asideFile};
}

void saveSession(const Session& session, const std::filesystem::path& project)
{
    const QJsonObject stored{
        {"windowPlace", text(session.windowPlace)},
        {"docks", session.docks},
        {"workspace", session.workspace},
        {"selected", QJsonArray::fromStringList(session.selected)},
        {"shownSequence", session.shownSequence},
        {"frame", session.frame},
        {"looks", session.looks},
        {"view", session.view},
    };
    writeSealed(sessionFile(project), stored, sessionFormat);
}

QString thumbnailFile(const QString& project)
{
    return dataFile(QStringLiteral("thumbnails"), keyOf(project), QStringLiteral("png"));
}

} // namespace quadrille
