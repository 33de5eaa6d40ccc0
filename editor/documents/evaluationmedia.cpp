// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/evaluationmedia.h"

#include "editor/documents/evaluationnames.h"
#include "editor/documents/evaluationtexts.h"
#include "editor/jobs/jobrunner.h"

#include <utility>

namespace quadrille {

namespace {

constexpr int evaluationDelay = 200; // milliseconds

QStringList evaluationsOf(const Project& project)
{
    QStringList names;
    for (const EvaluationEntry& entry : project.evaluations)
        names += evaluationName(entry);
    return names;
}

EvaluationMedia::State stateOf(const OpenedEvaluation& opened)
{
    switch (opened.state) {
    case OpenedEvaluation::State::Fresh:
        return EvaluationMedia::State::Fresh;
    case OpenedEvaluation::State::Stale:
        return EvaluationMedia::State::Stale;
    case OpenedEvaluation::State::Impossible:
        break;
    }
    return EvaluationMedia::State::Impossible;
}

} // namespace

EvaluationMedia::EvaluationMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs)
{
    m_delay.setSingleShot(true);
    m_delay.setInterval(evaluationDelay);
    connect(&m_delay, &QTimer::timeout, this, &EvaluationMedia::open);
    connect(&document, &ProjectDocument::changed, this, &EvaluationMedia::follow);
}

EvaluationMedia::~EvaluationMedia() = default;

const EvaluationMedia::ResultState* EvaluationMedia::resultState(const QString& name) const
{
    const auto found = m_media.find(name);
    return found == m_media.end() ? nullptr : &found->second;
}

void EvaluationMedia::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::File)
        return;
    if (event.kind == ChangeEvent::Kind::Reset) {
        for (const auto& [name, resultState] : m_media) {
            if (resultState.job)
                resultState.job->cancel();
        }
        m_media.clear();
    }
    update();
}

/// Those that the project has now; whether they are up to date is looked for soon.
void EvaluationMedia::update()
{
    const QStringList wanted = evaluationsOf(m_document.project());
    for (auto it = m_media.begin(); it != m_media.end();) {
        if (wanted.contains(it->first)) {
            ++it;
            continue;
        }
        if (it->second.job)
            it->second.job->cancel();
        const QString gone = it->first;
        it = m_media.erase(it);
        emit changed(gone);
    }
    for (const QString& name : wanted)
        m_media.try_emplace(name);
    if (!m_media.empty())
        m_delay.start();
}

void EvaluationMedia::open()
{
    if (m_opening)
        m_opening->cancel();
    const QStringList names = evaluationsOf(m_document.project());
    m_opening = m_jobs.start(
        {.name = tr("Looking for evaluations"),
         .receiver = this,
         .failed =
             [this, names](const Error&) {
                 // What is wrong with takes is told where they are opened.
                 take(names, std::vector<OpenedEvaluation>(static_cast<std::size_t>(names.size()),
                                                           {OpenedEvaluation::State::Stale, {}}));
             },
         .background = true},
        [working = m_document.working()](const Progress& progress) {
            return openEvaluations(working, progress);
        },
        [this, names](std::vector<OpenedEvaluation> opened) { take(names, std::move(opened)); });
}

void EvaluationMedia::take(const QStringList& names, std::vector<OpenedEvaluation> opened)
{
    // Another look is due: the project has changed again.
    if (m_delay.isActive())
        return;
    for (int i = 0; i < names.size(); ++i) {
        const auto found = m_media.find(names[i]);
        if (found != m_media.end() && found->second.state != State::Computing)
            take(names[i], std::move(opened[static_cast<std::size_t>(i)]));
    }
}

void EvaluationMedia::take(const QString& name, OpenedEvaluation opened)
{
    ResultState& resultState = m_media.at(name);
    resultState.state = stateOf(opened);
    resultState.error.reset();
    if (resultState.state == State::Fresh)
        resultState.tables = std::move(opened.tables);
    emit changed(name);
}

void EvaluationMedia::compute(const QString& name)
{
    const auto found = m_media.find(name);
    if (found == m_media.end() || found->second.state == State::Computing)
        return;
    ResultState& resultState = found->second;
    resultState.state = State::Computing;
    resultState.error.reset();
    const auto index = static_cast<std::size_t>(evaluationsOf(m_document.project()).indexOf(name));
    const auto isThere = [this, name] {
        const auto own = m_media.find(name);
        return own != m_media.end() && own->second.state == State::Computing;
    };
    resultState.job = m_jobs.start(
        {.name = tr("Evaluation “%1”").arg(evaluationTitle(name)),
         .receiver = this,
         .stillStands = isThere,
         .failed =
             [this, name](const Error& error) {
                 ResultState& failed = m_media.at(name);
                 failed.state = State::Failed;
                 failed.error = error;
                 emit changed(name);
             }},
        [working = m_document.working(), index](const Progress& progress) {
            return computeEvaluation(working, index, progress);
        },
        [this, name, computed = m_document.project()](OpenedEvaluation opened) {
            take(name, std::move(opened));
            if (computed != m_document.project()) // whether it is of what the project is now
                m_delay.start();
        });
    connectEnd(name, resultState.job);
    emit changed(name);
}

/// Of a job that is stopped nothing else is heard.
void EvaluationMedia::connectEnd(const QString& name, Job* job)
{
    connect(job, &Job::ended, this, [this, name, job](Job::State state) {
        const auto found = m_media.find(name);
        if (state != Job::State::Cancelled || found == m_media.end() || found->second.job != job)
            return;
        found->second.state = State::Opening;
        found->second.job.clear();
        emit changed(name);
        m_delay.start();
    });
}

void EvaluationMedia::stop(const QString& name)
{
    const auto found = m_media.find(name);
    if (found != m_media.end() && found->second.job)
        found->second.job->cancel();
}

} // namespace quadrille
