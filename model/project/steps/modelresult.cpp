// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/variationarrays.h"
#include "model/project/steps/variationresults.h"
#include "model/project/store/tablebuilder.h"
#include "model/variation/reconstructionerror.h"

#include <array>
#include <sstream>

namespace quadrille {

namespace {

std::string toText(GpdmStop stop)
{
    constexpr std::array<const char*, 4> texts{"converged", "iteration limit", "stalled", "cancelled"};
    return texts[static_cast<std::size_t>(stop)];
}

std::array<double, 7> listed(const GpdmHyperparameters& h)
{
    return {h.alpha1, h.alpha2, h.alpha3, h.beta1, h.beta2, h.beta3, h.beta4};
}

/// What tells a model, whatever it was learned from.
std::vector<DataArray> modelArrays(const GpdmLearning& learning)
{
    const auto hyperparameters = listed(learning.state.hyperparameters);
    return {matrixArray("latents", "Latent position of each row.", "", learning.state.latents),
            arrayOfDoubles("hyperparameters", "Parameters of both kernels.", "", {7},
                           {hyperparameters.begin(), hyperparameters.end()}),
            arrayOfDoubles("objective", "Negative log posterior after each iteration; the last one is final.",
                           "", {static_cast<std::int64_t>(learning.objective.size())}, learning.objective)};
}

DataTable learningTable(const GpdmLearning& learning, double modelError, double principalError)
{
    TableBuilder table("learning",
                       "How learning went, and how far the model reconstructs what it learned: mean distance "
                       "of a vertex, beside principal components of as many dimensions.");
    table.text("stop").whole("iterations").real("objective").text("active-bounds");
    table.real("model-error", "m").real("principal-components-error", "m");
    table.add({toText(learning.stop), static_cast<std::int64_t>(learning.objective.size()),
               learning.objective.empty() ? 0.0 : learning.objective.back(), joined(learning.activeBounds),
               modelError, principalError});
    return std::move(table).table();
}

} // namespace

Result modelProgressResult(const GpdmLearning& learning)
{
    return {.arrays = modelArrays(learning), .tables = {learningTable(learning, 0, 0)}, .files = {}};
}

Result modelResult(const PartTraining& training, const GpdmLearning& learning,
                   const std::vector<std::string>& takes)
{
    Result result;
    result.arrays = {matrixArray("training",
                                 "What is learned: a row for each frame, three coordinates for each vertex, "
                                 "for the root followed by six scaled displacements; their mean subtracted.",
                                 "m", training.rows),
                     arrayOfDoubles("mean", "The mean that was subtracted.", "m", {training.mean.size()},
                                    {training.mean.data(), training.mean.data() + training.mean.size()})};
    for (DataArray& array : modelArrays(learning))
        result.arrays.push_back(std::move(array));
    DataArray spans;
    spans.name = "spans";
    spans.description = "First and last row of each take.";
    spans.columns = {"first", "last"};
    spans.shape = {static_cast<std::int64_t>(training.spans.size()), 2};
    std::vector<std::int64_t> rows;
    for (const RowSpan& span : training.spans)
        rows.insert(rows.end(), {span.first, span.last()});
    spans.values = std::move(rows);
    result.arrays.push_back(std::move(spans));
    result.arrays.push_back(arrayOfDoubles(
        "displacement-scale", "What displacements are multiplied by; 0 where the part has none.", "", {1},
        {training.blocks.empty() ? 0 : training.blocks.front().scale}));
    TableBuilder names("takes", "What the spans are of.");
    names.text("take").whole("first", "row").whole("last", "row");
    for (std::size_t t = 0; t < training.spans.size(); ++t)
        names.add({takes.at(t), training.spans[t].first, training.spans[t].last()});
    const Eigen::Index vertices =
        (training.blocks.empty() ? training.rows.cols() : training.blocks.front().first) / 3;
    const GpdmState& state = learning.state;
    result.tables = {
        std::move(names).table(),
        learningTable(learning, modelError(state, training.rows, vertices),
                      principalError(training.rows, static_cast<int>(state.latents.cols()), vertices))};
    return result;
}

GpdmState stateOf(const Result& model)
{
    const DataArray& latents = arrayOf(model, "latents");
    GpdmState state;
    state.latents =
        Eigen::Map<const RowMatrix>(doublesOf(model, "latents").data(), latents.shape[0], latents.shape[1]);
    const std::vector<double>& h = doublesOf(model, "hyperparameters");
    state.hyperparameters = {h.at(0), h.at(1), h.at(2), h.at(3), h.at(4), h.at(5), h.at(6)};
    return state;
}

GpdmLearning learningOf(const Result& model)
{
    GpdmLearning learning{.state = stateOf(model), .objective = doublesOf(model, "objective")};
    const DataTable& learned = model.tables.back();
    const auto text = [&](std::size_t column) {
        return std::get<TextColumn>(learned.columns.at(column).values).at(0);
    };
    constexpr std::size_t stopColumn = 0;
    constexpr std::size_t boundsColumn = 3;
    for (const GpdmStop stop :
         {GpdmStop::Converged, GpdmStop::IterationLimit, GpdmStop::Cancelled, GpdmStop::Stalled}) {
        if (toText(stop) == text(stopColumn))
            learning.stop = stop;
    }
    std::istringstream bounds(text(boundsColumn));
    for (std::string name; std::getline(bounds >> std::ws, name, ',');)
        learning.activeBounds.push_back(name);
    return learning;
}

} // namespace quadrille
