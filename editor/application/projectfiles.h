// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <vector>

class QWidget;

namespace quadrille {

class IssueLog;
class JobRunner;
class Settings;

/// What the File menu does: new, open, save, and the sample. What fails is told and leaves the open project
/// as it was.
class ProjectFiles : public QObject
{
    Q_OBJECT

public:
    /// \param window what dialogs belong to.
    ProjectFiles(ProjectDocument& document, JobRunner& jobs, IssueLog& issues, Settings& settings,
                 QWidget* window);

    /// Whether a path is that of a project, by its ending.
    static bool isProject(const QString& file);
    /// Asks whether unsaved edits shall be saved. \return false when the user rather goes on as it is.
    bool mayClose();
    /// Opens a project file without asking anything. \return whether it is open now.
    bool load(const QString& file);
    /// Opens a project file in the place of the one that is open, after asking whether to save that.
    void open(const QString& file);
    /// Opens the built-in sample; makes it first where it is not there yet.
    void openSample();

public slots:
    void newProject();
    void askOpen();
    bool save();
    bool saveAs();

signals:
    /// Another project takes the place of the open one.
    void aboutToLeave();
    void saved();
    /// Something failed, in the user's words.
    void failed(const QString& message);

private:
    bool run(const std::function<void()>& action);
    void report(const Error& error);

    ProjectDocument& m_document;
    JobRunner& m_jobs;
    IssueLog& m_issues;
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace quadrille
