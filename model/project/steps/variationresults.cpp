// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/variationresults.h"

#include "model/core/error.h"
#include "model/project/steps/charactersteps.h"
#include "model/project/store/tablebuilder.h"
#include "model/variation/reconstructionerror.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace quadrille {

namespace {

DataArray arrayOfDoubles(std::string name, std::string description, std::string unit,
                         std::vector<std::int64_t> shape, std::vector<double> values)
{
    DataArray array;
    array.name = std::move(name);
    array.description = std::move(description);
    array.unit = std::move(unit);
    array.shape = std::move(shape);
    array.values = std::move(values);
    return array;
}

DataArray matrixArray(std::string name, std::string description, std::string unit, const RowMatrix& matrix)
{
    return arrayOfDoubles(std::move(name), std::move(description), std::move(unit),
                          {matrix.rows(), matrix.cols()}, {matrix.data(), matrix.data() + matrix.size()});
}

const std::vector<double>& doublesOf(const Result& result, const std::string& name)
{
    return std::get<std::vector<double>>(arrayOf(result, name).values);
}

std::string toText(TakeUse use)
{
    switch (use) {
    case TakeUse::Given:
        return "given";
    case TakeUse::Cycle:
        return "cycle";
    case TakeUse::Whole:
        return "whole";
    case TakeUse::TooShort:
        return "too short for a cycle";
    case TakeUse::NoCycle:
        return "no cycle found";
    }
    return {};
}

std::string toText(GpdmStop stop)
{
    constexpr std::array<const char*, 4> texts{"converged", "iteration limit", "stalled", "cancelled"};
    return texts[static_cast<std::size_t>(stop)];
}

std::array<double, 7> listed(const GpdmHyperparameters& h)
{
    return {h.alpha1, h.alpha2, h.alpha3, h.beta1, h.beta2, h.beta3, h.beta4};
}

std::string joined(const std::vector<std::string>& names)
{
    std::string all;
    for (const std::string& name : names)
        all += (all.empty() ? "" : ", ") + name;
    return all;
}

std::string faultsText(const Candidate& candidate)
{
    std::vector<std::string> names;
    for (const VariationFault fault : candidate.faults)
        names.emplace_back(toString(fault));
    return joined(names);
}

/// In the column “spread-of-takes”.
constexpr const char* guessed = "guess";

DataTable chainsTable(const std::vector<PartVariations>& sets)
{
    TableBuilder table("chains",
                       "How the Markov chains ran, one for each trajectory that was drawn around, what their "
                       "deviations were multiplied by, and how far the samples are apart then, as a share of "
                       "how far takes of the same movement are, which is a guess where there is one alone; "
                       "how many samples were sure enough, and how many were not.");
    table.whole("samples").whole("chain").real("acceptance").real("step-size").whole("thinning");
    table.real("effective-sample-size").real("lag-1-autocorrelation").real("scale").real("spread");
    table.text("spread-of-takes").whole("accepted").whole("rejected");
    for (std::size_t s = 0; s < sets.size(); ++s) {
        for (std::size_t c = 0; c < sets[s].reports.size(); ++c) {
            const SampleReport& report = sets[s].reports[c];
            const HmcReport& chain = report.chain;
            table.add({static_cast<std::int64_t>(s + 1), static_cast<std::int64_t>(c + 1), chain.acceptance,
                       chain.stepSize, std::int64_t{chain.thinning}, chain.effectiveSampleSize, chain.lag1,
                       report.scale, report.spread, report.isGuess ? guessed : "measured",
                       std::ssize(sets[s].trajectories) - std::int64_t{report.uncertain},
                       std::int64_t{report.rejected}});
        }
    }
    return std::move(table).table();
}

DataTable spreadTable(const VariationEntry& entry, const std::vector<std::vector<PartSpread>>& sets)
{
    TableBuilder table(
        "spread", "How far the variations of a set are apart, and the captured takes: mean distance of a "
                  "vertex from its mean over them. 0 where there are fewer than two.");
    table.whole("samples").text("of").text("to").text("part").real("variations", "m").real("takes", "m");
    table.real("ratio");
    for (std::size_t s = 0; s < sets.size(); ++s) {
        for (const PartSpread& spread : sets[s])
            table.add({static_cast<std::int64_t>(s + 1), entry.samples[s].of, entry.samples[s].to,
                       spread.part.empty() ? "whole body" : spread.part, spread.variations.value_or(0),
                       spread.takes.value_or(0), spread.ratio().value_or(0)});
    }
    return std::move(table).table();
}

} // namespace

Result alignmentResult(const Movement& movement)
{
    const Alignment& alignment = movement.alignment;
    TableBuilder takes("takes", "The takes that are learned, and the pre-blends of them.");
    takes.text("take").text("use").whole("first", "frame").whole("last", "frame").real("mean-cost", "rad");
    TableBuilder warps("warps", "Where each take is at each frame of the reference.");
    warps.text("take").whole("reference-frame", "frame").real("take-frame", "frame");
    TableBuilder playback("playback", "Where on the reference each frame of a take is that is used.");
    playback.text("take").whole("take-frame", "frame").real("reference-frame", "frame");
    for (std::size_t t = 0; t < alignment.takes.size(); ++t) {
        const AlignedTake& take = alignment.takes[t];
        const bool isCaptured = t < movement.capturedCount();
        takes.add({take.name, isCaptured ? toText(alignment.reports[t].use) : "blend",
                   take.warp.frames.first.value, take.warp.frames.last.value,
                   isCaptured ? alignment.reports[t].meanCost : 0.0});
        for (std::size_t f = 0; f < take.warp.positions.size(); ++f)
            warps.add({take.name, static_cast<std::int64_t>(f), take.warp.positions[f]});
        for (std::size_t f = 0; f < take.warp.playback.size(); ++f)
            playback.add({take.name, take.warp.frames.first.value + static_cast<std::int64_t>(f),
                          take.warp.playback[f]});
    }
    Result result;
    result.tables = {std::move(takes).table(), std::move(warps).table(), std::move(playback).table()};
    return result;
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
                                    {training.mean.data(), training.mean.data() + training.mean.size()}),
                     matrixArray("latents", "Latent position of each row.", "", learning.state.latents)};
    const auto hyperparameters = listed(learning.state.hyperparameters);
    DataArray seven = arrayOfDoubles("hyperparameters", "Parameters of both kernels.", "", {7},
                                     {hyperparameters.begin(), hyperparameters.end()});
    result.arrays.push_back(std::move(seven));
    result.arrays.push_back(
        arrayOfDoubles("objective", "Negative log posterior after each iteration; the last one is final.", "",
                       {static_cast<std::int64_t>(learning.objective.size())}, learning.objective));
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
    TableBuilder learned(
        "learning", "How learning went, and how far the model reconstructs what it learned: mean distance "
                    "of a vertex, beside principal components of as many dimensions.");
    learned.text("stop").whole("iterations").real("objective").text("active-bounds");
    learned.real("model-error", "m").real("principal-components-error", "m");
    const Eigen::Index vertices =
        (training.blocks.empty() ? training.rows.cols() : training.blocks.front().first) / 3;
    const GpdmState& state = learning.state;
    learned.add({toText(learning.stop), static_cast<std::int64_t>(learning.objective.size()),
                 learning.objective.empty() ? 0.0 : learning.objective.back(), joined(learning.activeBounds),
                 modelError(state, training.rows, vertices),
                 principalError(training.rows, static_cast<int>(state.latents.cols()), vertices)});
    result.tables = {std::move(names).table(), std::move(learned).table()};
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
    const DataTable& learned = model.tables.at(1);
    const auto text = [&](std::size_t column) {
        return std::get<std::vector<std::string>>(learned.columns.at(column).values).at(0);
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

Result samplesResult(const std::vector<PartVariations>& sets, Eigen::Index frames, Eigen::Index dimensions)
{
    std::vector<double> values;
    std::int64_t count = 0;
    for (const PartVariations& set : sets) {
        for (const RowMatrix& trajectory : set.trajectories) {
            values.insert(values.end(), trajectory.data(), trajectory.data() + trajectory.size());
            ++count;
        }
    }
    Result result;
    result.arrays = {
        arrayOfDoubles("samples",
                       "Latent trajectories that were drawn, those of all sets of samples one after "
                       "the other: candidates of variations.",
                       "", {count, frames, dimensions}, std::move(values))};
    result.tables = {chainsTable(sets)};
    return result;
}

std::vector<RowMatrix> trajectoriesOf(const Result& samples)
{
    const DataArray& array = arrayOf(samples, "samples");
    const double* at = doublesOf(samples, "samples").data();
    std::vector<RowMatrix> trajectories;
    for (std::int64_t t = 0; t < array.shape[0]; ++t) {
        trajectories.emplace_back(Eigen::Map<const RowMatrix>(at, array.shape[1], array.shape[2]));
        at += array.shape[1] * array.shape[2];
    }
    return trajectories;
}

std::vector<std::vector<SampleSpread>> spreadsOf(const Result& samples, std::size_t sets)
{
    const std::vector<DataArray>& chains = samples.tables.front().columns;
    const auto& column = [&chains](const char* name) -> const DataValues& {
        return std::ranges::find(chains, name, &DataArray::name)->values;
    };
    const auto& set = std::get<std::vector<std::int64_t>>(column("samples"));
    const auto& share = std::get<std::vector<double>>(column("spread"));
    const auto& reference = std::get<std::vector<std::string>>(column("spread-of-takes"));
    std::vector<std::vector<SampleSpread>> spreads(sets);
    for (std::size_t chain = 0; chain < set.size(); ++chain)
        spreads.at(static_cast<std::size_t>(set[chain] - 1))
            .push_back({share[chain], reference[chain] == guessed});
    return spreads;
}

Result selectionResult(const VariationEntry& entry, const std::vector<VariationSelection>& sets,
                       const std::vector<std::vector<PartSpread>>& spreads)
{
    TableBuilder table("report", "All variations that were drawn: those with a number were good enough.");
    table.whole("variation").text("of").text("to").real("weight");
    table.text("across-of").text("across-to").real("across-weight").whole("seed").whole("candidate");
    table.text("faults").real("mean-pose-distance", "m").real("worst-pose-distance", "m");
    table.real("skate", "m/s").real("take-skate", "m/s").whole("intersections").whole("take-intersections");
    table.real("volume-change").real("collapse").real("sink", "m").real("greatest-pose-distance", "m");
    std::int64_t before = 0;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const SamplesEntry& samples = entry.samples[s];
        const AcrossSamplesEntry across = samples.across.value_or(AcrossSamplesEntry());
        for (std::size_t c = 0; c < sets[s].candidates.size(); ++c) {
            const Candidate& candidate = sets[s].candidates[c];
            const VariationQuality& quality = candidate.quality;
            table.add({candidate.isAccepted() ? before + candidate.number : 0,
                       samples.of,
                       samples.to,
                       samples.weight,
                       across.of,
                       across.to,
                       across.weight,
                       static_cast<std::int64_t>(samples.seed),
                       static_cast<std::int64_t>(c),
                       faultsText(candidate),
                       quality.meanPoseDistance,
                       quality.worstPoseDistance,
                       quality.skate.value_or(0),
                       quality.takeSkate,
                       quality.intersections,
                       quality.takeIntersections,
                       quality.volumeChange.value_or(0),
                       quality.collapse,
                       quality.sink,
                       greatestPoseDistance(quality, entry.limits)});
        }
        before += samples.count;
    }
    Result result;
    result.tables = {std::move(table).table(), spreadTable(entry, spreads)};
    return result;
}

namespace {

/// A column of a table by its name. \pre There is one of this type.
template <typename Value>
const std::vector<Value>& columnOf(const DataTable& table, const std::string& name)
{
    const auto found = std::ranges::find(table.columns, name, &DataArray::name);
    return std::get<std::vector<Value>>(found->values);
}

/// As faultsText writes them.
std::vector<VariationFault> faultsOf(const std::string& text)
{
    std::vector<VariationFault> faults;
    for (std::size_t fault = 0; fault < variationFaults; ++fault) {
        if (text.find(toString(static_cast<VariationFault>(fault))) != std::string::npos)
            faults.push_back(static_cast<VariationFault>(fault));
    }
    return faults;
}

} // namespace

std::vector<VariationSelection> selectionsOf(const Result& selection, const VariationEntry& entry)
{
    const DataTable& report = selection.tables.front();
    const auto& numbers = columnOf<std::int64_t>(report, "variation");
    const auto& candidates = columnOf<std::int64_t>(report, "candidate");
    const auto& faults = columnOf<std::string>(report, "faults");
    const auto& skates = columnOf<double>(report, "skate");
    const auto& volumes = columnOf<double>(report, "volume-change");
    std::vector<VariationSelection> sets;
    std::int64_t before = 0;
    for (std::size_t row = 0; row < numbers.size(); ++row) {
        // Candidates of each set count from 0.
        if (candidates[row] == 0) {
            before += sets.empty() ? 0 : entry.samples.at(sets.size() - 1).count;
            sets.emplace_back();
        }
        Candidate& candidate = sets.back().candidates.emplace_back();
        candidate.number = numbers[row] > 0 ? static_cast<int>(numbers[row] - before) : 0;
        candidate.faults = faultsOf(faults[row]);
        candidate.quality.meanPoseDistance = columnOf<double>(report, "mean-pose-distance")[row];
        candidate.quality.worstPoseDistance = columnOf<double>(report, "worst-pose-distance")[row];
        // Where nothing stands there is no skate to measure: it is 0.
        if (skates[row] != 0)
            candidate.quality.skate = skates[row];
        candidate.quality.volumeChange = volumes[row];
        candidate.quality.collapse = columnOf<double>(report, "collapse")[row];
        candidate.quality.sink = columnOf<double>(report, "sink")[row];
        candidate.quality.takeSkate = columnOf<double>(report, "take-skate")[row];
        candidate.quality.intersections = columnOf<std::int64_t>(report, "intersections")[row];
        candidate.quality.takeIntersections = columnOf<std::int64_t>(report, "take-intersections")[row];
        if (candidate.isAccepted())
            sets.back().accepted.push_back(static_cast<int>(candidates[row]));
    }
    return sets;
}

std::optional<int> candidateOf(const Result& selection, int number)
{
    const DataTable& report = selection.tables.front();
    const auto& numbers = columnOf<std::int64_t>(report, "variation");
    const auto& candidates = columnOf<std::int64_t>(report, "candidate");
    const auto found = std::find(numbers.begin(), numbers.end(), number);
    if (found == numbers.end())
        return std::nullopt;
    return static_cast<int>(candidates[static_cast<std::size_t>(found - numbers.begin())]);
}

} // namespace quadrille
