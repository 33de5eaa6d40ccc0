// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/projectfiles.h"

#include "editor/application/settings.h"
#include "editor/commands/projectedits.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/errors/issuelog.h"
#include "editor/jobs/jobrunner.h"
#include "model/project/importsequences.h"
#include "model/sample/sample.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStandardPaths>

namespace quadrille {

namespace {

const QString projectEnding = QStringLiteral(".quadrille");

/// What a job that brings sequences in hands back.
struct Addition
{
    std::vector<SequenceEntry> sequences;
    std::vector<CharacterEntry> characters;
    std::vector<Issue> issues;
};

Addition makeAddition(Project project, const ImportRequest& request, const Progress& progress)
{
    const std::filesystem::path folder = request.sources.front().root_path();
    const std::size_t sequences = project.sequences.size();
    const std::size_t characters = project.characters.size();
    ImportReport report = addSequences(project, folder, request, false, progress);
    project = withAbsolutePaths(std::move(project), folder);
    Addition addition;
    addition.sequences.assign(project.sequences.begin() + static_cast<std::ptrdiff_t>(sequences),
                              project.sequences.end());
    addition.characters.assign(project.characters.begin() + static_cast<std::ptrdiff_t>(characters),
                               project.characters.end());
    addition.issues = std::move(report.issues);
    return addition;
}

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
    if (!run([&] { m_document.load(toPath(file)); }))
        return false;
    m_settings.addRecentProject(QFileInfo(file).absoluteFilePath());
    return true;
}

void ProjectFiles::open(const QStringList& files)
{
    std::vector<std::filesystem::path> sources;
    for (const QString& file : files) {
        if (!file.endsWith(projectEnding))
            sources.push_back(toPath(QFileInfo(file).absoluteFilePath()));
        else if (mayClose())
            load(file);
    }
    if (!sources.empty())
        addSequences(sources);
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

void ProjectFiles::addSequences(const std::vector<std::filesystem::path>& sources)
{
    for (const auto& source : sources) {
        ImportRequest request;
        request.sources = {source};
        m_jobs.start(
            {.name = tr("Opening %1").arg(toQString(source.filename())),
             .receiver = this,
             .failed = [this](const Error& error) { report(error); }},
            [project = m_document.project(), request](const Progress& progress) {
                return makeAddition(project, request, progress);
            },
            [this](Addition addition) {
                const QStringList names = quadrille::addSequences(m_document, std::move(addition.sequences),
                                                                  std::move(addition.characters));
                for (const Issue& issue : addition.issues)
                    m_issues.add(issue, names.value(0));
                emit sequencesAdded(names);
            });
    }
}

void ProjectFiles::newProject()
{
    if (mayClose())
        m_document.reset({});
}

void ProjectFiles::askOpen()
{
    const QString file = QFileDialog::getOpenFileName(m_window, tr("Open project"), {},
                                                      tr("Quadrille projects (*%1)").arg(projectEnding));
    if (!file.isEmpty())
        open({file});
}

void ProjectFiles::askImport()
{
    const QStringList files = QFileDialog::getOpenFileNames(m_window, tr("Bring in sequences"));
    if (!files.isEmpty())
        open(files);
}

bool ProjectFiles::save()
{
    if (m_document.isUntitled())
        return saveAs();
    return run([this] { m_document.save(); });
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
    return true;
}

} // namespace quadrille
