// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/evaluations/openevaluations.h"

#include "model/project/document/paths.h"
#include "model/project/steps/rebuild.h"
#include "model/project/store/resultstore.h"

#include <algorithm>
#include <map>
#include <memory>

namespace quadrille {

namespace {

std::vector<BuildStep> stepsOfProject(const Project& project, const std::filesystem::path& projectFile)
{
    const auto opener =
        std::make_shared<SequenceOpener>(project, projectFolder(projectFile), cacheFolder(projectFile));
    return makeSteps({opener, projectFile});
}

/// The steps of an evaluation: one for each character that it is about.
std::vector<const BuildStep*> evaluationStepsOf(const std::vector<BuildStep>& steps, const Project& project,
                                                const EvaluationEntry& evaluation)
{
    const std::string name = "evaluations/" + evaluation.table;
    const auto isOfAnother = [&](const std::string& character) {
        return std::any_of(project.evaluations.begin(), project.evaluations.end(),
                           [&](const EvaluationEntry& other) {
                               return other.table == evaluation.table && other.character == character;
                           });
    };
    std::vector<const BuildStep*> own;
    for (const BuildStep& step : steps) {
        const bool isTable = step.name == name || step.name.starts_with(name + "/");
        const bool isIts = evaluation.character.empty() ? !isOfAnother(step.character)
                                                        : evaluation.character == step.character;
        if (isTable && isIts)
            own.push_back(&step);
    }
    return own;
}

void addTables(OpenedEvaluation& opened, const BuildStep& step, Result result)
{
    for (DataTable& table : result.tables) {
        DataItem& item = opened.tables.emplace_back();
        item.name = step.dataPrefix + "/" + table.name;
        item.character = step.character;
        item.isFresh = true;
        item.content = std::move(table);
    }
}

OpenedEvaluation openedFrom(const std::vector<const BuildStep*>& steps, const RebuildReport& report,
                            const ResultStore& store)
{
    OpenedEvaluation opened;
    for (const BuildStep* step : steps) {
        opened.state = OpenedEvaluation::State::Fresh;
        const auto found = std::find_if(report.steps.begin(), report.steps.end(),
                                        [&](const StepReport& each) { return each.step == step->name; });
        const bool isThere = found != report.steps.end() &&
                             (found->state == StepState::Fresh || found->state == StepState::Computed);
        ResultStore::Entry entry;
        if (isThere)
            entry = store.load(step->name, found->key);
        if (entry.state != ResultStore::State::Fresh)
            return {.state = OpenedEvaluation::State::Stale, .tables = {}};
        addTables(opened, *step, std::move(entry.result));
    }
    return opened;
}

std::vector<std::string> stepNames(const std::vector<const BuildStep*>& steps)
{
    std::vector<std::string> names;
    names.reserve(steps.size());
    for (const BuildStep* step : steps)
        names.push_back(step->name);
    return names;
}

} // namespace

std::vector<OpenedEvaluation>
openEvaluations(const Project& project, const std::filesystem::path& projectFile, const Progress& progress)
{
    const std::vector<BuildStep> steps = stepsOfProject(project, projectFile);
    std::vector<std::vector<const BuildStep*>> own;
    std::vector<std::string> targets;
    for (const EvaluationEntry& evaluation : project.evaluations) {
        own.push_back(evaluationStepsOf(steps, project, evaluation));
        for (const std::string& name : stepNames(own.back()))
            targets.push_back(name);
    }
    RebuildReport report;
    if (!targets.empty())
        report = rebuild(steps, projectFile, {.targets = targets, .dryRun = true}, progress, {});
    const ResultStore store(cacheFolder(projectFile));
    std::vector<OpenedEvaluation> opened;
    opened.reserve(own.size());
    for (const auto& each : own)
        opened.push_back(openedFrom(each, report, store));
    return opened;
}

OpenedEvaluation computeEvaluation(const Project& project, const std::filesystem::path& projectFile,
                                   std::size_t index, const Progress& progress)
{
    const std::vector<BuildStep> steps = stepsOfProject(project, projectFile);
    const auto own = evaluationStepsOf(steps, project, project.evaluations.at(index));
    if (own.empty())
        return {};
    const RebuildReport report = rebuild(steps, projectFile, {.targets = stepNames(own)}, progress, {});
    for (const StepReport& step : report.steps) {
        if (step.state == StepState::Failed)
            throw Error(*step.error);
    }
    return openedFrom(own, report, ResultStore(cacheFolder(projectFile)));
}

} // namespace quadrille
