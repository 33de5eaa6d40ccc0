// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/metriccomparison.h"
#include "model/project/evaluationstages.h"
#include "model/project/referenceangles.h"
#include "model/project/tablebuilder.h"
#include "model/transition/posedistance.h"

namespace quadrille {

namespace {

constexpr auto table1Note =
    "Correlation of pose distances with those of reference joint angles, over all pairs of frames, as in "
    "SMCAS Table 1: of wrapped Euler angles (the paper's), and of the joints' rotations.";
constexpr auto table1JointsNote =
    "The joints that table1 is about: how much each differs, its share of the squared reference distances, "
    "and Pearson's correlation of pose distances with its differences alone.";

/// The rows and columns of some frames.
Table<float> partOf(const Table<float>& table, const std::vector<NodeIndex>& nodes)
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

} // namespace

std::vector<std::size_t> sequencesWithAngles(const CharacterWork& work)
{
    std::vector<std::size_t> found;
    for (std::size_t s = 0; s < work.sequences.size(); ++s) {
        const SequenceEntry* entry = findSequence(work.opener->project(), work.sequences[s]);
        if (!referenceAnglesFile(work.opener->project(), work.opener->folder(), *entry).empty())
            found.push_back(s);
    }
    return found;
}

ResultStage table1Stage(const CharacterWork& work, const EvaluationEntry& evaluation)
{
    const auto chosen = sequencesWithAngles(work);
    const auto entryOf = [work](std::size_t sequence) {
        return *findSequence(work.opener->project(), work.sequences[sequence]);
    };
    ResultStage stage = evaluationStage(work, evaluation);
    stage.settings = nlohmann::json(chosen).dump();
    stage.files = [=](const Progress& progress) {
        auto files = work.files(progress);
        for (const std::size_t sequence : chosen)
            files.push_back(
                referenceAnglesFile(work.opener->project(), work.opener->folder(), entryOf(sequence)));
        return files;
    };
    stage.inputs = {work.stageName(graphstage::poseDistance), work.stageName(graphstage::euclideanDistance)};
    stage.compute = [=, inputs = stage.inputs](const StageContext& context, const Progress& progress) {
        const Result poses = context.resultOf(inputs[0]);
        const FrameLayout layout = layoutOf(poses);
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
            isSurface ? tableOf<float>(poses.arrays.front())
                      : poseDistances(work.open(progress), {}, progress.part(0.1, 0.5)).distances;
        const Table<float> euclidean = tableOf<float>(context.resultOf(inputs[1]).arrays.front());
        return table1Result(compareMetrics(joined(angles), partOf(euclidean, nodes), partOf(surface, nodes),
                                           progress.part(isSurface ? 0.1 : 0.5, 1)));
    };
    return stage;
}

} // namespace quadrille
