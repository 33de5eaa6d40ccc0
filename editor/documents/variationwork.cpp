// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/variationwork.h"

#include "editor/documents/drawnresults.h"
#include "model/project/document/madeclips.h"
#include "model/project/steps/variationresults.h"
#include "model/project/steps/variationsteps.h"
#include "model/variation/reconstructionerror.h"

#include <algorithm>
#include <mutex>
#include <optional>

namespace quadrille {

namespace {

using Models = std::vector<GpdmLearning>;

const VariationEntry& entryOf(const VariationJob& job)
{
    return *std::ranges::find(job.working.project.variations, job.name, &VariationEntry::name);
}

std::vector<std::string> modelSteps(const VariationJob& job)
{
    std::vector<std::string> steps;
    for (const std::string& part : partNamesOf(job.working.project, entryOf(job)))
        steps.push_back(modelStepOf(job.name, part));
    return steps;
}

Models modelsOf(const std::vector<std::string>& steps, const FreshResults& results)
{
    Models models;
    models.reserve(steps.size());
    for (const std::string& step : steps)
        models.push_back(learningOf(*results.resultOf(step)));
    return models;
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

std::shared_ptr<const LearnedVariation> learnedOf(const Movement& movement, Models models,
                                                  const Progress& progress)
{
    auto learned = std::make_shared<LearnedVariation>();
    learned->parts = partsOf(movement, models, progress);
    learned->models = std::move(models);
    return learned;
}

/// What is known of models while their steps learn them.
class LearningWatch
{
public:
    LearningWatch(std::vector<std::string> steps, const Movement& movement,
                  const std::function<void(const std::vector<PartProgress>&)>& watch)
        : m_steps(std::move(steps)), m_watch(watch), m_best(m_steps.size())
    {
        for (const BodyPart& part : movement.parts.parts)
            m_parts.push_back({.part = part.name});
    }

    void take(const std::string& step, const Result& result)
    {
        const auto found = std::ranges::find(m_steps, step);
        if (found == m_steps.end())
            return;
        GpdmLearning learning = learningOf(result);
        const std::scoped_lock lock(m_mutex);
        const auto part = static_cast<std::size_t>(found - m_steps.begin());
        m_parts[part].objective = learning.objective;
        m_parts[part].state = learning.state;
        m_best[part] = std::move(learning);
        m_watch(m_parts);
    }

    /// The best of each part; one that nothing was learned of yet starts.
    Models stopped(const Movement& movement, const GpdmSettings& settings) const
    {
        CancelToken token;
        token.cancel();
        Models models;
        for (std::size_t p = 0; p < m_best.size(); ++p) {
            const PartTraining& training = movement.training[p];
            models.push_back(m_best[p] ? *m_best[p]
                                       : learnGpdm(training.rows, training.spans, settings, Progress(token)));
        }
        return models;
    }

private:
    std::vector<std::string> m_steps;
    const std::function<void(const std::vector<PartProgress>&)>& m_watch;
    std::mutex m_mutex;
    std::vector<PartProgress> m_parts;
    std::vector<std::optional<GpdmLearning>> m_best;
};

/// The project's steps, with models that were stopped in the place of those that a rebuild would learn.
std::vector<BuildStep> stepsWith(const Models& models, const std::vector<std::string>& names,
                                 const OpenedVariation& opened, std::vector<BuildStep> steps)
{
    for (BuildStep& step : steps) {
        const auto found = std::ranges::find(names, step.name);
        if (found == names.end())
            continue;
        const auto part = static_cast<std::size_t>(found - names.begin());
        const GpdmLearning& model = models[part];
        step.settings += " stopped after " + std::to_string(model.objective.size()) + " at " +
                         std::to_string(model.objective.empty() ? 0.0 : model.objective.back());
        step.compute = [model, movement = opened.movement, part](const StepContext&, const Progress&) {
            const PartTraining& training = movement->training[part];
            return modelResult(training, model, std::vector<std::string>(training.spans.size()));
        };
    }
    return steps;
}

} // namespace

bool LearnedVariation::isStopped() const
{
    return std::ranges::any_of(models,
                               [](const GpdmLearning& model) { return model.stop == GpdmStop::Cancelled; });
}

OpenedVariation openVariation(const VariationJob& job, const Progress& progress)
{
    constexpr double aligning = 0.7;
    constexpr double reading = 0.8;
    OpenedVariation opened;
    const VariationEntry& entry = entryOf(job);
    const ProjectResults results(job.working);
    VariationWork work(results.opener(), entry, job.working.session);
    opened.movement = work.movement(progress.part(0, aligning));
    for (const TrainingEntry& take : entry.training)
        opened.takes.push_back(results.opener()->open(take.sequence)->sequence);
    opened.drawing = drawingOf(entry);
    const std::vector<std::string> steps = modelSteps(job);
    try {
        const auto models = results.getIfFresh(steps, progress.part(aligning, reading));
        if (!models)
            return opened;
        opened.learned = learnedOf(*opened.movement, modelsOf(steps, *models), progress.part(reading, 1));
        if (const auto drawn = results.getIfFresh(drawnSteps(job), Progress(progress.token())))
            opened.drawn = readDrawn(job, opened, *drawn, Progress(progress.token()));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::ResultReplaced) // somebody else computes them
            throw;
    }
    return opened;
}

std::shared_ptr<const LearnedVariation>
learnVariation(const VariationJob& job, const OpenedVariation& opened, const Progress& progress,
               const std::function<void(const std::vector<PartProgress>&)>& watch)
{
    const std::vector<std::string> steps = modelSteps(job);
    LearningWatch learning(steps, *opened.movement, watch);
    RebuildOptions options;
    options.improved = [&](const std::string& step, const Result& result) { learning.take(step, result); };
    try {
        const FreshResults results = ProjectResults(job.working).get(steps, progress, options);
        return learnedOf(*opened.movement, modelsOf(steps, results), Progress());
    } catch (const Error& error) {
        // Who stops learning wants what was found by then.
        if (error.code() != ErrorCode::Cancelled)
            throw;
        return learnedOf(*opened.movement, learning.stopped(*opened.movement, entryOf(job).learning),
                         Progress());
    }
}

std::shared_ptr<const std::vector<DrawnSet>> drawVariations(const VariationJob& job,
                                                            const OpenedVariation& opened,
                                                            const LearnedVariation& learned,
                                                            const Progress& progress)
{
    const ProjectResults results(job.working);
    if (!learned.isStopped())
        return readDrawn(job, opened, results.get(drawnSteps(job), progress), Progress(progress.token()));
    const std::vector<BuildStep> steps = stepsWith(learned.models, modelSteps(job), opened, results.steps());
    const RebuildReport report = rebuild(
        steps, job.working.file,
        {.targets = drawnSteps(job), .session = job.working.session, .onlyInMemory = true}, progress, {});
    for (const StepReport& step : report.steps) {
        if (step.error)
            throw Error(*step.error);
    }
    return readDrawn(job, opened, FreshResults(job.working, steps, report), Progress(progress.token()));
}

} // namespace quadrille
