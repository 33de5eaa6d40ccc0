// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/openevaluations.h"

#include "model/project/paths.h"
#include "model/project/rebuild.h"
#include "model/project/resultstore.h"

#include <algorithm>
#include <map>
#include <memory>

namespace quadrille {

namespace {

std::vector<ResultStage> stagesOfProject(const Project& project, const std::filesystem::path& projectFile)
{
    const auto opener =
        std::make_shared<SequenceOpener>(project, projectFolder(projectFile), cacheFolder(projectFile));
    return makeStages({opener, projectFile});
}

/// The stages of an evaluation: one for each character that it is about.
std::vector<const ResultStage*> evaluationStagesOf(const std::vector<ResultStage>& stages,
                                                   const Project& project, const EvaluationEntry& evaluation)
{
    const std::string name = "evaluations/" + evaluation.table;
    const auto isOfAnother = [&](const std::string& character) {
        return std::any_of(project.evaluations.begin(), project.evaluations.end(),
                           [&](const EvaluationEntry& other) {
                               return other.table == evaluation.table && other.character == character;
                           });
    };
    std::vector<const ResultStage*> own;
    for (const ResultStage& stage : stages) {
        const bool isTable = stage.name == name || stage.name.starts_with(name + "/");
        const bool isIts = evaluation.character.empty() ? !isOfAnother(stage.character)
                                                        : evaluation.character == stage.character;
        if (isTable && isIts)
            own.push_back(&stage);
    }
    return own;
}

void addTables(OpenedEvaluation& opened, const ResultStage& stage, Result result)
{
    for (DataTable& table : result.tables) {
        DataItem& item = opened.tables.emplace_back();
        item.name = stage.dataPrefix + "/" + table.name;
        item.character = stage.character;
        item.isFresh = true;
        item.content = std::move(table);
    }
}

OpenedEvaluation openedFrom(const std::vector<const ResultStage*>& stages, const RebuildReport& report,
                            const ResultStore& store)
{
    OpenedEvaluation opened;
    for (const ResultStage* stage : stages) {
        opened.state = OpenedEvaluation::State::Fresh;
        const auto found = std::find_if(report.stages.begin(), report.stages.end(),
                                        [&](const StageReport& each) { return each.stage == stage->name; });
        const bool isThere = found != report.stages.end() &&
                             (found->state == StageState::Fresh || found->state == StageState::Computed);
        ResultStore::Entry entry;
        if (isThere)
            entry = store.load(stage->name, found->key);
        if (entry.state != ResultStore::State::Fresh)
            return {.state = OpenedEvaluation::State::Stale, .tables = {}};
        addTables(opened, *stage, std::move(entry.result));
    }
    return opened;
}

std::vector<std::string> stageNames(const std::vector<const ResultStage*>& stages)
{
    std::vector<std::string> names;
    names.reserve(stages.size());
    for (const ResultStage* stage : stages)
        names.push_back(stage->name);
    return names;
}

} // namespace

std::vector<OpenedEvaluation>
openEvaluations(const Project& project, const std::filesystem::path& projectFile, const Progress& progress)
{
    const std::vector<ResultStage> stages = stagesOfProject(project, projectFile);
    std::vector<std::vector<const ResultStage*>> own;
    std::vector<std::string> targets;
    for (const EvaluationEntry& evaluation : project.evaluations) {
        own.push_back(evaluationStagesOf(stages, project, evaluation));
        for (const std::string& name : stageNames(own.back()))
            targets.push_back(name);
    }
    RebuildReport report;
    if (!targets.empty())
        report = rebuild(stages, projectFile, {.targets = targets, .dryRun = true}, progress, {});
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
    const std::vector<ResultStage> stages = stagesOfProject(project, projectFile);
    const auto own = evaluationStagesOf(stages, project, project.evaluations.at(index));
    if (own.empty())
        return {};
    const RebuildReport report = rebuild(stages, projectFile, {.targets = stageNames(own)}, progress, {});
    for (const StageReport& stage : report.stages) {
        if (stage.state == StageState::Failed)
            throw Error(*stage.error);
    }
    return openedFrom(own, report, ResultStore(cacheFolder(projectFile)));
}

} // namespace quadrille
