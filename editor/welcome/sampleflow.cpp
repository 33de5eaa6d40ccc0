// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/welcome/sampleflow.h"

#include "editor/application/editorcontext.h"
#include "editor/application/projectfiles.h"
#include "editor/documents/projectpaths.h"
#include "editor/workspaces/workspacetabs.h"
#include "model/project/stage.h"
#include "model/sample/sample.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

namespace quadrille {

namespace {

QString sampleFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/sample");
}

/// What comes with the program of the sample's results, since it would take longest to compute.
std::filesystem::path shippedResults()
{
    return toPath(QCoreApplication::applicationDirPath()) / "../share/quadrille/sample";
}

/// The first animation that follows a path; empty without one.
QString pathAnimation(const Project& project)
{
    const auto follows = [](const AnimationEntry& animation) {
        return std::ranges::any_of(animation.constraints, [](const auto& constraint) {
            return std::holds_alternative<PathEntry>(constraint);
        });
    };
    const auto found = std::ranges::find_if(project.animations, follows);
    return found == project.animations.end() ? QString() : QString::fromStdString(found->name);
}

} // namespace

void addResults(const std::filesystem::path& results, const std::filesystem::path& projectFile)
{
    constexpr auto all =
        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing;
    std::error_code none; // what is not there is computed
    std::filesystem::copy(results, cacheFolder(projectFile), all, none);
}

SampleFlow::SampleFlow(EditorContext& context, ProjectFiles& files, WorkspaceTabs& workspaces,
                       QObject* parent)
    : QObject(parent), m_context(context), m_files(files), m_workspaces(workspaces)
{
    // Who opens something else meanwhile does not wait for the sample any more.
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind == ChangeEvent::Kind::Reset)
            cancel();
    });
}

void SampleFlow::open(SampleGoal goal)
{
    if (m_job)
        return;
    const QString file = sampleFolder() + QStringLiteral("/sample.quadrille");
    if (QFileInfo::exists(file))
        show(file, goal);
    else
        make(goal);
}

void SampleFlow::make(SampleGoal goal)
{
    m_job = m_context.jobs.start(
        {.name = tr("Making the sample character"), .receiver = this},
        [folder = toPath(sampleFolder())](const Progress& progress) {
            std::filesystem::path made = writeSample(folder, {}, progress);
            addResults(shippedResults(), made);
            return made;
        },
        [this, goal](const std::filesystem::path& made) {
            m_job = nullptr;
            show(toQString(made), goal);
        });
    connect(m_job, &Job::changed, this,
            [this, goal, job = m_job.data()] { emit progressed(goal, job->fraction()); });
    connect(m_job, &Job::ended, this, &SampleFlow::ended);
    emit progressed(goal, 0);
}

void SampleFlow::cancel()
{
    if (m_job)
        m_job->cancel();
}

void SampleFlow::show(const QString& file, SampleGoal goal)
{
    if (!m_files.mayClose() || !m_files.load(file))
        return;
    switch (goal) {
    case SampleGoal::Play:
        m_workspaces.select(QStringLiteral("sequences"));
        break;
    case SampleGoal::Transitions:
        m_workspaces.select(QStringLiteral("graph"));
        m_context.graphs.ask(m_context.graphs.firstCharacter());
        break;
    case SampleGoal::Path:
        if (const QString name = pathAnimation(m_context.document.project()); !name.isEmpty())
            m_context.selection.selectAnimations({name});
        m_workspaces.select(QStringLiteral("animate"));
        break;
    }
    if (goal != SampleGoal::Transitions)
        m_workspaces.currentWorkspace()->view().playWhenReady();
}

} // namespace quadrille
