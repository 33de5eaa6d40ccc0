// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/projectresults.h"

#include "model/project/document/paths.h"
#include "model/project/results/makesteps.h"
#include "model/project/results/stepstate.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"

#include <utility>

namespace quadrille {

FreshResults::FreshResults(const WorkingProject& working, const std::vector<BuildStep>& steps,
                           const RebuildReport& report)
    : m_session(working.session), m_store(cacheFolder(working.file), working.session->results())
{
    for (const StepReport& step : report.steps) {
        if (step.state == StepState::Fresh || step.state == StepState::Computed)
            m_steps[step.step].key = step.key;
    }
    for (const BuildStep& step : steps) {
        if (const auto found = m_steps.find(step.name); found != m_steps.end())
            found->second.kind = step.kind.empty() ? step.name : step.kind;
    }
}

ResultPointer FreshResults::resultOf(const std::string& step) const
{
    const Step& own = m_steps.at(step);
    if (ResultPointer kept = m_session->results()->find(own.kind, own.key))
        return kept;
    ResultPointer stored = m_store.freshResult(step, own.key);
    m_session->results()->keep(own.kind, own.key, stored);
    return stored;
}

StepContext FreshResults::context() const
{
    return {.resultOf = [self = *this](const std::string& step) { return self.resultOf(step); },
            .keyOf = [self = *this](const std::string& step) { return self.keyOf(step); },
            .tell = [](const Issue&) { /* told by the step */ },
            .session = m_session};
}

ProjectResults::ProjectResults(WorkingProject working)
    : m_working(std::move(working))
    , m_opener(std::make_shared<SequenceOpener>(m_working.project, projectFolder(m_working.file),
                                                cacheFolder(m_working.file), m_working.session->sources()))
    , m_steps(makeSteps({m_opener, m_working.file, m_working.session}))
{
}

RebuildReport ProjectResults::bring(const std::vector<std::string>& steps, const Progress& progress,
                                    RebuildOptions options) const
{
    if (steps.empty())
        return {};
    options.targets = steps;
    options.session = m_working.session;
    return rebuild(m_steps, m_working.file, options, progress, {});
}

FreshResults ProjectResults::get(const std::vector<std::string>& steps, const Progress& progress,
                                 RebuildOptions options) const
{
    const RebuildReport report = bring(steps, progress, std::move(options));
    for (const StepReport& step : report.steps) {
        if (!step.error)
            continue;
        ErrorContext context = step.error->context();
        context.values.emplace_back("step", step.step);
        throw Error(step.error->code(), std::move(context));
    }
    return freshOf(report);
}

ResultPointer ProjectResults::stored(const std::string& step, const Progress& progress) const
{
    const auto folder = cacheFolder(m_working.file);
    const std::vector<BuildStep> steps = selectSteps(m_steps, {step});
    const StepStatus status = stepKeys(steps, m_working.session->hashes(folder), progress).back();
    if (status.error)
        throw Error(*status.error);
    const ResultStore::Entry entry = ResultStore(folder, m_working.session->results()).load(step, status.key);
    return entry.state == ResultStore::State::Fresh ? entry.result : nullptr;
}

std::optional<FreshResults> ProjectResults::getIfFresh(const std::vector<std::string>& steps,
                                                       const Progress& progress) const
{
    const RebuildReport report = bring(steps, progress, {.dryRun = true});
    for (const StepReport& step : report.steps) {
        if (step.state == StepState::Failed)
            throw Error(*step.error);
    }
    if (report.count(StepState::Stale) > 0)
        return std::nullopt;
    return freshOf(report);
}

} // namespace quadrille
