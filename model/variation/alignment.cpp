// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/alignment.h"

#include "model/core/badargument.h"
#include "model/core/error.h"
#include "model/sequence/contacts.h"
#include "model/transition/characterframes.h"
#include "model/transition/posedistance.h"
#include "model/variation/alignposes.h"
#include "model/variation/cycles.h"
#include "model/variation/matchcosts.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// A take as it is matched: its frames that may be used, with contacts.
struct Candidate
{
    MeshSequence sequence;
    FrameIndex first{0}; ///< frame of the take that the sequence begins with
    bool isGiven = false;
    std::vector<ContactSpan> contacts; ///< of the whole take
};

void requireValid(std::span<const TrainingTake> takes, std::size_t reference,
                  const AlignmentSettings& settings)
{
    if (reference >= takes.size())
        refuse("There is no take to align to", "Name one of the training takes as the reference.");
    const auto isSize = [](double value) { return value >= 0 && std::isfinite(value); };
    if (!isSize(settings.contactWeight) || !isSize(settings.smoothing) || settings.steps.longestRun < 0)
        refuse("A setting of the alignment is negative", "Use 0 or more.");
}

FrameRange usableFrames(const TrainingTake& take)
{
    const FrameRange all = FrameRange::all(take.sequence.frameCount());
    const FrameRange range = take.range.value_or(all);
    if (range.count() > 0 && (!all.contains(range.first) || !all.contains(range.last)))
        throw Error(ErrorCode::RangeOutside, {.values = {{"first", std::to_string(range.first.value)},
                                                         {"last", std::to_string(range.last.value)},
                                                         {"count", std::to_string(all.count())}}});
    if (range.count() < leastTrainingFrames)
        throw Error(ErrorCode::TakeTooShort, {.values = {{"take", take.sequence.name},
                                                         {"count", std::to_string(range.count())},
                                                         {"least", std::to_string(leastTrainingFrames)}}});
    return range;
}

/// \param cut  to the frames that may be used.
Candidate candidateOf(const TrainingTake& take, bool cut, UpAxis up, const Progress& progress)
{
    const FrameRange frames = usableFrames(take);
    Candidate candidate{
        .sequence = take.sequence, .first = FrameIndex(0), .isGiven = take.range.has_value(), .contacts = {}};
    if (candidate.sequence.contacts.empty())
        candidate.sequence.contacts = detectContacts(take.sequence, {.up = up}, progress);
    candidate.contacts = candidate.sequence.contacts;
    if (cut) {
        candidate.sequence = candidate.sequence.cutTo(frames);
        candidate.first = frames.first;
    }
    return candidate;
}

/// Of each take its costs against all frames of the reference.
std::vector<Table<float>> costsOf(const std::vector<Candidate>& candidates, std::size_t reference,
                                  const AlignmentSettings& settings, const Progress& progress)
{
    std::vector<MeshSequence> sequences{candidates[reference].sequence};
    for (std::size_t t = 0; t < candidates.size(); ++t) {
        if (t != reference)
            sequences.push_back(candidates[t].sequence);
    }
    const CharacterFrames character(sequences);
    const FrameLayout& layout = character.layout();
    const Table<float> distances =
        poseDistancesOfFirst(character, layout.countOf(0), settings.distance, progress);
    std::vector<Table<float>> costs(candidates.size());
    int next = 1;
    for (std::size_t t = 0; t < candidates.size(); ++t) {
        const int sequence = t == reference ? 0 : next++;
        costs[t] = distances.middleCols(layout.firstOf(sequence), layout.countOf(sequence));
        if (t != reference)
            addContactCosts(sequences.front(), candidates[t].sequence, settings.contactWeight, costs[t]);
    }
    return costs;
}

/// The frames of the reference that are used, and its cycle.
struct ReferenceFrames
{
    TakeUse use = TakeUse::Whole;
    std::int64_t first = 0;
    std::int64_t count = 0;
    bool isCycle = false;
};

ReferenceFrames referenceFrames(const TrainingTake& take, const std::vector<Candidate>& candidates,
                                std::size_t reference, const std::vector<Table<float>>& costs,
                                const AlignmentSettings& settings)
{
    const std::int64_t all = costs[reference].rows();
    ReferenceFrames frames{.use = TakeUse::Whole, .first = 0, .count = all, .isCycle = false};
    const std::optional<std::int64_t> period =
        settings.cycles ? findPeriod(costs[reference], settings.greatestReturn) : std::nullopt;
    if (take.range) {
        frames = {TakeUse::Given, take.range->first.value, take.range->count(), false};
        // Chosen by eye, a cycle may be a quarter longer or shorter.
        frames.isCycle = period && 4 * std::abs(frames.count - *period) <= *period;
    } else if (period) {
        std::vector<Table<float>> others;
        for (std::size_t t = 0; t < costs.size(); ++t) {
            if (t != reference && !candidates[t].isGiven)
                others.push_back(costs[t]);
        }
        frames = {TakeUse::Cycle, chooseCycleStart(others, *period, all, settings.steps), *period, true};
    }
    return frames;
}

std::vector<WarpMatch> diagonal(std::int64_t first, std::int64_t count)
{
    std::vector<WarpMatch> path;
    for (std::int64_t f = 0; f < count; ++f)
        path.push_back({static_cast<int>(f), static_cast<int>(first + f)});
    return path;
}

/// How a take is matched with the reference's frames.
/// \param costs  frames of the reference that are used × frames of the take.
void matchTake(const Table<float>& costs, const ReferenceFrames& frames, bool isGiven,
               const AlignmentSettings& settings, WarpReport& report)
{
    report.use = isGiven ? TakeUse::Given : TakeUse::Whole;
    if (frames.isCycle && !isGiven) {
        const std::optional<CycleMatch> match = matchCycle(costs, settings.steps);
        if (match && match->meanCost <= settings.greatestMatch * static_cast<double>(costs.mean())) {
            report.use = TakeUse::Cycle;
            report.path = match->path;
            report.meanCost = match->meanCost;
            return;
        }
        report.use = costs.cols() < costs.rows() ? TakeUse::TooShort : TakeUse::NoMatch;
    }
    WarpPathResult whole = warpWhole(costs, settings.steps);
    report.meanCost = whole.meanCost();
    report.path = std::move(whole.path);
}

WarpReport reportOf(const Candidate& candidate, const Table<float>& costs, const ReferenceFrames& frames,
                    bool isReference, const AlignmentSettings& settings)
{
    const Table<float> used = costs.middleRows(frames.first, frames.count);
    WarpReport report{.firstColumn = candidate.first, .contacts = candidate.contacts};
    if (isReference) {
        report.use = frames.use;
        report.path = diagonal(frames.first, frames.count);
    } else {
        matchTake(used, frames, candidate.isGiven, settings, report);
    }
    shrink(used, report);
    return report;
}

std::vector<Vec3f> centredTemplate(Positions given, const MeshSequence& reference, FrameIndex first)
{
    const std::size_t expected = reference.topology->vertexCount();
    if (!given.empty() && given.size() != expected)
        throw Error(ErrorCode::VertexCountMismatch, {.values = {{"found", std::to_string(given.size())},
                                                                {"expected", std::to_string(expected)}}});
    const Frame frame = reference.frame(first);
    const Positions pose = given.empty() ? frame.positions() : given;
    const Vec3d centre = centroid(pose);
    std::vector<Vec3f> centred;
    centred.reserve(pose.size());
    for (const Vec3f& p : pose)
        centred.emplace_back((p.cast<double>() - centre).cast<float>());
    return centred;
}

void fillPhases(const TakeWarp& warp, WarpReport& report)
{
    for (const double position : warp.playback)
        report.phases.push_back(position / static_cast<double>(warp.positions.size() - 1));
}

} // namespace

Alignment alignTakes(std::span<const TrainingTake> takes, std::size_t reference,
                     const AlignmentSettings& settings, Positions templatePose, const Progress& progress)
{
    requireValid(takes, reference, settings);
    std::vector<Candidate> candidates;
    for (std::size_t t = 0; t < takes.size(); ++t) {
        const double from = 0.2 * static_cast<double>(t) / static_cast<double>(takes.size());
        const double to = 0.2 * static_cast<double>(t + 1) / static_cast<double>(takes.size());
        candidates.push_back(candidateOf(takes[t], t != reference, settings.up, progress.part(from, to)));
    }
    const std::vector<Table<float>> costs = costsOf(candidates, reference, settings, progress.part(0.2, 0.7));
    const ReferenceFrames frames = referenceFrames(takes[reference], candidates, reference, costs, settings);

    Alignment alignment{.reference = reference, .fps = takes[reference].sequence.fps};
    alignment.templatePose =
        centredTemplate(templatePose, takes[reference].sequence, FrameIndex(frames.first));
    if (frames.isCycle)
        alignment.cycle = frames.count;
    for (std::size_t t = 0; t < takes.size(); ++t) {
        progress.part(0.7, 1).report(static_cast<std::int64_t>(t), static_cast<std::int64_t>(takes.size()));
        WarpReport report = reportOf(candidates[t], costs[t], frames, t == reference, settings);
        AlignedTake take{.name = takes[t].sequence.name,
                         .warp = warpOf(report.path, settings.smoothing, candidates[t].first),
                         .poses = {},
                         .placements = {}};
        alignPoses(takes[t].sequence, alignment.templatePose, take, progress.part(0.7, 1));
        fillPhases(take.warp, report);
        alignment.reports.push_back(std::move(report));
        alignment.takes.push_back(std::move(take));
    }
    return alignment;
}

} // namespace quadrille
