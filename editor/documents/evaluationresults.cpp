// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/evaluationresults.h"

#include "editor/documents/evaluationnames.h"
#include "editor/documents/evaluationtexts.h"

#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds evaluationDelay(200);

QStringList evaluationsOf(const Project& project)
{
    QStringList names;
    for (const EvaluationEntry& entry : project.evaluations)
        names += evaluationName(entry);
    return names;
}

ResultPhase phaseOf(const OpenedEvaluation& opened)
{
    switch (opened.state) {
    case OpenedEvaluation::State::Fresh:
        return ResultPhase::Ready;
    case OpenedEvaluation::State::Stale:
        return ResultPhase::Stale;
    case OpenedEvaluation::State::Impossible:
        break;
    }
    return ResultPhase::Impossible;
}

} // namespace

EvaluationResults::EvaluationResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, std::nullopt, evaluationDelay, parent)
{
}

EvaluationResults::~EvaluationResults() = default;

/// Those that the project has now; whether they are up to date is looked for soon.
void EvaluationResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::File)
        return;
    const QStringList names = evaluationsOf(document().project());
    const bool isOther = event.kind == ChangeEvent::Kind::Reset;
    forget(
        [&](const QString& name, const ResultState& /*state*/) { return isOther || !names.contains(name); });
    for (const QString& name : names) {
        if (find(name) == nullptr)
            make<State>(name);
    }
    if (!names.isEmpty())
        updateSoon();
}

void EvaluationResults::update()
{
    if (m_opening)
        m_opening->cancel();
    const QStringList names = evaluationsOf(document().project());
    m_opening = jobs().start(
        {.name = tr("Looking for evaluations"),
         .receiver = this,
         .failed =
             [this, names](const Error&) {
                 // What is wrong with takes is told where they are opened.
                 take(names, std::vector<OpenedEvaluation>(static_cast<std::size_t>(names.size()),
                                                           {OpenedEvaluation::State::Stale, {}}));
             },
         .background = true},
        [working = document().working()](const Progress& progress) {
            return openEvaluations(working, progress);
        },
        [this, names](std::vector<OpenedEvaluation> opened) { take(names, std::move(opened)); });
}

void EvaluationResults::take(const QStringList& names, std::vector<OpenedEvaluation> opened)
{
    // Another look is due: the project has changed again.
    if (isUpdateDue())
        return;
    for (int i = 0; i < names.size(); ++i) {
        State* const state = find<State>(names[i]);
        if (state == nullptr || state->phase == ResultPhase::Computing)
            continue;
        take(*state, std::move(opened[static_cast<std::size_t>(i)]));
        emit changed(names[i]);
    }
}

void EvaluationResults::take(State& state, OpenedEvaluation opened)
{
    state.phase = phaseOf(opened);
    state.error.reset();
    if (state.phase == ResultPhase::Ready)
        state.tables = std::move(opened.tables);
}

void EvaluationResults::compute(const QString& name)
{
    State* const state = find<State>(name);
    if (state == nullptr || state->phase == ResultPhase::Computing)
        return;
    state->phase = ResultPhase::Computing;
    const auto index = static_cast<std::size_t>(evaluationsOf(document().project()).indexOf(name));
    start(
        name, *state, {.text = tr("Evaluation “%1”").arg(evaluationTitle(name))},
        [working = document().working(), index](const Progress& progress, const Post& /*post*/) {
            return computeEvaluation(working, index, progress);
        },
        [this, computed = document().project()](const QString& current, OpenedEvaluation opened) {
            take(*find<State>(current), std::move(opened));
            if (computed != document().project()) // whether it is of what the project is now
                updateSoon();
        });
}

void EvaluationResults::stopped(const QString& name, ResultState& state)
{
    WantedResults::stopped(name, state);
    updateSoon();
}

} // namespace quadrille

#include "moc_evaluationresults.cpp"
