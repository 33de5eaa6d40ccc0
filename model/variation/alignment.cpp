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
#include <iterator>
#include <map>

namespace quadrille {

namespace {

/// A take as it is matched: its frames that may be used, with contacts. The reference keeps all.
struct CycleCandidate
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
    if (!(settings.postureShare >= 0 && settings.postureShare <= 1))
        refuse("The share of posture that alignment leaves out must be from 0 to 1",
               "The usual share is 0.5.");
}

void requireAnchor(std::span<const VertexIndex> anchor, std::uint32_t vertexCount)
{
    const auto greatest = std::max_element(anchor.begin(), anchor.end());
    if (greatest != anchor.end() && greatest->value >= vertexCount)
        throw Error(ErrorCode::IndexOutOfRange, {.values = {{"what", "vertex"},
                                                            {"index", std::to_string(greatest->value)},
                                                            {"count", std::to_string(vertexCount)}}});
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
CycleCandidate candidateOf(const TrainingTake& take, bool cut, UpAxis up, const Progress& progress)
{
    const FrameRange frames = usableFrames(take);
    CycleCandidate candidate{
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

/// What all is matched by.
struct Matching
{
    std::vector<CycleCandidate> candidates;
    std::size_t reference = 0;
    FrameRange usable;                   ///< frames of the reference
    Table<float> referenceDistances;     ///< of all its frames to each other
    std::vector<Table<float>> distances; ///< of each take, usable frames of the reference × its frames
    std::vector<Table<float>> costs;     ///< of the same matches
};

void fillCosts(Matching& matching, const AlignmentSettings& settings, const Progress& progress)
{
    const std::vector<CycleCandidate>& candidates = matching.candidates;
    const CycleCandidate& reference = candidates[matching.reference];
    std::vector<MeshSequence> sequences{reference.sequence};
    for (std::size_t t = 0; t < candidates.size(); ++t) {
        if (t != matching.reference)
            sequences.push_back(candidates[t].sequence);
    }
    const CharacterFrames character(sequences);
    const FrameLayout& layout = character.layout();
    const Table<float> distances =
        poseDistancesOfFirst(character, layout.countOf(0), settings.distance, progress);
    matching.referenceDistances = distances.leftCols(layout.countOf(0));
    const MeshSequence usable = reference.sequence.cutTo(matching.usable);
    int next = 1;
    for (std::size_t t = 0; t < candidates.size(); ++t) {
        const bool isReference = t == matching.reference;
        const int sequence = isReference ? 0 : next++;
        Table<float> block = distances.block(matching.usable.first.value, layout.firstOf(sequence),
                                             matching.usable.count(), layout.countOf(sequence));
        matching.costs.push_back(isReference ? block
                                             : matchCosts(block, usable, candidates[t].sequence, settings));
        matching.distances.push_back(std::move(block));
    }
}

/// The frames of the reference that all takes are warped to.
struct ReferenceFrames
{
    TakeUse use = TakeUse::Whole;
    std::int64_t first = 0; ///< of the usable ones
    std::int64_t count = 0;
    bool isCycle = false;
};

Table<float> ownDistances(const CycleCandidate& candidate, const AlignmentSettings& settings,
                          const Progress& progress)
{
    return poseDistances(CharacterFrames(std::span(&candidate.sequence, 1)), settings.distance, progress)
        .distances;
}

/// A take of which one cycle is wanted.
bool isCut(const Matching& matching, std::size_t take)
{
    return take != matching.reference && !matching.candidates[take].isGiven;
}

/// \param own  as for reportOf. \param period  of the reference; 0: none.
ReferenceFrames referenceFrames(const Matching& matching, const std::vector<Table<float>>& own,
                                std::int64_t period, const AlignmentSettings& settings,
                                const Progress& progress)
{
    const std::int64_t count = matching.usable.count();
    if (matching.candidates[matching.reference].isGiven) {
        // Chosen by eye, a cycle may be a quarter longer or shorter.
        const bool isCycle = period > 0 && 4 * std::abs(count - period) <= period;
        return {.use = TakeUse::Given, .first = 0, .count = count, .isCycle = isCycle};
    }
    if (period == 0)
        return {.use = TakeUse::Whole, .first = 0, .count = count, .isCycle = false};
    std::vector<CycleTake> takes;
    for (std::size_t t = 0; t < own.size(); ++t) {
        if (isCut(matching, t))
            takes.push_back({&matching.costs[t], findPeriod(own[t], settings.greatestReturnBeside)});
    }
    return {.use = TakeUse::Cycle,
            .first = chooseCycleStart(takes, period, count, progress),
            .count = period,
            .isCycle = true};
}

std::vector<WarpMatch> diagonal(std::int64_t first, std::int64_t count)
{
    std::vector<WarpMatch> path;
    for (std::int64_t f = 0; f < count; ++f)
        path.push_back({static_cast<int>(f), static_cast<int>(first + f)});
    return path;
}

/// The frames of a take that are warped to the reference's.
/// \param distances, costs  the reference's frames that are used × frames of the take. \param own  distances
/// of its poses to each other; empty where no cycle is looked for.
std::pair<TakeUse, FrameRange> usedFrames(const Table<float>& distances, const Table<float>& costs,
                                          const Table<float>& own, bool isGiven,
                                          const AlignmentSettings& settings)
{
    const FrameRange all = FrameRange::all(costs.cols());
    if (own.size() == 0)
        return {isGiven ? TakeUse::Given : TakeUse::Whole, all};
    if (const auto period = findPeriod(own, settings.greatestReturnBeside))
        return {TakeUse::Cycle, cycleWindow(costs, *period)};
    if (const auto cycle =
            cycleWithin(distances, own, settings.steps, settings.greatestMatch, settings.greatestReturn))
        return {TakeUse::Cycle, *cycle};
    return {costs.cols() < costs.rows() ? TakeUse::TooShort : TakeUse::NoCycle, all};
}

/// \param own  distances of the take's poses to each other; empty where no cycle is looked for.
WarpReport reportOf(const Matching& matching, std::size_t take, const ReferenceFrames& frames,
                    const Table<float>& own, const AlignmentSettings& settings)
{
    const CycleCandidate& candidate = matching.candidates[take];
    const Table<float> costs = matching.costs[take].middleRows(frames.first, frames.count);
    WarpReport report{.firstColumn = candidate.first, .contacts = candidate.contacts};
    if (take == matching.reference) {
        report.use = frames.use;
        report.path = diagonal(matching.usable.first.value + frames.first, frames.count);
    } else {
        const auto [use, used] = usedFrames(matching.distances[take].middleRows(frames.first, frames.count),
                                            costs, own, candidate.isGiven, settings);
        WarpPathResult found = warpWhole(costs.middleCols(used.first.value, used.count()), settings.steps);
        for (WarpMatch& match : found.path)
            match.take += static_cast<int>(used.first.value);
        report.use = use;
        report.meanCost = found.meanCost();
        report.path = std::move(found.path);
    }
    shrink(costs, report);
    return report;
}

AlignmentTemplate centredTemplate(Positions given, const MeshSequence& reference, FrameIndex first,
                                  const std::vector<VertexIndex>& anchor)
{
    const std::size_t expected = reference.topology->vertexCount();
    if (!given.empty() && given.size() != expected)
        throw Error(ErrorCode::VertexCountMismatch, {.values = {{"found", std::to_string(given.size())},
                                                                {"expected", std::to_string(expected)}}});
    const Frame frame = reference.frame(first);
    const Positions pose = given.empty() ? frame.positions() : given;
    AlignmentTemplate result{.pose = {pose.begin(), pose.end()}, .anchor = anchor};
    Vec3d sum = Vec3d::Zero();
    for (const VertexIndex vertex : anchor)
        sum += pose[vertex.value].cast<double>();
    const Vec3d centre = anchor.empty() ? centroid(pose) : Vec3d(sum / static_cast<double>(anchor.size()));
    for (Vec3f& p : result.pose)
        p = (p.cast<double>() - centre).cast<float>();
    return result;
}

/// The part of the work that one of several takes is.
Progress partOf(const Progress& progress, double from, double to, std::size_t take, std::size_t takes)
{
    const double share = (to - from) / static_cast<double>(takes);
    return progress.part(from + share * static_cast<double>(take),
                         from + share * static_cast<double>(take + 1));
}

/// The labels that most of these frames have, sorted.
std::vector<std::string> labelsOf(const MeshSequence& sequence, FrameRange frames)
{
    std::map<std::string, std::int64_t> counts;
    for (const LabelSpan& span : sequence.labels) {
        const std::int64_t first = std::max(span.frames.first.value, frames.first.value);
        const std::int64_t last = std::min(span.frames.last.value, frames.last.value);
        counts[span.label] += std::max<std::int64_t>(last - first + 1, 0);
    }
    std::vector<std::string> labels;
    for (const auto& [label, count] : counts) {
        if (2 * count > frames.count())
            labels.push_back(label);
    }
    return labels;
}

void fillPhases(const TakeWarp& warp, WarpReport& report)
{
    for (const double position : warp.playback)
        report.phases.push_back(position / static_cast<double>(warp.positions.size() - 1));
}

} // namespace

std::vector<VertexIndex> anchorVertices(const BodyParts& parts)
{
    if (parts.parts.size() < 2)
        return {};
    std::vector<VertexIndex> anchor = parts.parts.front().vertices;
    for (const BodyPart& part : parts.parts) {
        std::vector<VertexIndex> rest;
        std::set_difference(anchor.begin(), anchor.end(), part.overlap.begin(), part.overlap.end(),
                            std::back_inserter(rest));
        anchor = std::move(rest);
    }
    constexpr std::size_t fewest = 3; // they turn about nothing
    return anchor.size() < fewest ? std::vector<VertexIndex>() : anchor;
}

Alignment alignTakes(std::span<const TrainingTake> takes, std::size_t reference,
                     const AlignmentSettings& settings, Positions templatePose, const Progress& progress)
{
    requireValid(takes, reference, settings);
    requireAnchor(settings.anchor, takes[reference].sequence.topology->vertexCount());
    Matching matching{.reference = reference, .usable = usableFrames(takes[reference])};
    for (std::size_t t = 0; t < takes.size(); ++t)
        matching.candidates.push_back(
            candidateOf(takes[t], t != reference, settings.up, partOf(progress, 0, 0.2, t, takes.size())));
    fillCosts(matching, settings, progress.part(0.2, 0.5));

    const std::int64_t period =
        settings.cycles ? findPeriod(matching.referenceDistances, settings.greatestReturn).value_or(0) : 0;
    std::vector<Table<float>> own(takes.size());
    for (std::size_t t = 0; t < takes.size() && period > 0; ++t) {
        if (isCut(matching, t))
            own[t] =
                ownDistances(matching.candidates[t], settings, partOf(progress, 0.5, 0.7, t, takes.size()));
    }
    const ReferenceFrames frames = referenceFrames(matching, own, period, settings, progress.part(0.7, 0.8));
    if (!frames.isCycle)
        own.assign(takes.size(), Table<float>());

    Alignment alignment{.reference = reference, .fps = takes[reference].sequence.fps};
    const auto laidOnto = std::make_shared<const AlignmentTemplate>(
        centredTemplate(templatePose, takes[reference].sequence,
                        FrameIndex(matching.usable.first.value + frames.first), settings.anchor));
    alignment.templatePose = laidOnto->pose;
    if (frames.isCycle)
        alignment.cycle = frames.count;
    for (std::size_t t = 0; t < takes.size(); ++t) {
        WarpReport report = reportOf(matching, t, frames, own[t], settings);
        AlignedTake take{.name = takes[t].sequence.name,
                         .warp = warpOf(report.path, settings.smoothing, matching.candidates[t].first),
                         .poses = {},
                         .placements = {},
                         .laidOnto = laidOnto};
        take.labels = labelsOf(takes[t].sequence, take.warp.frames);
        alignPoses(takes[t].sequence, take, partOf(progress, 0.8, 1, t, takes.size()));
        fillPhases(take.warp, report);
        alignment.reports.push_back(std::move(report));
        alignment.takes.push_back(std::move(take));
    }
    return alignment;
}

} // namespace quadrille
