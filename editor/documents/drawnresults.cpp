// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/drawnresults.h"

#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/clipresult.h"
#include "model/project/steps/rebuild.h"
#include "model/project/steps/variationsteps.h"
#include "model/project/store/resultstore.h"
#include "model/variation/selectionspread.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace quadrille {

namespace {

const VariationEntry& drawnEntryOf(const VariationJob& job)
{
    return *std::ranges::find(job.project.variations, job.name, &VariationEntry::name);
}

std::vector<BuildStep> stepsOf(const VariationJob& job)
{
    auto opener =
        std::make_shared<SequenceOpener>(job.project, projectFolder(job.file), cacheFolder(job.file));
    return makeSteps({std::move(opener), job.file});
}

std::vector<std::string> samplesSteps(const VariationJob& job)
{
    std::vector<std::string> steps;
    for (const std::string& part : partNamesOf(job.project, drawnEntryOf(job)))
        steps.push_back(samplesStepOf(job.name, part));
    return steps;
}

std::string clipStep(const VariationJob& job, int number)
{
    return clipStepOf(variationClip(job.name, number));
}

/// Trajectories of all parts of each candidate, of one set after the other.
std::vector<std::vector<LatentVariation>> latentsOf(const VariationEntry& entry,
                                                    const std::vector<Result>& samples)
{
    std::vector<std::vector<LatentVariation>> sets;
    for (const SamplesEntry& each : entry.samples)
        sets.emplace_back(static_cast<std::size_t>(candidatesFor(each.count)));
    for (const Result& part : samples) {
        std::vector<RowMatrix> all = trajectoriesOf(part);
        std::size_t next = 0;
        for (auto& set : sets) {
            for (LatentVariation& variation : set)
                variation.push_back(std::move(all.at(next++)));
        }
    }
    return sets;
}

/// The trajectories of one part.
PartVariations partOf(const LatentVariations& latents, std::size_t part)
{
    PartVariations own{.trajectories = {}, .reports = latents.reports.at(part)};
    for (const LatentVariation& variation : latents.variations)
        own.trajectories.push_back(variation.at(part));
    return own;
}

/// Makes steps of an entry out of what was drawn already.
class Keeping
{
public:
    Keeping(const VariationJob& job, const OpenedVariation& opened, const LearnedMovement& learned,
            const DrawnDraft& draft)
        : m_job(job), m_opened(opened), m_learned(learned), m_draft(draft)
    {
        const std::vector<std::string> samples = samplesSteps(job);
        for (std::size_t part = 0; part < samples.size(); ++part)
            m_results[samples[part]] = [this, part](const Progress&) { return samplesOf(part); };
        m_results[selectionStepOf(job.name)] = [this](const Progress& progress) {
            return selection(progress);
        };
        for (int number = 1; number <= variationCount(drawnEntryOf(job)); ++number)
            m_results[clipStep(job, number)] = [](const Progress&) { return Result(); };
        int before = 0;
        for (std::size_t set = 0; set < draft.selections.size(); ++set) {
            for (std::size_t i = 0; i < draft.selections[set].clips.size(); ++i)
                m_results[clipStep(job, before + static_cast<int>(i) + 1)] = [this, set, i](const Progress&) {
                    return clip(m_draft.selections[set].clips[i]);
                };
            before += drawnEntryOf(job).samples[set].count;
        }
    }

    std::vector<std::string> names() const
    {
        std::vector<std::string> names;
        for (const auto& [name, make] : m_results)
            names.push_back(name);
        return names;
    }

    /// The project's steps: those of the entry are there, nothing else is computed.
    std::vector<BuildStep> steps() const
    {
        std::vector<BuildStep> steps = stepsOf(m_job);
        for (BuildStep& step : steps) {
            const auto found = m_results.find(step.name);
            if (found == m_results.end())
                step.compute = [](const StepContext&, const Progress&) -> Result {
                    throw Error(ErrorCode::Cancelled);
                };
            else
                step.compute = [make = found->second](const StepContext&, const Progress& progress) {
                    return make(progress);
                };
        }
        return steps;
    }

private:
    Result samplesOf(std::size_t part) const
    {
        std::vector<PartVariations> sets;
        for (const LatentVariations& latents : m_draft.latents)
            sets.push_back(partOf(latents, part));
        return samplesResult(sets, m_opened.movement->alignment.frameCount(),
                             m_learned.state(part).latents.cols());
    }

    Result selection(const Progress& progress) const
    {
        const VariationEntry& entry = drawnEntryOf(m_job);
        std::vector<std::vector<PartSpread>> spreads;
        for (std::size_t set = 0; set < m_draft.selections.size(); ++set)
            spreads.push_back(selectionSpread(m_learned, m_draft.latents[set].variations,
                                              m_draft.selections[set],
                                              m_opened.work->poses(entry, Progress(progress.token())),
                                              entry.samples[set].seed, Progress(progress.token())));
        return selectionResult(entry, m_draft.selections, spreads);
    }

    Result clip(const Clip& made) const
    {
        std::vector<std::string> takes;
        for (const TrainingEntry& take : drawnEntryOf(m_job).training)
            takes.push_back(take.sequence);
        return clipResult(m_opened.work->inProjectUnit(made), m_opened.work->layout(), takes,
                          unitText(m_job.project.settings.axes.metresPerUnit));
    }

    const VariationJob& m_job;
    const OpenedVariation& m_opened;
    const LearnedMovement& m_learned;
    const DrawnDraft& m_draft;
    std::map<std::string, std::function<Result(const Progress&)>> m_results;
};

} // namespace

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

namespace {

/// \throws Error ResultReplaced.
std::shared_ptr<const std::vector<DrawnSet>> readFresh(const VariationJob& job, const OpenedVariation& opened,
                                                       const Progress& progress)
{
    const VariationEntry& entry = drawnEntryOf(job);
    const std::vector<std::string> samples = samplesSteps(job);
    std::vector<std::string> targets = samples;
    targets.push_back(selectionStepOf(job.name));
    for (int number = 1; number <= variationCount(entry); ++number)
        targets.push_back(clipStep(job, number));
    const RebuildReport report =
        rebuild(stepsOf(job), job.file, {.targets = targets, .dryRun = true}, progress, {});
    std::map<std::string, std::string> fresh;
    for (const StepReport& step : report.steps) {
        if (step.state == StepState::Fresh)
            fresh[step.step] = step.key;
    }
    const auto isFresh = [&fresh](const std::string& step) { return fresh.contains(step); };
    if (!std::ranges::all_of(samples, isFresh) || !isFresh(selectionStepOf(job.name)))
        return nullptr;
    const ResultStore store(cacheFolder(job.file));
    const auto load = [&](const std::string& step) { return store.freshResult(step, fresh.at(step)); };
    std::vector<Result> drawnParts;
    drawnParts.reserve(samples.size());
    for (const std::string& step : samples)
        drawnParts.push_back(load(step));
    const auto latents = latentsOf(entry, drawnParts);
    std::vector<std::vector<SampleSpread>> spreads(entry.samples.size());
    for (const Result& part : drawnParts) {
        const auto own = spreadsOf(part, spreads.size());
        for (std::size_t s = 0; s < spreads.size(); ++s)
            spreads[s].insert(spreads[s].end(), own[s].begin(), own[s].end());
    }
    const std::vector<VariationSelection> selections = selectionsOf(load(selectionStepOf(job.name)), entry);
    auto sets = std::make_shared<std::vector<DrawnSet>>();
    int before = 0;
    for (std::size_t s = 0; s < selections.size(); ++s) {
        DrawnSet& set = sets->emplace_back(drawnSetOf(selections[s], spreads[s]));
        for (std::size_t i = 0; i < selections[s].accepted.size(); ++i) {
            progress.report(0);
            const auto candidate = static_cast<std::size_t>(selections[s].accepted[i]);
            const int number = before + static_cast<int>(i) + 1;
            const std::string name = variationClip(job.name, number);
            auto clip = isFresh(clipStepOf(name)) ? readClip(cacheFolder(job.file), name, opened.takes,
                                                             opened.movement->alignment.fps)
                                                  : std::nullopt;
            if (!clip)
                return nullptr;
            set.variations.push_back({.number = number,
                                      .inSet = static_cast<int>(i) + 1,
                                      .sequence = std::move(*clip),
                                      .latents = latents.at(s).at(candidate),
                                      .quality = selections[s].candidates[candidate].quality});
        }
        before += entry.samples[s].count;
    }
    return sets;
}

} // namespace

std::shared_ptr<const std::vector<DrawnSet>> readDrawn(const VariationJob& job, const OpenedVariation& opened,
                                                       const Progress& progress)
{
    try {
        return readFresh(job, opened, progress);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::ResultReplaced)
            throw;
        return nullptr;
    }
}

void keepDrawn(const VariationJob& job, const OpenedVariation& opened, const LearnedMovement& learned,
               const DrawnDraft& draft, const Progress& progress)
{
    const Keeping keeping(job, opened, learned, draft);
    const RebuildReport report =
        rebuild(keeping.steps(), job.file, {.targets = keeping.names()}, progress, {});
    for (const StepReport& step : report.steps) {
        if (step.error && step.error->code() != ErrorCode::Cancelled)
            throw Error(*step.error);
    }
}

} // namespace quadrille
