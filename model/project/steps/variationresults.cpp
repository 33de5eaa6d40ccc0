// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/variationresults.h"

#include "model/core/error.h"
#include "model/project/steps/charactersteps.h"
#include "model/project/steps/variationarrays.h"
#include "model/project/store/tablebuilder.h"
#include "model/variation/reconstructionerror.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace quadrille {

namespace {

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
    const auto& reference = std::get<TextColumn>(column("spread-of-takes"));
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
    const auto& numbers = columnNamed<std::vector<std::int64_t>>(report, "variation");
    const auto& candidates = columnNamed<std::vector<std::int64_t>>(report, "candidate");
    const auto& faults = columnNamed<TextColumn>(report, "faults");
    const auto& skates = columnNamed<std::vector<double>>(report, "skate");
    const auto& volumes = columnNamed<std::vector<double>>(report, "volume-change");
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
        candidate.quality.meanPoseDistance =
            columnNamed<std::vector<double>>(report, "mean-pose-distance")[row];
        candidate.quality.worstPoseDistance =
            columnNamed<std::vector<double>>(report, "worst-pose-distance")[row];
        // Where nothing stands there is no skate to measure: it is 0.
        if (skates[row] != 0)
            candidate.quality.skate = skates[row];
        candidate.quality.volumeChange = volumes[row];
        candidate.quality.collapse = columnNamed<std::vector<double>>(report, "collapse")[row];
        candidate.quality.sink = columnNamed<std::vector<double>>(report, "sink")[row];
        candidate.quality.takeSkate = columnNamed<std::vector<double>>(report, "take-skate")[row];
        candidate.quality.intersections =
            columnNamed<std::vector<std::int64_t>>(report, "intersections")[row];
        candidate.quality.takeIntersections =
            columnNamed<std::vector<std::int64_t>>(report, "take-intersections")[row];
        if (candidate.isAccepted())
            sets.back().accepted.push_back(static_cast<int>(candidates[row]));
    }
    return sets;
}

std::optional<int> candidateOf(const Result& selection, int number)
{
    const DataTable& report = selection.tables.front();
    const auto& numbers = columnNamed<std::vector<std::int64_t>>(report, "variation");
    const auto& candidates = columnNamed<std::vector<std::int64_t>>(report, "candidate");
    const auto found = std::find(numbers.begin(), numbers.end(), number);
    if (found == numbers.end())
        return std::nullopt;
    return static_cast<int>(candidates[static_cast<std::size_t>(found - numbers.begin())]);
}

} // namespace quadrille
