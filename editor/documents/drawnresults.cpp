// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/drawnresults.h"

#include "model/project/document/madeclips.h"
#include "model/project/steps/variationresults.h"
#include "model/project/steps/variationsteps.h"
#include "model/project/store/clipresult.h"

#include <algorithm>

namespace quadrille {

namespace {

const VariationEntry& drawnEntryOf(const VariationJob& job)
{
    return *std::ranges::find(job.working.project.variations, job.name, &VariationEntry::name);
}

std::vector<std::string> samplesSteps(const VariationJob& job)
{
    std::vector<std::string> steps;
    for (const std::string& part : partNamesOf(job.working.project, drawnEntryOf(job)))
        steps.push_back(samplesStepOf(job.name, part));
    return steps;
}

std::string clipStep(const VariationJob& job, int number)
{
    return clipStepOf(variationClip(job.name, number));
}

/// Trajectories of all parts of each candidate, of one set after the other.
std::vector<std::vector<LatentVariation>> latentsOf(const VariationEntry& entry,
                                                    const std::vector<ResultPointer>& samples)
{
    std::vector<std::vector<LatentVariation>> sets;
    for (const SamplesEntry& each : entry.samples)
        sets.emplace_back(static_cast<std::size_t>(candidatesFor(each.count)));
    for (const ResultPointer& part : samples) {
        std::vector<RowMatrix> all = trajectoriesOf(*part);
        std::size_t next = 0;
        for (auto& set : sets) {
            for (LatentVariation& variation : set)
                variation.push_back(std::move(all.at(next++)));
        }
    }
    return sets;
}

/// What a selection says of a set, without its variations. \param spreads  of all parts.
DrawnSet drawnSetOf(const VariationSelection& selection, const std::vector<SampleSpread>& spreads)
{
    DrawnSet set;
    for (const SampleSpread& spread : spreads) {
        set.spread += spread.share / static_cast<double>(spreads.size());
        set.isSpreadGuess = set.isSpreadGuess || spread.isGuess;
    }
    set.rejected = selection.rejectedCount();
    for (const Candidate& candidate : selection.candidates) {
        for (const VariationFault fault : candidate.faults)
            set.faults.at(static_cast<std::size_t>(fault)) += candidate.isAccepted() ? 0 : 1;
    }
    return set;
}

} // namespace

std::vector<std::string> drawnSteps(const VariationJob& job)
{
    std::vector<std::string> steps = samplesSteps(job);
    steps.push_back(selectionStepOf(job.name));
    for (int number = 1; number <= variationCount(drawnEntryOf(job)); ++number)
        steps.push_back(clipStep(job, number));
    return steps;
}

std::shared_ptr<const std::vector<DrawnSet>> readDrawn(const VariationJob& job, const OpenedVariation& opened,
                                                       const FreshResults& results, const Progress& progress)
{
    const VariationEntry& entry = drawnEntryOf(job);
    std::vector<ResultPointer> parts;
    for (const std::string& step : samplesSteps(job))
        parts.push_back(results.resultOf(step));
    const auto latents = latentsOf(entry, parts);
    std::vector<std::vector<SampleSpread>> spreads(entry.samples.size());
    for (const ResultPointer& part : parts) {
        const auto own = spreadsOf(*part, spreads.size());
        for (std::size_t s = 0; s < spreads.size(); ++s)
            spreads[s].insert(spreads[s].end(), own[s].begin(), own[s].end());
    }
    const auto selections = selectionsOf(*results.resultOf(selectionStepOf(job.name)), entry);
    const CharacterFrames takes(opened.takes);
    auto sets = std::make_shared<std::vector<DrawnSet>>();
    int before = 0;
    for (std::size_t s = 0; s < selections.size(); ++s) {
        DrawnSet& set = sets->emplace_back(drawnSetOf(selections[s], spreads[s]));
        for (std::size_t i = 0; i < selections[s].accepted.size(); ++i) {
            progress.report(0);
            const auto candidate = static_cast<std::size_t>(selections[s].accepted[i]);
            DrawnVariation drawn{.number = before + static_cast<int>(i) + 1,
                                 .inSet = static_cast<int>(i) + 1};
            auto clip = clipOf(*results.resultOf(clipStep(job, drawn.number)), opened.takes,
                               opened.movement->alignment.fps);
            if (!clip)
                throw Error(ErrorCode::ResultReplaced, {.values = {{"stage", clipStep(job, drawn.number)}}});
            const std::string name = variationClip(job.name, drawn.number);
            drawn.sequence =
                toSequence(name.substr(name.find('/') + 1), shownAsVariation(std::move(*clip)), takes);
            drawn.latents = latents.at(s).at(candidate);
            drawn.quality = selections[s].candidates[candidate].quality;
            set.variations.push_back(std::move(drawn));
        }
        before += entry.samples[s].count;
    }
    return sets;
}

} // namespace quadrille
