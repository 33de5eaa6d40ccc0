// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/projectfiles.h"

#include "editor/application/projectquestions.h"
#include "editor/application/recoveries.h"
#include "editor/context/settings.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/errors/issuelog.h"
#include "editor/results/giveresults.h"
#include "model/core/file.h"
#include "model/project/file/projectfile.h"
#include "model/project/file/usableproject.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace quadrille {

namespace {

const QString projectEnding = QStringLiteral(".quadrille");

/// What has no effect in a project, or may not be meant. What cannot be read is told elsewhere.
void addWarnings(const std::filesystem::path& file, IssueLog& issues)
{
    for (const ProjectProblem& problem : readUsableProject(readFile(file).text(), file).problems) {
        if (problem.severity != ProjectProblem::Severity::Warning)
            continue;
        const ErrorText text = describe(Error(problem.code, problem.context));
        const QString whole = (text.sentence + QLatin1Char(' ') + text.remedy).trimmed();
        Issue issue{.code = Issue::Code::Other, .context = problem.context};
        issue.context.values = {{"text", whole.toStdString()}};
        issues.add(issue);
    }
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
    connect(&document, &ProjectDocument::changed, this, &ProjectFiles::follow);
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
    m_document.settle();
    if (!m_document.isModified())
        return true;
    const auto answer = QMessageBox::question(
        m_window, tr("Unsaved edits"), tr("Save the edits in “%1”?").arg(m_document.title()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool ProjectFiles::load(const QString& file)
{
    const auto path = std::filesystem::absolute(toPath(file)).lexically_normal();
    try {
        const bool isOpen = openWith(
            path, [&] { m_document.load(path); },
            [&] {
                const ProjectReading reading = readUsableProject(readFile(path).text(), path);
                return withAbsolutePaths(reading.project, path.parent_path());
            });
        if (isOpen && !m_document.isUntitled())
            m_settings.addRecentProject(toQString(path));
        if (isOpen)
            run([&] { addWarnings(path, m_issues); });
        return isOpen;
    } catch (const Error& error) {
        return openBackup(path, error);
    }
}

/// Opens a file that nobody else works on; else as the user wants it.
/// \param copy the project for a copy.
bool ProjectFiles::openWith(const std::filesystem::path& file, const Show& show,
                            const std::function<Project()>& copy)
{
    using questions::Locked;
    const bool isOurs = file == m_guard.file() && m_guard.access() == ProjectGuard::Access::Full;
    auto lock = isOurs ? m_guard.lock() : ProjectGuard::lockOf(file);
    if (lock->state() == ProjectLock::State::Foreign) {
        const QString title = toQString(file.stem());
        switch (questions::askLocked(m_window, title, describe(*lock->holder()))) {
        case Locked::Cancel:
            return false;
        case Locked::TakeOver:
            lock->takeOver();
            break;
        case Locked::ReadOnly:
            break;
        case Locked::OpenCopy: {
            Project project = copy();
            emit aboutToLeave();
            // First, so that what looks for results finds them.
            giveResults(file, m_document.untitledFile(), m_jobs, m_issues, m_window);
            m_document.reset(std::move(project));
            return true;
        }
        }
    }
    emit aboutToLeave();
    show();
    m_guard.watch(m_document.file(), std::move(lock));
    return true;
}

bool ProjectFiles::openBackup(const std::filesystem::path& file, const Error& error)
{
    std::filesystem::path backup = file;
    backup += ".bak";
    Project project;
    try {
        project =
            withAbsolutePaths(readUsableProject(readFile(backup).text(), backup).project, file.parent_path());
    } catch (const Error&) {
        report(error);
        return false;
    }
    const QDateTime saved = QFileInfo(toQString(backup)).lastModified();
    const bool isNewer = error.code() == ErrorCode::ProjectNewer;
    if (isNewer ||
        !questions::mayOpenBackup(m_window, toQString(file.stem()), describe(error).oneLine(), saved)) {
        report(error);
        return false;
    }
    return openWith(
        file, [&] { m_document.recover(project, file); }, [&] { return project; });
}

bool ProjectFiles::recover(const Recovery& recovery)
{
    if (!mayClose())
        return false;
    if (!recovery.projectFile.isEmpty()) {
        const auto file = toPath(recovery.projectFile);
        return openWith(
            file, [&] { m_document.recover(recovery.project, file); }, [&] { return recovery.project; });
    }
    emit aboutToLeave();
    m_document.reset(recovery.project, true);
    return true;
}

void ProjectFiles::reload()
{
    if (!m_document.isModified() || questions::mayReload(m_window, m_document.title()))
        readAgain();
}

void ProjectFiles::readAgain()
{
    if (m_document.isUntitled())
        return;
    const auto file = m_document.file();
    emit aboutToLeave();
    if (run([&] { m_document.load(file); }))
        m_guard.noteContent();
}

void ProjectFiles::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset && m_document.isUntitled())
        m_guard.release();
}

void ProjectFiles::open(const QString& file)
{
    if (mayClose())
        load(file);
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
    using questions::Changed;
    using questions::Unwritable;
    if (m_document.isUntitled())
        return saveAs();
    m_guard.lookNow();
    if (m_guard.access() != ProjectGuard::Access::Full) {
        const bool isTakenOver = m_guard.access() == ProjectGuard::Access::TakenOver;
        const auto answer = questions::askUnwritable(m_window, whyUnwritable(), isTakenOver);
        if (answer == Unwritable::SaveAs)
            return saveAs();
        if (answer == Unwritable::TakeOver)
            m_guard.takeOver();
        if (m_guard.access() != ProjectGuard::Access::Full)
            return false;
    }
    if (m_guard.isChanged()) {
        const auto answer = questions::askChanged(m_window, m_document.title());
        if (answer == Changed::SaveAs)
            return saveAs();
        if (answer == Changed::Reload)
            readAgain();
        if (answer != Changed::Overwrite)
            return false;
    }
    if (!run([this] { m_document.save(); }))
        return false;
    m_guard.noteContent();
    emit saved();
    return true;
}

QString ProjectFiles::whyUnwritable() const
{
    const QString title = m_document.title();
    switch (m_guard.access()) {
    case ProjectGuard::Access::Full:
        return {};
    case ProjectGuard::Access::ReadOnly:
        return tr("“%1” is open read only.").arg(title);
    case ProjectGuard::Access::NotWritable:
        return tr("The folder of “%1” cannot be written to.").arg(title);
    case ProjectGuard::Access::TakenOver:
        return tr("“%1” was taken over: %2.").arg(title, m_guard.holder());
    }
    return {};
}

bool ProjectFiles::saveAs()
{
    const QString name = m_document.title() + projectEnding;
    const QString suggested =
        m_document.isUntitled() ? name : toQString(m_document.file().parent_path() / toPath(name));
    QString file = QFileDialog::getSaveFileName(m_window, tr("Save project"), suggested,
                                                tr("Quadrille projects (*%1)").arg(projectEnding));
    if (file.isEmpty())
        return false;
    if (!file.endsWith(projectEnding))
        file += projectEnding;
    return saveTo(std::filesystem::absolute(toPath(file)).lexically_normal());
}

bool ProjectFiles::saveTo(const std::filesystem::path& file)
{
    if (file == m_guard.file() && m_guard.access() == ProjectGuard::Access::Full)
        return save();
    auto lock = ProjectGuard::lockOf(file);
    if (lock->state() == ProjectLock::State::Foreign) {
        QMessageBox::warning(m_window, tr("Save project"),
                             tr("“%1” is open elsewhere: %2. Choose another name.")
                                 .arg(toQString(file.stem()), describe(*lock->holder())));
        return false;
    }
    giveResults(m_document.workingFile(), file, m_jobs, m_issues, m_window);
    if (!run([&] { m_document.saveAs(file); }))
        return false;
    m_guard.watch(file, std::move(lock));
    m_settings.addRecentProject(toQString(file));
    emit saved();
    return true;
}

} // namespace quadrille

#include "moc_projectfiles.cpp"
