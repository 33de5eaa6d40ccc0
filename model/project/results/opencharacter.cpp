// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/opencharacter.h"

#include <algorithm>

namespace quadrille {

std::shared_ptr<const OpenedCharacter> openCharacter(WorkingProject working, const std::string& character,
                                                     GraphOpening opening, const Progress& progress,
                                                     const OverviewTaker& overview)
{
    Project& project = working.project;
    const auto isIts = [&](const GraphEntry& entry) { return isGraphOf(project, entry, character); };
    if (std::ranges::none_of(project.graphs, isIts))
        project.graphs.push_back(graphOf(project, character));
    return openCharacter(ProjectResults(std::move(working)), character, opening, progress, overview);
}

std::shared_ptr<const OpenedCharacter> openCharacter(const ProjectResults& results,
                                                     const std::string& character, GraphOpening opening,
                                                     const Progress& progress, const OverviewTaker& overview)
{
    const CharacterInputs work = characterWork(results.opener(), graphOf(results.project(), character));
    if (work.sequences.empty())
        return nullptr;
    constexpr double computing = 0.9;
    std::vector<std::string> inputs = CharacterGraph::inputs(work);
    if (overview) {
        const std::string first = work.stepName(graphstep::overview);
        if (const ResultPointer stored = results.stored(first, Progress(progress.token())))
            overview(std::make_shared<const CostOverview>(costOverviewOf(*stored)));
        // Results of older versions need not have it.
        if (opening == GraphOpening::Compute)
            inputs.push_back(first);
    }
    try {
        const std::optional<FreshResults> fresh =
            opening == GraphOpening::IfFresh ? results.getIfFresh(inputs, progress.part(0, computing))
                                             : results.get(inputs, progress.part(0, computing));
        if (!fresh)
            return nullptr;
        CharacterFrames frames = work.open(progress.part(computing, 1));
        return std::shared_ptr<const OpenedCharacter>(
            new OpenedCharacter{std::move(frames), CharacterGraph(work, fresh->context())});
    } catch (const Error& error) {
        if (error.code() != ErrorCode::ResultReplaced)
            throw;
        return nullptr;
    }
}

} // namespace quadrille
