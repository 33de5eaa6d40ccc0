// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/metriccomparison.h"
#include "model/evaluation/shapechange.h"
#include "model/project/document/findentry.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/json/jsonline.h"
#include "model/project/media/referenceangles.h"
#include "model/project/store/tablebuilder.h"
#include "model/transition/posedistance.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr auto table1Note =
    "Correlation of pose distances with those of reference joint angles, over all pairs of frames, as in "
    "SMCAS Table 1: of wrapped Euler angles (the paper's), and of the joints' rotations.";
constexpr auto table1JointsNote =
    "The joints that table1 is about: how much each differs, its share of the squared reference distances, "
    "and Pearson's correlation of pose distances with its differences alone.";

/// The rows and columns of some frames.
Table<float> partOf(TableView<float> table, const std::vector<NodeIndex>& nodes)
{
    return table(nodes, nodes);
}

Result table1Result(const MetricComparison& comparison)
{
    TableBuilder table("table1", table1Note);
    table.text("reference").real("pearson-euclidean").real("pearson-surface");
    table.real("distance-correlation-euclidean").real("distance-correlation-surface");
    table.whole("pairs").whole("frames", "frame").whole("joints");
    for (const MetricComparisonRow& row : comparison.rows)
        table.add({row.reference == JointAngleMetric::EulerAngles ? "euler-angles" : "rotations",
                   row.euclidean.pearson, row.surface.pearson, row.euclidean.distance, row.surface.distance,
                   comparison.pairs, comparison.frames, std::ssize(comparison.joints)});
    TableBuilder joints("table1-joints", table1JointsNote);
    joints.text("joint").real("mean-difference", "rad").real("share");
    joints.real("pearson-euclidean").real("pearson-surface");
    for (const JointShare& joint : comparison.joints)
        joints.add(
            {joint.joint, joint.meanDifference, joint.share, joint.euclideanPearson, joint.surfacePearson});
    Result result;
    result.tables = {std::move(table).table(), std::move(joints).table()};
    return result;
}

constexpr auto fig4Note =
    "Poses between two frames, by linear interpolation of vertices and by the surface (SMCAS Fig. 4): "
    "changes "
    "of edges and volume against what lies evenly between both frames, as parts of it. For drawn pairs and "
    "for the two poses that differ most.";
constexpr auto fig4PairsNote = "The pairs of fig4 half-way.";

const char* nameOf(InterpolationMethod method)
{
    switch (method) {
    case InterpolationMethod::Poisson:
        return "poisson";
    case InterpolationMethod::Slerp:
        return "slerp";
    case InterpolationMethod::Linear:
        return "linear";
    }
    return "";
}

/// The pair that differs most; of several the first.
FramePair furthestPair(TableView<float> distances)
{
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    distances.maxCoeff(&row, &column);
    return {static_cast<NodeIndex>(std::min(row, column)), static_cast<NodeIndex>(std::max(row, column))};
}

/// Adds a row for each method and λ: means over the pairs, and the greatest changes.
/// \param all  pairs × methods × λ.
void addMeans(TableBuilder& table, const char* pairs, std::span<const InterpolatedPair> all,
              std::size_t perPair)
{
    for (std::size_t k = 0; k < perPair && !all.empty(); ++k) {
        ShapeChange mean;
        ShapeChange greatest;
        double count = 0;
        for (std::size_t p = k; p < all.size(); p += perPair, ++count) {
            const ShapeChange& change = all[p].change;
            mean.meanEdge += change.meanEdge;
            mean.edgeDeviation += change.edgeDeviation;
            mean.volume += change.volume;
            greatest.greatestEdge = std::max(greatest.greatestEdge, change.greatestEdge);
            greatest.volume = std::max(greatest.volume, std::abs(change.volume));
        }
        table.add({pairs, nameOf(all[k].method), all[k].lambda, mean.meanEdge / count,
                   mean.edgeDeviation / count, greatest.greatestEdge, mean.volume / count, greatest.volume});
    }
}

/// A frame of a character by the name of its sequence.
struct NamedNode
{
    std::string sequence;
    std::int64_t frame = 0;
};

NamedNode named(NodeIndex node, const FrameLayout& layout, const std::vector<std::string>& sequences)
{
    const int sequence = layout.sequenceOf(node);
    return {sequences[static_cast<std::size_t>(sequence)], node - layout.firstOf(sequence)};
}

Result fig4Result(const std::vector<InterpolatedPair>& all, std::size_t perPair, TableView<float> distances,
                  const std::string& unit, const FrameLayout& layout,
                  const std::vector<std::string>& sequences)
{
    TableBuilder table("fig4", fig4Note);
    table.text("pairs").text("method").real("lambda").real("edge-change").real("edge-deviation");
    table.real("greatest-edge-change").real("volume-change").real("greatest-volume-change");
    const std::span<const InterpolatedPair> whole(all);
    addMeans(table, "drawn", whole.first(all.size() - perPair), perPair);
    addMeans(table, "furthest", whole.last(perPair), perPair);
    TableBuilder pairs("fig4-pairs", fig4PairsNote);
    pairs.text("from").whole("from-frame", "frame").text("to").whole("to-frame", "frame");
    pairs.real("pose-distance", unit).text("method").real("edge-change").real("edge-deviation");
    pairs.real("greatest-edge-change").real("volume-change");
    for (const InterpolatedPair& pair : all) {
        if (pair.lambda != 0.5)
            continue;
        const NamedNode from = named(pair.frames.source, layout, sequences);
        const NamedNode to = named(pair.frames.destination, layout, sequences);
        pairs.add({from.sequence, from.frame, to.sequence, to.frame,
                   static_cast<double>(distances(pair.frames.source, pair.frames.destination)),
                   nameOf(pair.method), pair.change.meanEdge, pair.change.edgeDeviation,
                   pair.change.greatestEdge, pair.change.volume});
    }
    Result result;
    result.tables = {std::move(table).table(), std::move(pairs).table()};
    return result;
}

} // namespace

BuildStep fig4Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    constexpr int usualCount = 20;
    const int count = static_cast<int>(evaluation.count.value_or(usualCount));
    const auto seed = static_cast<std::uint64_t>(evaluation.seed);
    BuildStep step = evaluationStep(work, evaluation);
    step.settings = work.settings + jsonLine({count, seed, work.sequences});
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = {work.stepName(graphstep::poseDistance)};
    step.compute = [=, input = step.inputs.front()](const StepContext& context, const Progress& progress) {
        const auto poses = context.resultOf(input);
        const Table<float> distances = tableOf<float>(poses->arrays.front());
        const FrameLayout layout = layoutOf(*poses);
        const CharacterFrames character = work.open(progress.part(0, 0.1));
        std::vector<FramePair> pairs = drawPairs(layout.frameCount(), count, seed);
        pairs.push_back(furthestPair(distances));
        constexpr std::array lambdas{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
        const auto topology = work.opener->open(work.sequences.front(), progress)->sequence.topology;
        const auto all = interpolatePairs(character, topology, pairs, lambdas, progress.part(0.1, 1));
        return fig4Result(all, all.size() / pairs.size(), distances, poses->arrays.front().unit, layout,
                          work.sequences);
    };
    return step;
}

std::vector<std::size_t> sequencesWithAngles(const CharacterInputs& work)
{
    std::vector<std::size_t> found;
    for (std::size_t s = 0; s < work.sequences.size(); ++s) {
        const SequenceEntry* entry = findSequence(work.opener->project(), work.sequences[s]);
        if (!referenceAnglesFile(work.opener->project(), work.opener->folder(), *entry).empty())
            found.push_back(s);
    }
    return found;
}

BuildStep table1Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    const auto chosen = sequencesWithAngles(work);
    const auto entryOf = [work](std::size_t sequence) {
        return *findSequence(work.opener->project(), work.sequences[sequence]);
    };
    BuildStep step = evaluationStep(work, evaluation);
    step.settings = JsonLine(chosen).text();
    step.files = [=](const Progress& progress) {
        auto files = work.files(progress);
        for (const std::size_t sequence : chosen)
            files.push_back(
                referenceAnglesFile(work.opener->project(), work.opener->folder(), entryOf(sequence)));
        return files;
    };
    step.inputs = {work.stepName(graphstep::poseDistance), work.stepName(graphstep::euclideanDistance)};
    step.compute = [=, inputs = step.inputs](const StepContext& context, const Progress& progress) {
        const auto poses = context.resultOf(inputs[0]);
        const FrameLayout layout = layoutOf(*poses);
        std::vector<JointAngles> angles;
        std::vector<NodeIndex> nodes;
        for (const std::size_t sequence : chosen) {
            angles.push_back(referenceAngles(*work.opener, entryOf(sequence), progress.part(0, 0.1)));
            for (NodeIndex n = layout.firstOf(static_cast<int>(sequence));
                 n <= layout.lastOf(static_cast<int>(sequence)); ++n)
                nodes.push_back(n);
        }
        const bool isSurface = work.graph.pose.metric == PoseMetric::Surface;
        const Table<float> surface =
            isSurface ? tableOf<float>(poses->arrays.front())
                      : poseDistances(work.open(progress), {}, progress.part(0.1, 0.5)).distances;
        const Table<float> euclidean = tableOf<float>(context.resultOf(inputs[1])->arrays.front());
        return table1Result(compareMetrics(joined(angles), partOf(euclidean, nodes), partOf(surface, nodes),
                                           progress.part(isSurface ? 0.1 : 0.5, 1)));
    };
    return step;
}

} // namespace quadrille
