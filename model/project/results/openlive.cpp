// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/openlive.h"

#include "model/project/document/findentry.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/steps/livework.h"

namespace quadrille {

std::vector<std::string> playableSpaces(const Project& project, const std::string& character)
{
    std::vector<std::string> names;
    for (const MotionSpaceEntry& entry : project.motionSpaces) {
        if (!entry.takes.empty() && characterNameOf(project, entry) == character)
            names.push_back(entry.name);
    }
    return names;
}

OpenedLiveGraphPointer openLiveGraph(const ProjectResults& results, const std::string& character,
                                     const Progress& progress)
{
    auto opened = std::make_shared<OpenedLiveGraph>();
    opened->character = character;
    opened->spaces = playableSpaces(results.project(), character);
    if (opened->spaces.empty())
        throwInvalid("There is no motion space to play", QUADRILLE_MESSAGE("Make one of some takes."));
    opened->metresPerUnit = results.project().settings.axes.metresPerUnit;
    const FreshResults fresh = results.get(liveGraphSteps(opened->spaces), progress.part(0, 0.9));
    opened->graph = liveGraphFrom(results.opener(), opened->spaces, fresh.context(), progress.part(0.9, 1));
    for (const std::string& space : opened->spaces) {
        auto& takes = opened->takes.emplace_back();
        for (const SpaceTakeEntry& take : findMotionSpace(results.project(), space)->takes)
            takes.push_back(results.opener()->open(take.sequence, Progress(progress.token()))->sequence);
    }
    progress.report(1);
    return opened;
}

} // namespace quadrille
