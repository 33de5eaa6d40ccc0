// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"
#include "editor/documents/projectguard.h"

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <vector>

class QWidget;

namespace quadrille {

class IssueLog;
class JobRunner;
class Settings;
struct Recovery;

/// What the File menu does: new, open and save. What fails is told and leaves the open project as it was.
/// Nothing that somebody else wrote is overwritten without being asked.
class ProjectFiles : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    ProjectFiles(ProjectDocument& document, JobRunner& jobs, IssueLog& issues, Settings& settings,
                 QWidget* window);

    /// Whether a path is that of a project, by its ending.
    static bool isProject(const QString& file);
    /// Asks whether unsaved edits shall be saved. A project without unsaved edits is not asked about. Blocks
    /// until it is answered. \return false when the user rather goes on as it is.
    bool mayClose();
    /// Opens a project file without asking about the open one. One that is open elsewhere is asked about.
    /// Where it cannot be read, the copy of before the last save is offered.
    /// \return whether it is open now.
    bool load(const QString& file);
    /// Opens a project file in the place of the one that is open, after asking whether to save that.
    void open(const QString& file);
    /// Opens what a crash left unsaved, after asking whether to save what is open. \return whether it is
    /// open.
    bool recover(const Recovery& recovery);

    /// Whether the open project may be saved, and who wrote its file meanwhile.
    ProjectGuard& guard() { return m_guard; }

    /// Writes the project to another file, unless that is open elsewhere. Its results go along.
    bool saveTo(const std::filesystem::path& file);

public slots:
    void newProject();
    void askOpen();
    bool save();
    bool saveAs();
    /// Opens the file of the project again, after asking whether unsaved edits may go.
    void reload();

signals:
    /// Another project takes the place of the open one.
    void aboutToLeave();
    /// The project was written to its file.
    void saved();
    /// Something failed, in the user's words.
    void failed(const QString& message);

private:
    using Show = std::function<void()>;

    bool run(const std::function<void()>& action);
    void report(const Error& error);
    bool openWith(const std::filesystem::path& file, const Show& show, const std::function<Project()>& copy);
    bool openBackup(const std::filesystem::path& file, const Error& error);
    void readAgain();
    QString whyUnwritable() const;
    void follow(const ChangeEvent& event);

    ProjectDocument& m_document;
    JobRunner& m_jobs;
    IssueLog& m_issues;
    Settings& m_settings;
    QWidget* m_window;
    ProjectGuard m_guard;
};

} // namespace quadrille
