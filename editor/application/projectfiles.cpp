// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/projectfiles.h"

#include "editor/application/settings.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/errors/issuelog.h"
#include "editor/jobs/jobrunner.h"
#include "model/sample/sample.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStandardPaths>

namespace quadrille {

namespace {

const QString projectEnding = QStringLiteral(".quadrille");

} // namespace

ProjectFiles::ProjectFiles(ProjectDocument& document, JobRunner& jobs, IssueLog& issues, Settings& settings,
                           QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_jobs(jobs)
    , m_issues(issues)
    , m_settings(settings)
    , m_window(window)
{
}

void ProjectFiles::report(const Error& error)
{
    m_issues.add(error);
    emit failed(describe(error).oneLine());
}

bool ProjectFiles::run(const std::function<void()>& action)
{
    try {
        action();
        return true;
    } catch (const Error& error) {
        report(error);
        return false;
    }
}

bool ProjectFiles::isProject(const QString& file)
{
    return file.endsWith(projectEnding);
}

bool ProjectFiles::mayClose()
{
    if (!m_document.isModified())
        return true;
    const auto answer = QMessageBox::question(
        m_window, tr("Unsaved edits"), tr("Save the edits in “%1”?").arg(m_document.title()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool ProjectFiles::load(const QString& file)
{
    emit aboutToLeave();
    if (!run([&] { m_document.load(toPath(file)); }))
        return false;
    m_settings.addRecentProject(QFileInfo(file).absoluteFilePath());
    return true;
}

void ProjectFiles::open(const QString& file)
{
    if (mayClose())
        load(file);
}

void ProjectFiles::openSample()
{
    if (!mayClose())
        return;
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/sample");
    const QString file = folder + QStringLiteral("/sample") + projectEnding;
    if (QFileInfo::exists(file)) {
        load(file);
        return;
    }
    m_jobs.start(
        {.name = tr("Making the sample character"),
         .receiver = this,
         .failed = [this](const Error& error) { report(error); }},
        [folder = toPath(folder)](const Progress& progress) { return writeSample(folder, {}, progress); },
        [this](const std::filesystem::path& made) { load(toQString(made)); });
}

void ProjectFiles::newProject()
{
    if (!mayClose())
        return;
    emit aboutToLeave();
    m_document.reset({});
}

void ProjectFiles::askOpen()
{
    const QString file = QFileDialog::getOpenFileName(m_window, tr("Open project"), {},
                                                      tr("Quadrille projects (*%1)").arg(projectEnding));
    if (!file.isEmpty())
        open(file);
}

bool ProjectFiles::save()
{
    if (m_document.isUntitled())
        return saveAs();
    if (!run([this] { m_document.save(); }))
        return false;
    emit saved();
    return true;
}

bool ProjectFiles::saveAs()
{
    QString file =
        QFileDialog::getSaveFileName(m_window, tr("Save project"), m_document.title() + projectEnding,
                                     tr("Quadrille projects (*%1)").arg(projectEnding));
    if (file.isEmpty())
        return false;
    if (!file.endsWith(projectEnding))
        file += projectEnding;
    if (!run([&] { m_document.saveAs(toPath(file)); }))
        return false;
    m_settings.addRecentProject(file);
    emit saved();
    return true;
}

} // namespace quadrille
