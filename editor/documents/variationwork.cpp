// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/variationwork.h"

#include "editor/documents/drawnresults.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/rebuild.h"
#include "model/project/steps/variationresults.h"
#include "model/project/steps/variationsteps.h"
#include "model/project/store/resultstore.h"
#include "model/variation/reconstructionerror.h"

#include <algorithm>
#include <map>

namespace quadrille {

namespace {

using Models = std::vector<GpdmLearning>;

const VariationEntry& entryOf(const VariationJob& job)
{
    return *std::ranges::find(job.project.variations, job.name, &VariationEntry::name);
}

std::shared_ptr<SequenceOpener> openerOf(const VariationJob& job)
{
    return std::make_shared<SequenceOpener>(job.project, projectFolder(job.file), cacheFolder(job.file));
}

std::vector<std::string> modelSteps(const VariationJob& job)
{
    std::vector<std::string> steps;
    for (const std::string& part : partNamesOf(job.project, entryOf(job)))
        steps.push_back(modelStepOf(job.name, part));
    return steps;
}

/// What was learned before; empty where it is not there, or outdated.
Models readModels(const VariationJob& job, const std::shared_ptr<SequenceOpener>& opener,
                  const Progress& progress)
{
    const std::vector<std::string> steps = modelSteps(job);
    const RebuildReport report =
        rebuild(makeSteps({opener, job.file}), job.file, {.targets = steps, .dryRun = true}, progress, {});
    if (report.hasFailures() || report.count(StepState::Stale) > 0)
        return {};
    std::map<std::string, std::string> keys;
    for (const StepReport& step : report.steps)
        keys[step.step] = step.key;
    const ResultStore store(cacheFolder(job.file));
    Models models;
    for (const std::string& step : steps) {
        ResultStore::Entry entry = store.load(step, keys.at(step));
        if (entry.state != ResultStore::State::Fresh) // replaced by somebody else in the meantime
            return {};
        models.push_back(learningOf(entry.result));
    }
    return models;
}

/// Puts models where a rebuild would put what it learns.
void keepModels(const VariationJob& job, const OpenedVariation& opened, const Models& models,
                const Progress& progress)
{
    progress.report(0);
    const std::vector<std::string> names = modelSteps(job);
    std::vector<BuildStep> steps = makeSteps({openerOf(job), job.file});
    for (BuildStep& step : steps) {
        if (step.name == alignmentStepOf(job.name))
            step.compute = [movement = opened.movement](const StepContext&, const Progress&) {
                return alignmentResult(*movement);
            };
        const auto found = std::ranges::find(names, step.name);
        if (found == names.end())
            continue;
        const auto part = static_cast<std::size_t>(found - names.begin());
        step.compute = [&, part](const StepContext&, const Progress&) {
            return modelResult(opened.movement->training[part], models[part], opened.work->takeNames());
        };
    }
    const RebuildReport report = rebuild(steps, job.file, {.targets = names, .force = true}, progress, {});
    for (const StepReport& step : report.steps) {
        if (step.error)
            throw Error(*step.error);
    }
}

std::vector<PartProgress> partsOf(const Movement& movement, const Models& models, const Progress& progress)
{
    std::vector<PartProgress> parts;
    for (std::size_t p = 0; p < models.size(); ++p) {
        progress.report(static_cast<std::int64_t>(p), static_cast<std::int64_t>(models.size()));
        const GpdmLearning& model = models[p];
        const PartTraining& training = movement.training[p];
        const auto vertices = static_cast<Eigen::Index>(movement.parts.parts[p].vertices.size());
        const auto dimensions = static_cast<int>(model.state.latents.cols());
        parts.push_back({.part = movement.parts.parts[p].name,
                         .objective = model.objective,
                         .state = model.state,
                         .activeBounds = model.activeBounds,
                         .stop = model.stop,
                         .error = modelError(model.state, training.rows, vertices),
                         .pcaError = principalError(training.rows, dimensions, vertices)});
    }
    return parts;
}

std::shared_ptr<const LearnedVariation> learnedOf(const OpenedVariation& opened, Models models,
                                                  const Progress& progress)
{
    auto learned = std::make_shared<LearnedVariation>();
    std::vector<GpdmState> states;
    for (const GpdmLearning& model : models)
        states.push_back(model.state);
    learned->parts = partsOf(*opened.movement, models, progress);
    learned->models = std::move(models);
    learned->movement = std::make_shared<const LearnedMovement>(opened.movement, std::move(states));
    return learned;
}

} // namespace

OpenedVariation openVariation(const VariationJob& job, const Progress& progress)
{
    constexpr double aligning = 0.7;
    constexpr double reading = 0.8;
    OpenedVariation opened;
    const VariationEntry& entry = entryOf(job);
    const auto opener = openerOf(job);
    opened.work = std::make_shared<VariationWork>(opener, entry);
    opened.movement = opened.work->movement(progress.part(0, aligning));
    for (const TrainingEntry& take : entry.training)
        opened.takes.push_back(opener->open(take.sequence)->sequence);
    Models models = readModels(job, opener, progress.part(aligning, reading));
    if (!models.empty())
        opened.learned = learnedOf(opened, std::move(models), progress.part(reading, 1));
    opened.drawing = drawingOf(entry);
    if (opened.learned != nullptr)
        opened.drawn = readDrawn(job, opened, Progress(progress.token()));
    return opened;
}

std::shared_ptr<const LearnedVariation> learnVariation(const VariationJob& job, const OpenedVariation& opened,
                                                       const Progress& progress, const PartWatch& watch)
{
    constexpr double learning = 0.95;
    Models models = learnParts(*opened.movement, entryOf(job).learning, progress.part(0, learning), watch);
    try {
        keepModels(job, opened, models, progress.part(learning, 1));
    } catch (const Error& error) {
        // Who stops learning wants what was found by then.
        if (error.code() != ErrorCode::Cancelled)
            throw;
    }
    return learnedOf(opened, std::move(models), Progress());
}

Drawing drawVariations(const VariationJob& job, const OpenedVariation& opened,
                       const LearnedVariation& learned, const Progress& progress)
{
    constexpr double preparing = 0.1;
    const VariationEntry& entry = entryOf(job);
    const VariationMeter& meter = opened.work->meter(progress.part(0, preparing / 2));
    const VariationPoses poses = opened.work->poses(entry, progress.part(preparing / 2, preparing));
    const CharacterFrames takes(opened.takes);
    auto sets = std::make_shared<std::vector<DrawnSet>>();
    auto draft = std::make_shared<DrawnDraft>();
    int before = 0;
    for (std::size_t s = 0; s < entry.samples.size(); ++s) {
        const double share = (1 - preparing) / static_cast<double>(entry.samples.size());
        const double at = preparing + share * static_cast<double>(s);
        const Progress own = progress.part(at, at + share);
        const SamplesEntry& samples = entry.samples[s];
        const VariationSubject subject = opened.work->subject(samples);
        constexpr double drawing = 0.4;
        LatentVariations latents =
            sampleLatents(*learned.movement, subject, candidatesFor(samples.count), samples.seed,
                          {entry.chain, entry.extent}, own.part(0, drawing));
        VariationSelection selection =
            selectVariations(*learned.movement, subject, latents.variations, samples.count, samples.seed,
                             poses, meter, takes.layout(), entry.limits, own.part(drawing, 1));
        std::vector<SampleSpread> spreads;
        for (const std::vector<SampleReport>& part : latents.reports) {
            for (const SampleReport& report : part)
                spreads.push_back({report.spread, report.isGuess});
        }
        DrawnSet& set = sets->emplace_back(drawnSetOf(selection, spreads));
        for (std::size_t i = 0; i < selection.accepted.size(); ++i) {
            const auto candidate = static_cast<std::size_t>(selection.accepted[i]);
            DrawnVariation drawn{.number = before + static_cast<int>(i) + 1,
                                 .inSet = static_cast<int>(i) + 1};
            drawn.sequence = toSequence(variationClip(entry.name, drawn.number),
                                        opened.work->inProjectUnit(selection.clips[i]), takes);
            drawn.latents = latents.variations[candidate];
            drawn.quality = selection.candidates[candidate].quality;
            set.variations.push_back(std::move(drawn));
        }
        before += samples.count;
        draft->latents.push_back(std::move(latents));
        draft->selections.push_back(std::move(selection));
    }
    return {sets, draft};
}

} // namespace quadrille
