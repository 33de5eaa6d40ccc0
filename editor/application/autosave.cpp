// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/autosave.h"

#include "editor/documents/projectpaths.h"
#include "editor/jobs/jobrunner.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>
#include <utility>

namespace quadrille {

namespace {

QDir recoveryFolder()
{
    QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
    folder.mkpath(QStringLiteral("recovery"));
    folder.cd(QStringLiteral("recovery"));
    return folder;
}

QString pathOf(const QString& id, const char* ending)
{
    return recoveryFolder().filePath(id + QLatin1Char('.') + QLatin1String(ending));
}

void removeFiles(const QString& id)
{
    if (id.isEmpty())
        return;
    QFile::remove(pathOf(id, "json"));
    QFile::remove(pathOf(id, "quadrille"));
}

/// Copies keep absolute paths: they lie in another folder than the project.
void writeCopy(const Project& project, const QString& id, const QString& projectFile)
{
    saveProject(project, toPath(pathOf(id, "quadrille")));
    QFile::remove(pathOf(id, "quadrille.bak"));
    QSaveFile info(pathOf(id, "json"));
    if (info.open(QIODevice::WriteOnly)) {
        info.write(QJsonDocument(QJsonObject{{"project", projectFile}}).toJson());
        info.commit();
    }
}

} // namespace

QString Recovery::title() const
{
    return projectFile.isEmpty() ? Autosave::tr("Untitled") : QFileInfo(projectFile).completeBaseName();
}

Autosave::Autosave(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_jobs(jobs)
    , m_id(QUuid::createUuid().toString(QUuid::WithoutBraces))
    , m_lock(std::make_unique<QLockFile>(pathOf(m_id, "lock")))
{
    m_lock->setStaleLockTime(0);
    m_lock->tryLock(0);
    connect(&document, &ProjectDocument::changed, this, &Autosave::follow);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::copyNow);
}

Autosave::~Autosave()
{
    removeCopy();
}

void Autosave::setInterval(int seconds)
{
    if (seconds > 0)
        m_timer.start(seconds * 1000);
    else
        m_timer.stop();
}

void Autosave::follow(const ChangeEvent& /*event*/)
{
    ++m_revision;
    m_isDirty = m_document.isModified();
    if (!m_isDirty)
        removeCopy();
}

void Autosave::copyNow()
{
    if (!m_isDirty)
        return;
    m_isDirty = false;
    const QString file = m_document.isUntitled() ? QString() : toQString(m_document.file());
    m_jobs.start(
        {.name = tr("Keeping a copy of “%1”").arg(m_document.title()), .receiver = this, .background = true},
        [project = m_document.project(), id = m_id, file](const Progress&) { writeCopy(project, id, file); },
        [this] {
            removeFiles(std::exchange(m_adopted, {}));
            if (!m_document.isModified())
                removeCopy();
        });
}

void Autosave::adopt(const Recovery& recovery)
{
    m_adopted = recovery.id;
    copyNow();
}

void Autosave::removeCopy()
{
    removeFiles(m_id);
    removeFiles(std::exchange(m_adopted, {}));
}

std::optional<Recovery> Autosave::findRecovery()
{
    const QDir folder = recoveryFolder();
    const QFileInfoList copies = folder.entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Time);
    for (const QFileInfo& info : copies) {
        const QString id = info.completeBaseName();
        QLockFile lock(pathOf(id, "lock"));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0))
            continue;
        QFile file(info.filePath());
        if (!file.open(QIODevice::ReadOnly))
            continue;
        Recovery recovery;
        recovery.id = id;
        recovery.projectFile = QJsonDocument::fromJson(file.readAll())["project"].toString();
        recovery.saved = info.lastModified();
        try {
            const auto copy = toPath(pathOf(id, "quadrille"));
            recovery.project = withAbsolutePaths(loadProject(copy), copy.parent_path());
            return recovery;
        } catch (const Error&) {
            removeFiles(id); // a copy that cannot be read is of no use to anybody
        }
    }
    return std::nullopt;
}

void Autosave::discard(const Recovery& recovery)
{
    removeFiles(recovery.id);
}

} // namespace quadrille
