// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/stage.h"

namespace quadrille {

std::vector<ResultStage> makeStages(const StageMaking& making)
{
    std::vector<ResultStage> stages;
    for (auto make :
         {makeSequenceStages, makeGraphStages, makeEvaluationStages, makeSheetStages, makeExportStages}) {
        for (ResultStage& stage : make(making))
            stages.push_back(std::move(stage));
    }
    return stages;
}

} // namespace quadrille
