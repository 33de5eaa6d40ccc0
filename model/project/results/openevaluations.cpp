// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/openevaluations.h"

#include "model/project/store/dataitem.h"

#include <algorithm>

namespace quadrille {

namespace {

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

void addTables(OpenedEvaluation& opened, const BuildStep& step, const Result& result)
{
    for (const DataTable& table : result.tables) {
        DataItem& item = opened.tables.emplace_back();
        item.name = step.dataPrefix + "/" + table.name;
        item.character = step.character;
        item.isFresh = true;
        item.content = table;
    }
}

OpenedEvaluation openedFrom(const std::vector<const BuildStep*>& steps, const RebuildReport& report,
                            const ProjectResults& results)
{
    const FreshResults fresh = results.freshOf(report);
    OpenedEvaluation opened;
    for (const BuildStep* step : steps) {
        opened.state = OpenedEvaluation::State::Fresh;
        if (!fresh.has(step->name))
            return {.state = OpenedEvaluation::State::Stale, .tables = {}};
        try {
            addTables(opened, *step, *fresh.resultOf(step->name));
        } catch (const Error& error) {
            if (error.code() != ErrorCode::ResultReplaced)
                throw;
            return {.state = OpenedEvaluation::State::Stale, .tables = {}};
        }
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

std::vector<OpenedEvaluation> openEvaluations(const WorkingProject& working, const Progress& progress)
{
    const ProjectResults results(working);
    std::vector<std::vector<const BuildStep*>> own;
    std::vector<std::string> targets;
    for (const EvaluationEntry& evaluation : working.project.evaluations) {
        own.push_back(evaluationStepsOf(results.steps(), working.project, evaluation));
        for (const std::string& name : stepNames(own.back()))
            targets.push_back(name);
    }
    const RebuildReport report = results.bring(targets, progress, {.dryRun = true});
    std::vector<OpenedEvaluation> opened;
    opened.reserve(own.size());
    for (const auto& each : own)
        opened.push_back(openedFrom(each, report, results));
    return opened;
}

OpenedEvaluation computeEvaluation(const WorkingProject& working, std::size_t index, const Progress& progress)
{
    const ProjectResults results(working);
    const auto own =
        evaluationStepsOf(results.steps(), working.project, working.project.evaluations.at(index));
    if (own.empty())
        return {};
    const RebuildReport report = results.bring(stepNames(own), progress);
    for (const StepReport& step : report.steps) {
        if (step.state == StepState::Failed)
            throw Error(*step.error);
    }
    return openedFrom(own, report, results);
}

} // namespace quadrille
