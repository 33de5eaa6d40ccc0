// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/recoveries.h"

#include "editor/documents/projectpaths.h"
#include "editor/documents/sections.h"
#include "model/core/file.h"
#include "model/project/file/projectfile.h"
#include "model/project/file/usableproject.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QSaveFile>
#include <QStandardPaths>

namespace quadrille {

namespace {

struct RecoveryTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::Recovery)
};

const QString copyEnding = QStringLiteral(".quadrille");
const QString infoEnding = QStringLiteral(".json");

QDir recoveryFolder()
{
    const QString path =
        QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recovery");
    QDir().mkpath(path);
    return QDir(path);
}

QString pathOf(const QString& id, const QString& ending)
{
    return recoveryFolder().filePath(id + ending);
}

/// Moves a copy to where nobody takes it for one any more. \return where it is now.
QString moveAside(const QString& id)
{
    const QDir folder = recoveryFolder();
    folder.mkpath(QStringLiteral("unreadable"));
    QString target = folder.filePath(QStringLiteral("unreadable/") + id + copyEnding);
    for (int i = 2; QFileInfo::exists(target); ++i)
        target = folder.filePath(QStringLiteral("unreadable/%1-%2").arg(id).arg(i) + copyEnding);
    if (!QFile::rename(pathOf(id, copyEnding), target))
        return pathOf(id, copyEnding);
    QFile::rename(pathOf(id, infoEnding), target + infoEnding);
    return target;
}

/// The project file that a copy is of; empty where it has none or nobody knows.
QString projectFileOf(const QString& id)
{
    QFile file(pathOf(id, infoEnding));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(file.readAll())[QLatin1String("project")].toString();
}

} // namespace

QString Recovery::title() const
{
    return projectFile.isEmpty() ? RecoveryTexts::tr("Untitled") : QFileInfo(projectFile).completeBaseName();
}

int Recovery::entryCount() const
{
    std::size_t count = project.graphs.size();
    for (const SectionInfo& section : sections())
        count += static_cast<std::size_t>(section.names(project).size());
    return static_cast<int>(count);
}

Recoveries findRecoveries()
{
    Recoveries found;
    const QFileInfoList copies =
        recoveryFolder().entryInfoList({QLatin1Char('*') + copyEnding}, QDir::Files, QDir::Time);
    for (const QFileInfo& info : copies) {
        const QString id = info.completeBaseName();
        QLockFile lock(recoveryLockFile(id));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0))
            continue;
        Recovery recovery{id, projectFileOf(id), info.lastModified(), {}};
        try {
            const auto copy = toPath(info.filePath());
            recovery.project =
                withAbsolutePaths(readUsableProject(readFile(copy).text(), copy).project, copy.parent_path());
            found.works.push_back(std::move(recovery));
        } catch (const Error&) {
            found.unreadable += moveAside(id);
        }
    }
    return found;
}

void discardRecovery(const QString& id)
{
    if (id.isEmpty())
        return;
    QFile::remove(pathOf(id, copyEnding));
    QFile::remove(pathOf(id, infoEnding));
}

void writeRecovery(const Project& project, const QString& id, const QString& projectFile)
{
    // First, so that a copy always tells what it is of.
    QSaveFile info(pathOf(id, infoEnding));
    if (info.open(QIODevice::WriteOnly)) {
        info.write(QJsonDocument(QJsonObject{{"project", projectFile}}).toJson());
        info.commit();
    }
    saveProject(project, toPath(pathOf(id, copyEnding)));
    QFile::remove(pathOf(id, copyEnding + QStringLiteral(".bak")));
}

QString recoveryLockFile(const QString& id)
{
    return pathOf(id, QStringLiteral(".lock"));
}

} // namespace quadrille
