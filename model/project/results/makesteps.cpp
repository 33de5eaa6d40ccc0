// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/makesteps.h"

#include "model/core/message.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/exports/exportsteps.h"

#include <algorithm>
#include <map>
#include <set>

namespace quadrille {

namespace {

/// Each step after its inputs, otherwise in the order in which they are. \pre They go round in no circle.
std::vector<BuildStep> inOrder(std::vector<BuildStep> steps)
{
    std::map<std::string, std::size_t> indexOf;
    for (std::size_t i = 0; i < steps.size(); ++i)
        indexOf[steps[i].name] = i;
    std::vector<bool> isPlaced(steps.size(), false);
    std::vector<BuildStep> ordered;
    ordered.reserve(steps.size());
    const std::function<void(std::size_t)> place = [&](std::size_t i) {
        if (isPlaced[i])
            return;
        isPlaced[i] = true;
        for (const std::string& input : steps[i].inputs)
            place(indexOf.at(input));
        ordered.push_back(std::move(steps[i]));
    };
    for (std::size_t i = 0; i < steps.size(); ++i)
        place(i);
    return ordered;
}

} // namespace

void refuseMissingInputs(std::vector<BuildStep>& steps)
{
    std::set<std::string> made;
    for (const BuildStep& step : steps)
        made.insert(step.name);
    for (BuildStep& step : steps) {
        const auto missing =
            std::erase_if(step.inputs, [&](const std::string& input) { return made.count(input) == 0; });
        if (missing == 0)
            continue;
        step.files = [name = step.name](const Progress&) -> std::vector<std::filesystem::path> {
            throwInvalid("There are no takes that “" + name + "” could be made from",
                         QUADRILLE_MESSAGE("Add the takes of its character under “sequences”."));
        };
    }
}

std::vector<BuildStep> makeSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (auto make : {makeSequenceSteps, makeGraphSteps, makeAnimationSteps, makeVariationSteps,
                      makeMotionSpaceSteps, makeLiveSteps, makeAppearanceSteps, makeTransferSteps,
                      makeProjectionSteps, makeEvaluationSteps, makeSheetSteps, makeExportSteps}) {
        for (BuildStep& step : make(making))
            steps.push_back(std::move(step));
    }
    refuseMissingInputs(steps);
    return inOrder(std::move(steps));
}

} // namespace quadrille
