// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/welcome/sampleflow.h"

#include "editor/application/projectfiles.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/workspaces/workspacetabs.h"
#include "model/sample/sample.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <filesystem>
#include <vector>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

constexpr const char* projectName = "sample.quadrille";

QString sampleFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/sample");
}

/// The sample as it comes with the program.
fs::path shippedSample()
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

std::optional<fs::path> copySample(const fs::path& shipped, const fs::path& folder, const Progress& progress)
{
    std::error_code failure;
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator file(shipped, failure); !failure && file != fs::end(file);
         file.increment(failure)) {
        if (file->is_regular_file(failure) && file->path().filename() != projectName)
            files.push_back(file->path().lexically_relative(shipped));
    }
    if (failure || files.empty())
        return {};
    files.emplace_back(projectName); // at last: a sample without it is made anew
    for (std::size_t i = 0; i < files.size(); ++i) {
        progress.report(static_cast<double>(i) / static_cast<double>(files.size()));
        const fs::path place = folder / files[i];
        fs::create_directories(place.parent_path(), failure);
        if (!failure)
            fs::copy_file(shipped / files[i], place, fs::copy_options::overwrite_existing, failure);
        if (failure)
            return {};
    }
    return folder / projectName;
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
    const QString file = sampleFolder() + QLatin1Char('/') + QLatin1String(projectName);
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
            const auto copied = copySample(shippedSample(), folder, progress);
            return copied ? *copied : writeSample(folder, {}, progress);
        },
        [this, goal](const fs::path& made) {
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

#include "moc_sampleflow.cpp"
