// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/madeclips.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/steps/variate.h"
#include "model/project/steps/variationresults.h"
#include "model/project/steps/variationsteps.h"
#include "model/project/store/tablebuilder.h"
#include "model/variation/blenderrors.h"
#include "model/variation/preblend.h"
#include "model/variation/reconstructionerror.h"
#include "model/variation/subject.h"

#include <algorithm>

namespace quadrille {

namespace {

using Works = std::vector<std::shared_ptr<VariationWork>>;

Works worksOf(const CharacterInputs& work)
{
    Works works;
    for (const VariationEntry* entry : learnedVariations(work.opener->project(), work.character))
        works.push_back(std::make_shared<VariationWork>(work.opener, *entry));
    return works;
}

/// A step about the models of all variations of a character.
BuildStep modelsStep(const CharacterInputs& work, const EvaluationEntry& evaluation, const Works& works)
{
    BuildStep step = evaluationStep(work, evaluation);
    for (const auto& each : works) {
        for (const std::string& part : partNamesOf(each->project(), each->entry()))
            step.inputs.push_back(modelStepOf(each->entry().name, part));
    }
    return step;
}

GpdmState stateOf(const VariationWork& work, const BodyPart& part, const StepContext& context)
{
    return stateOf(*context.resultOf(modelStepOf(work.entry().name, part.name)));
}

Result reconstructionResult(const Works& works, const StepContext& context, const Progress& progress)
{
    TableBuilder table("cvs-fig4",
                       "How far models reconstruct what they were learned from (CVS Fig. 4): mean "
                       "distance of a vertex, beside principal components of as many dimensions.");
    table.text("variation").text("part").whole("frames").whole("vertices").whole("dimensions");
    table.real("model-error", "m").real("principal-components-error", "m").real("ratio");
    for (std::size_t w = 0; w < works.size(); ++w) {
        progress.report(static_cast<std::int64_t>(w), static_cast<std::int64_t>(works.size()));
        const auto movement = works[w]->movement();
        for (std::size_t p = 0; p < movement->parts.parts.size(); ++p) {
            const BodyPart& part = movement->parts.parts[p];
            const RowMatrix& rows = movement->training[p].rows;
            const GpdmState state = stateOf(*works[w], part, context);
            const auto vertices = static_cast<Eigen::Index>(part.vertices.size());
            const auto dimensions = static_cast<int>(state.latents.cols());
            const double model = modelError(state, rows, vertices);
            const double principal = principalError(rows, dimensions, vertices);
            table.add({works[w]->entry().name, part.name, rows.rows(), vertices, std::int64_t{dimensions},
                       model, principal, model / principal});
        }
    }
    Result result;
    result.tables = {std::move(table).table()};
    return result;
}

/// The learned trajectories of some takes in one part.
std::vector<LatentShare> latentShares(const Movement& movement, std::size_t part, const GpdmState& state,
                                      const std::vector<BlendShare>& shares)
{
    std::vector<LatentShare> latents;
    for (const BlendShare& each : shares) {
        const RowSpan& span = movement.training[part].spans[each.take];
        latents.push_back({state.latents.middleRows(span.first, span.count), each.share});
    }
    return latents;
}

/// The weights half-way between those that were learned.
std::vector<double> weightsBetween(const std::vector<double>& weights)
{
    std::vector<double> between;
    double before = 0;
    for (const double weight : weights) {
        between.push_back((before + weight) / 2);
        before = weight;
    }
    between.push_back((before + 1) / 2);
    return between;
}

/// The blends half-way between those that were learned, of four takes in the middle of each cell.
std::vector<VariationSubject> subjectsBetween(const MovementBlend& blend)
{
    std::vector<VariationSubject> subjects;
    for (const double weight : weightsBetween(blend.weights)) {
        VariationSubject subject{.take = blend.from, .to = blend.to, .weight = weight, .across = {}};
        if (!blend.across) {
            subjects.push_back(subject);
            continue;
        }
        for (const double across : weightsBetween(blend.across->weights)) {
            subject.across = {blend.across->from, blend.across->to, across};
            subjects.push_back(subject);
        }
    }
    return subjects;
}

class BlendTables
{
public:
    BlendTables()
    {
        m_frames.text("blend").real("weight").real("across-weight").text("part").whole("frame");
        m_frames.real("from-takes", "m").real("from-nearby", "m");
        m_means.text("variation").text("blend").real("weight").real("across-weight").text("part");
        m_means.real("from-takes", "m").real("from-nearby", "m").real("ratio");
    }

    void add(VariationWork& work, std::size_t blend, const StepContext& context)
    {
        const auto movement = work.movement();
        const MovementBlend& pair = movement->blends[blend];
        std::string name = nameOf(*movement, pair.from, pair.to);
        if (pair.across)
            name += " × " + nameOf(*movement, pair.across->from, pair.across->to);
        const auto system = std::make_shared<const PoissonSystem>(movement->topology);
        for (const VariationSubject& subject : subjectsBetween(pair)) {
            const std::vector<BlendShare> captured = capturedShares(*movement, subject);
            const std::vector<BlendShare> nearby = subjectTakes(*movement, subject);
            std::vector<TakeShare> takes;
            takes.reserve(captured.size());
            for (const BlendShare& each : captured)
                takes.push_back({&movement->take(each.take), each.share});
            const AlignedTake truth = blendedTake(system, takes, {}, {.up = work.project().settings.axes.up});
            for (std::size_t p = 0; p < movement->parts.parts.size(); ++p) {
                const BodyPart& part = movement->parts.parts[p];
                const PartTraining& training = movement->training[p];
                const GpdmState state = stateOf(work, part, context);
                const PoseReconstruction poses(state, training.rows, training.mean);
                addPart(work.entry().name, name, subject, part.name,
                        blendErrors(poses, latentShares(*movement, p, state, captured),
                                    latentShares(*movement, p, state, nearby), truth, part));
            }
        }
    }

    Result result() &&
    {
        Result result;
        result.tables = {std::move(m_frames).table(), std::move(m_means).table()};
        return result;
    }

private:
    static std::string nameOf(const Movement& movement, std::size_t from, std::size_t to)
    {
        return movement.take(from).name + "–" + movement.take(to).name;
    }

    void addPart(const std::string& variation, const std::string& blend, const VariationSubject& subject,
                 const std::string& part, const BlendErrors& errors)
    {
        const double weight = subject.weight;
        const double across = subject.across ? subject.across->weight : 0;
        for (std::size_t f = 0; f < errors.fromTakes.size(); ++f)
            m_frames.add({blend, weight, across, part, static_cast<std::int64_t>(f), errors.fromTakes[f],
                          errors.fromNearby[f]});
        m_means.add({variation, blend, weight, across, part, errors.meanFromTakes(), errors.meanFromNearby(),
                     errors.meanFromNearby() / errors.meanFromTakes()});
    }

    TableBuilder m_frames{"cvs-fig7",
                          "How far blends that are interpolated in latent space are from the true "
                          "blend of the same weights (CVS Fig. 7b): mean distance of a vertex."};
    TableBuilder m_means{"cvs-fig7-means", "The same over all frames, with the ratio of both."};
};

} // namespace

BuildStep cvsFig4Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    const Works works = worksOf(work);
    BuildStep step = modelsStep(work, evaluation, works);
    step.compute = [works](const StepContext& context, const Progress& progress) {
        return reconstructionResult(works, context, progress);
    };
    return step;
}

BuildStep cvsFig7Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    const Works works = worksOf(work);
    BuildStep step = modelsStep(work, evaluation, works);
    step.compute = [works](const StepContext& context, const Progress& progress) {
        BlendTables tables;
        for (std::size_t w = 0; w < works.size(); ++w) {
            progress.report(static_cast<std::int64_t>(w), static_cast<std::int64_t>(works.size()));
            for (std::size_t b = 0; b < works[w]->entry().blends.size(); ++b)
                tables.add(*works[w], b, context);
        }
        return std::move(tables).result();
    };
    return step;
}

} // namespace quadrille
