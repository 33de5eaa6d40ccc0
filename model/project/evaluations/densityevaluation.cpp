// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/ranks.h"
#include "model/graph/essentialgraph.h"
#include "model/graph/motiongraph.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/charactergraph.h"
#include "model/project/store/tablebuilder.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/finishing/footdrift.h"
#include "model/synthesis/quality/liveliness.h"

namespace quadrille {

namespace {

constexpr auto densityNote =
    "How dense the Essential graph and the motion graph are when one thing at a time is another than it is "
    "set: what costs are divided by, how long windows are, all takes joined to one, costs as published.";

/// One of the graphs that are compared.
struct Variant
{
    std::string name;
    bool isJoined = false;          ///< all takes are one, in their order
    bool isPublished = false;       ///< sums of pose distances alone, windows as published
    std::optional<double> quantile; ///< of the pose distances, that costs are divided by; else the largest
    std::optional<double> longest;  ///< window, seconds
};

std::vector<Variant> variantsOf()
{
    std::vector<Variant> variants{{.name = "as set"}};
    for (const double share : {0.99, 0.9, 0.5, 0.1})
        variants.push_back({.name = "quantile", .quantile = share});
    for (const double seconds : {0.6, 1.0, 1.5, 3.0})
        variants.push_back({.name = "longest window", .longest = seconds});
    variants.push_back({.name = "joined", .isJoined = true});
    variants.push_back({.name = "joined, quantile", .isJoined = true, .quantile = 0.1});
    variants.push_back({.name = "published", .isPublished = true});
    variants.push_back({.name = "published, quantile", .isPublished = true, .quantile = 0.1});
    variants.push_back({.name = "published, joined", .isJoined = true, .isPublished = true});
    variants.push_back(
        {.name = "published, joined, quantile", .isJoined = true, .isPublished = true, .quantile = 0.1});
    return variants;
}

double quantileOf(TableView<float> distances, double share)
{
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(distances.size()) / 2);
    for (Eigen::Index i = 0; i < distances.rows(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            values.push_back(static_cast<double>(distances(i, j)));
    return quantile(std::move(values), share);
}

TransitionCosts costsOf(const Variant& variant, const CharacterGraph& graph, const Table<double>& liveliness,
                        const Progress& progress)
{
    const CharacterInputs& work = graph.work();
    const GraphEntry entry = variant.isPublished ? GraphEntry::paper() : work.graph;
    TransitionSettings settings = transitionSettings(entry, graph.fps());
    if (variant.longest) {
        settings.longestWindow =
            std::max(settings.shortest(), static_cast<int>(std::lround(*variant.longest * graph.fps())));
    }
    const std::int64_t frames = graph.layout().frameCount();
    const FrameLayout layout = variant.isJoined ? FrameLayout(std::span(&frames, 1)) : graph.layout();
    TransitionTable table = variant.isPublished
                                ? transitionTable(graph.distances(), layout, settings, progress)
                                : transitionTable(graph.steps(), layout, settings, progress);
    Table<float> cost = std::move(table.cost).take();
    if (knowsDrifts(entry))
        addDrifts(cost, footDrifts(graph.roots(), layout, table, graph.fps()), *table.length,
                  entry.cost == TransitionCost::Sum, entry.steps);
    if (entry.costScale == CostScale::Liveliness && !variant.isJoined && liveliness.size() > 0)
        cost = costPerLiveliness(std::move(cost), layout, liveliness);
    const double greatest = variant.quantile
                                ? quantileOf(graph.distances(), *variant.quantile)
                                : work.graph.greatestDistance.value_or(graph.distances().maxCoeff());
    return {layout, greatest, std::move(cost), std::move(table.length)};
}

std::int64_t transitionsOf(const Digraph& graph)
{
    return std::ranges::count_if(graph.edges(),
                                 [](const Edge& edge) { return edge.kind == EdgeKind::Transition; });
}

} // namespace

BuildStep densityStep(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    const std::vector<double> alphas =
        evaluation.alphas.empty() ? std::vector{work.graph.alpha} : evaluation.alphas;
    const bool isLively = work.graph.costScale == CostScale::Liveliness;
    BuildStep step = evaluationStep(work, evaluation);
    step.settings = jsonLine({alphas, costSettings(work.graph), work.sequences,
                              work.opener->project().settings.fps, static_cast<int>(work.graph.smoothing)});
    step.inputs = CharacterGraph::inputs(work);
    step.compute = [=](const StepContext& context, const Progress& progress) {
        const CharacterGraph graph(work, context);
        const Table<double> liveliness =
            isLively ? tableOf<double>(context.resultOf(work.stepName(graphstep::liveliness))->arrays.front())
                     : Table<double>();
        TableBuilder table("density", densityNote);
        table.text("variant").real("quantile").real("longest", "s").real("alpha").whole("takes");
        table.whole("frames").real("d-max",
                                   graph.work().graph.pose.metric == PoseMetric::Surface ? "rad" : "m");
        table.real("median-deformation").whole("essential-transitions").real("essential-density");
        table.whole("motion-transitions").real("motion-density");
        const std::vector<Variant> variants = variantsOf();
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t v = 0; v < variants.size(); ++v) {
            const auto part = [&](double share) {
                return (static_cast<double>(v) + share) / static_cast<double>(variants.size());
            };
            const Variant& variant = variants[v];
            const TransitionCosts costs =
                costsOf(variant, graph, liveliness, progress.part(part(0), part(0.3)));
            const auto minima = costMinima(costs, work.graph.smoothing, progress.part(part(0.3), part(0.35)));
            const auto frames = static_cast<double>(costs.layout().frameCount());
            std::vector<double> deformations;
            for (NodeIndex i = 0; i < costs.layout().frameCount(); ++i)
                for (NodeIndex j = 0; j < costs.layout().frameCount(); ++j)
                    if (costs.hasTransition(i, j))
                        deformations.push_back(costs.weight(i, j, 0));
            const double median = quantile(std::move(deformations), 0.5);
            for (const double alpha : alphas) {
                const std::int64_t essential =
                    transitionsOf(essentialGraph(costs, alpha, progress.part(part(0.35), part(1))).graph);
                const std::int64_t motion = transitionsOf(motionGraph(costs, minima, alpha));
                table.add({variant.name, variant.quantile.value_or(none), variant.longest.value_or(none),
                           alpha, std::int64_t{costs.layout().sequenceCount()},
                           std::int64_t{costs.layout().frameCount()}, costs.largestDistance(), median,
                           essential, static_cast<double>(essential) / (frames * (frames - 1)), motion,
                           static_cast<double>(motion) / (frames * (frames - 1))});
            }
        }
        Result result;
        result.tables = {std::move(table).table()};
        return result;
    };
    return step;
}

} // namespace quadrille
