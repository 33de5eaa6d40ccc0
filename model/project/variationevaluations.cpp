// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/evaluationstages.h"
#include "model/project/madeclips.h"
#include "model/project/tablebuilder.h"
#include "model/project/variate.h"
#include "model/project/variationresults.h"
#include "model/project/variationstages.h"
#include "model/variation/blenderrors.h"
#include "model/variation/preblend.h"
#include "model/variation/reconstructionerror.h"

#include <algorithm>

namespace quadrille {

namespace {

using Works = std::vector<std::shared_ptr<VariationWork>>;

Works worksOf(const CharacterWork& work)
{
    Works works;
    for (const VariationEntry* entry : learnedVariations(work.opener->project(), work.character))
        works.push_back(std::make_shared<VariationWork>(work.opener, *entry));
    return works;
}

/// A stage about the models of all variations of a character.
ResultStage modelsStage(const CharacterWork& work, const EvaluationEntry& evaluation, const Works& works)
{
    ResultStage stage = evaluationStage(work, evaluation);
    for (const auto& each : works) {
        for (const std::string& part : partNamesOf(each->project(), each->entry()))
            stage.inputs.push_back(modelStageOf(each->entry().name, part));
    }
    return stage;
}

GpdmState stateOf(const VariationWork& work, const BodyPart& part, const StageContext& context)
{
    return stateOf(context.resultOf(modelStageOf(work.entry().name, part.name)));
}

Result reconstructionResult(const Works& works, const StageContext& context, const Progress& progress)
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

/// The learned trajectories of a blend in one part, ascending by weight.
std::vector<LearnedBlend> learnedBlends(const Movement& movement, std::size_t blend, std::size_t part,
                                        const GpdmState& state)
{
    const auto latents = [&](std::size_t take) -> RowMatrix {
        const RowSpan& span = movement.training[part].spans[take];
        return state.latents.middleRows(span.first, span.count);
    };
    const MovementBlend& pair = movement.blends[blend];
    std::vector<LearnedBlend> learned{{0, latents(pair.from)}};
    for (std::size_t w = 0; w < pair.weights.size(); ++w)
        learned.push_back({pair.weights[w], latents(movement.blendedTake(blend, w))});
    learned.push_back({1, latents(pair.to)});
    return learned;
}

/// The weights half-way between those that were learned.
std::vector<double> weightsBetween(const MovementBlend& blend)
{
    std::vector<double> learned{0};
    learned.insert(learned.end(), blend.weights.begin(), blend.weights.end());
    learned.push_back(1);
    std::vector<double> between;
    for (std::size_t i = 0; i + 1 < learned.size(); ++i)
        between.push_back((learned[i] + learned[i + 1]) / 2);
    return between;
}

class BlendTables
{
public:
    BlendTables()
    {
        m_frames.text("blend").real("weight").text("part").whole("frame");
        m_frames.real("from-takes", "m").real("from-nearby", "m");
        m_means.text("variation").text("blend").real("weight").text("part").real("from-takes", "m");
        m_means.real("from-nearby", "m").real("ratio");
    }

    void add(VariationWork& work, std::size_t blend, const StageContext& context)
    {
        const auto movement = work.movement();
        const MovementBlend& pair = movement->blends[blend];
        const AlignedTake& from = movement->take(pair.from);
        const AlignedTake& to = movement->take(pair.to);
        const auto system = std::make_shared<const PoissonSystem>(movement->topology);
        for (const double weight : weightsBetween(pair)) {
            const AlignedTake truth =
                blendedTake(system, from, to, weight, {}, {.up = work.project().settings.axes.up});
            for (std::size_t p = 0; p < movement->parts.parts.size(); ++p) {
                const BodyPart& part = movement->parts.parts[p];
                const PartTraining& training = movement->training[p];
                const GpdmState state = stateOf(work, part, context);
                const PoseReconstruction poses(state, training.rows, training.mean);
                addPart(work.entry().name, from.name + "–" + to.name, weight, part.name,
                        blendErrors(poses, learnedBlends(*movement, blend, p, state), weight, truth, part));
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
    void addPart(const std::string& variation, const std::string& blend, double weight,
                 const std::string& part, const BlendErrors& errors)
    {
        for (std::size_t f = 0; f < errors.fromTakes.size(); ++f)
            m_frames.add({blend, weight, part, static_cast<std::int64_t>(f), errors.fromTakes[f],
                          errors.fromNearby[f]});
        m_means.add({variation, blend, weight, part, errors.meanFromTakes(), errors.meanFromNearby(),
                     errors.meanFromNearby() / errors.meanFromTakes()});
    }

    TableBuilder m_frames{"cvs-fig7",
                          "How far blends that are interpolated in latent space are from the true "
                          "blend of the same weight (CVS Fig. 7b): mean distance of a vertex."};
    TableBuilder m_means{"cvs-fig7-means", "The same over all frames, with the ratio of both."};
};

} // namespace

ResultStage cvsFig4Stage(const CharacterWork& work, const EvaluationEntry& evaluation)
{
    const Works works = worksOf(work);
    ResultStage stage = modelsStage(work, evaluation, works);
    stage.compute = [works](const StageContext& context, const Progress& progress) {
        return reconstructionResult(works, context, progress);
    };
    return stage;
}

ResultStage cvsFig7Stage(const CharacterWork& work, const EvaluationEntry& evaluation)
{
    const Works works = worksOf(work);
    ResultStage stage = modelsStage(work, evaluation, works);
    stage.compute = [works](const StageContext& context, const Progress& progress) {
        BlendTables tables;
        for (std::size_t w = 0; w < works.size(); ++w) {
            progress.report(static_cast<std::int64_t>(w), static_cast<std::int64_t>(works.size()));
            for (std::size_t b = 0; b < works[w]->entry().blends.size(); ++b)
                tables.add(*works[w], b, context);
        }
        return std::move(tables).result();
    };
    return stage;
}

} // namespace quadrille
