// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/opencharacter.h"

#include "model/project/document/paths.h"
#include "model/project/steps/rebuild.h"
#include "model/project/store/resultstore.h"

#include <algorithm>
#include <map>

namespace quadrille {

namespace {

/// The keys of steps whose results are all there.
using StepKeys = std::map<std::string, std::string>;

StepKeys keysOf(const RebuildReport& report)
{
    StepKeys keys;
    for (const StepReport& step : report.steps) {
        if (step.state == StepState::Failed)
            throw Error(*step.error);
        keys[step.step] = step.key;
    }
    return keys;
}

} // namespace

std::shared_ptr<const OpenedCharacter> openCharacter(Project project,
                                                     const std::filesystem::path& projectFile,
                                                     const std::string& character, GraphOpening opening,
                                                     const Progress& progress)
{
    const GraphEntry graph = graphOf(project, character);
    const auto isIts = [&](const GraphEntry& entry) { return isGraphOf(project, entry, character); };
    if (std::none_of(project.graphs.begin(), project.graphs.end(), isIts))
        project.graphs.push_back(graph);
    const std::filesystem::path results = cacheFolder(projectFile);
    const auto opener =
        std::make_shared<SequenceOpener>(std::move(project), projectFolder(projectFile), results);
    const CharacterInputs work = characterWork(opener, graph);
    if (work.sequences.empty())
        return nullptr;
    constexpr double computing = 0.9;
    const RebuildReport report =
        rebuild(makeSteps({opener, projectFile}), projectFile,
                {.targets = CharacterGraph::inputs(work), .dryRun = opening == GraphOpening::IfFresh},
                progress.part(0, computing), {});
    const StepKeys keys = keysOf(report);
    if (report.count(StepState::Stale) > 0)
        return nullptr;
    const ResultStore store(results);
    std::map<std::string, Result> loaded;
    for (const std::string& step : CharacterGraph::inputs(work)) {
        ResultStore::Entry entry = store.load(step, keys.at(step));
        if (entry.state != ResultStore::State::Fresh) // replaced by somebody else in the meantime
            return nullptr;
        loaded[step] = std::move(entry.result);
    }
    const StepContext context{.resultOf = [&](const std::string& step) { return loaded.at(step); },
                              .tell = [](const Issue&) { /* told when the sequences were opened */ }};
    CharacterFrames frames = work.open(progress.part(computing, 1));
    return std::shared_ptr<const OpenedCharacter>(
        new OpenedCharacter{std::move(frames), CharacterGraph(work, context)});
}

} // namespace quadrille
