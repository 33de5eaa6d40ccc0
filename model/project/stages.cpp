// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/message.h"
#include "model/project/madeclips.h"
#include "model/project/stage.h"

#include <algorithm>
#include <map>
#include <set>

namespace quadrille {

namespace {

/// Each stage after its inputs, otherwise in the order in which they are. \pre They go round in no circle.
std::vector<ResultStage> inOrder(std::vector<ResultStage> stages)
{
    std::map<std::string, std::size_t> indexOf;
    for (std::size_t i = 0; i < stages.size(); ++i)
        indexOf[stages[i].name] = i;
    std::vector<bool> isPlaced(stages.size(), false);
    std::vector<ResultStage> ordered;
    ordered.reserve(stages.size());
    const std::function<void(std::size_t)> place = [&](std::size_t i) {
        if (isPlaced[i])
            return;
        isPlaced[i] = true;
        for (const std::string& input : stages[i].inputs)
            place(indexOf.at(input));
        ordered.push_back(std::move(stages[i]));
    };
    for (std::size_t i = 0; i < stages.size(); ++i)
        place(i);
    return ordered;
}

} // namespace

void refuseMissingInputs(std::vector<ResultStage>& stages)
{
    std::set<std::string> made;
    for (const ResultStage& stage : stages)
        made.insert(stage.name);
    for (ResultStage& stage : stages) {
        const auto missing =
            std::erase_if(stage.inputs, [&](const std::string& input) { return made.count(input) == 0; });
        if (missing == 0)
            continue;
        stage.files = [name = stage.name](const Progress&) -> std::vector<std::filesystem::path> {
            throw Error(
                ErrorCode::ProjectInvalid,
                {{},
                 {},
                 {{"reason", "There are no takes that “" + name + "” could be made from"},
                  {"remedy", QUADRILLE_MESSAGE("Add the takes of its character under “sequences”.")}}});
        };
    }
}

std::vector<std::string> clipInputs(const Project& project, const std::vector<std::string>& sequences)
{
    std::vector<std::string> inputs;
    for (const std::string& name : sequences) {
        for (std::string& stage : clipStagesOf(project, "sequences/" + name)) {
            if (std::find(inputs.begin(), inputs.end(), stage) == inputs.end())
                inputs.push_back(std::move(stage));
        }
    }
    return inputs;
}

std::vector<ResultStage> makeStages(const StageMaking& making)
{
    std::vector<ResultStage> stages;
    for (auto make : {makeSequenceStages, makeGraphStages, makeAnimationStages, makeVariationStages,
                      makeEvaluationStages, makeSheetStages, makeExportStages}) {
        for (ResultStage& stage : make(making))
            stages.push_back(std::move(stage));
    }
    refuseMissingInputs(stages);
    return inOrder(std::move(stages));
}

} // namespace quadrille
