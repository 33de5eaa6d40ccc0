// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/welcome/samplegoal.h"

#include <QObject>
#include <QPointer>
#include <filesystem>
#include <optional>

namespace quadrille {

class Job;
class Progress;
class ProjectFiles;
class WorkspaceTabs;
struct EditorContext;

/// Copies a sample that was made when the program was built, with those of its results that are there. For
/// the thread of a job.
/// \return its project file; nothing where there is no sample, or it could not be copied whole.
/// \throws Error Cancelled.
std::optional<std::filesystem::path> copySample(const std::filesystem::path& shipped,
                                                const std::filesystem::path& folder,
                                                const Progress& progress);

/// Opens the built-in sample, makes it first where it is not there yet, and leads to what somebody wants to
/// see of it.
class SampleFlow : public QObject
{
    Q_OBJECT

public:
    SampleFlow(EditorContext& context, ProjectFiles& files, WorkspaceTabs& workspaces,
               QObject* parent = nullptr);

    /// Asks whether to save what is open before the sample takes its place. Nothing happens while it is being
    /// made.
    void open(SampleGoal goal);
    /// Stops making the sample.
    void cancel();

signals:
    /// The sample is being made. \param fraction 0 … 1.
    void progressed(quadrille::SampleGoal goal, double fraction);
    /// It is made, or is not going to be.
    void ended();

private:
    void make(SampleGoal goal);
    void show(const QString& file, SampleGoal goal);

    EditorContext& m_context;
    ProjectFiles& m_files;
    WorkspaceTabs& m_workspaces;
    QPointer<Job> m_job;
};

} // namespace quadrille
