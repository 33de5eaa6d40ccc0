// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/openmotionspace.h"

#include "model/core/message.h"
#include "model/project/document/findentry.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/steps/motionspacesteps.h"

#include <algorithm>

namespace quadrille {

namespace {

MotionSpaceWork workOf(const ProjectResults& results, const std::string& name)
{
    const MotionSpaceEntry* entry = findMotionSpace(results.project(), name);
    if (entry == nullptr)
        throwInvalid("There is no motion space “" + name + "”", QUADRILLE_MESSAGE("Correct the name."));
    if (entry->takes.empty())
        throwInvalid("The motion space “" + name + "” has no takes", "Name them under “takes”.");
    return {results.opener(), *entry};
}

} // namespace

std::shared_ptr<const MotionSpace> openMotionSpace(const ProjectResults& results, const std::string& name,
                                                   const Progress& progress)
{
    const MotionSpaceWork work = workOf(results, name);
    const FreshResults fresh = results.get({motionSpaceStepOf(name)}, progress);
    return sharedMotionSpace(work, fresh.context(), Progress(progress.token()));
}

std::shared_ptr<const SimilarityTable> openSimilarities(const ProjectResults& results,
                                                        const std::string& source, const std::string& target,
                                                        const Progress& progress)
{
    if (workOf(results, source).character() != workOf(results, target).character() || source == target)
        throwInvalid("No transition leads from the motion space “" + source + "” to “" + target + "”",
                     "Name two motion spaces of one character.");
    const FreshResults fresh = results.get({similarityStepOf(source, target)}, progress);
    return sharedSimilarities(source, target, fresh.context());
}

MotionSpaceResultPointer openMotionSpaceResult(const ProjectResults& results, const std::string& name,
                                               const Progress& progress)
{
    const MotionSpaceWork work = workOf(results, name);
    const std::string quality = motionSpaceQualityStepOf(name);
    const FreshResults fresh = results.get({motionSpaceStepOf(name), quality}, progress);
    auto made = std::make_shared<MotionSpaceResult>();
    made->entry = work.entry();
    made->space = sharedMotionSpace(work, fresh.context(), Progress(progress.token()));
    const ResultPointer stored = fresh.resultOf(quality);
    made->error = *std::ranges::find(stored->tables, "error", &DataTable::name);
    made->parameters = *std::ranges::find(stored->tables, "parameters", &DataTable::name);
    return made;
}

} // namespace quadrille
