// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/trajectories.h"
#include "model/project/document/lengthunit.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/posesteps.h"
#include "model/project/store/tablebuilder.h"
#include "model/transition/posedistance.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace quadrille {

namespace {

constexpr double degreesPerRadian = 180 / std::numbers::pi;

const char* nameOf(BlendAlignment alignment)
{
    switch (alignment) {
    case BlendAlignment::EveryStep:
        return "every-step";
    case BlendAlignment::MidWindow:
        return "mid-window";
    case BlendAlignment::None:
        return "plain";
    }
    return "";
}

/// Two sequences that are blended.
struct BlendedSequences
{
    std::vector<std::string> names;
    std::vector<MeshSequence> sequences;
};

/// Those of the evaluation; without any, those that turn most to the left and to the right.
BlendedSequences blendedSequences(const CharacterInputs& work, const EvaluationEntry& evaluation,
                                  const Progress& progress)
{
    const Ground ground(work.opener->project().settings.axes.up);
    BlendedSequences blended;
    blended.names = evaluation.sequences;
    if (blended.names.empty()) {
        std::vector<double> turnings;
        turnings.reserve(work.sequences.size());
        for (const std::string& name : work.sequences) {
            progress.report(std::ssize(turnings), std::ssize(work.sequences));
            turnings.push_back(netTurning(work.opener->open(name)->sequence, ground));
        }
        const auto [right, left] = std::minmax_element(turnings.begin(), turnings.end());
        blended.names = {work.sequences[static_cast<std::size_t>(left - turnings.begin())],
                         work.sequences[static_cast<std::size_t>(right - turnings.begin())]};
    }
    blended.sequences.reserve(blended.names.size());
    for (const std::string& name : blended.names)
        blended.sequences.push_back(work.opener->open(name)->sequence);
    return blended;
}

/// The curve of one of the blended windows, as captured.
CurveMeasures windowMeasures(const RootPoses& roots, NodeIndex first, NodeIndex last)
{
    const Ground ground(roots.up);
    std::vector<Vec2d> points;
    points.reserve(static_cast<std::size_t>(std::int64_t{last} - first + 1));
    for (NodeIndex node = first; node <= last; ++node)
        points.push_back(ground.of(roots.centres[static_cast<std::size_t>(node)]));
    return measureCurve(points);
}

Result trajectoryResult(const std::string& name, const BlendedSequences& blended, const RootPoses& roots,
                        const FrameLayout& layout, const Transition& blend,
                        const std::vector<BlendTrajectory>& trajectories, const std::string& unit)
{
    TableBuilder table(name,
                       "The centre of the body in a blend of two sequences, as in SMCAS Fig. 11–12: "
                       "without alignment, aligned once in the middle of the windows, and at every step.");
    table.text("variant").whole("frame", "frame").real("x", unit).real("y", unit).real("z", unit);
    TableBuilder summary(
        name + "-summary",
        "The curves seen from above, and those of the two windows as captured: their length, the distance of "
        "their ends, the largest change of direction and how many are above a right angle.");
    summary.text("variant").text("sequence").whole("first", "frame").whole("last", "frame");
    summary.whole("frames", "frame").real("length", unit).real("distance", unit);
    summary.real("greatest-turn", "°").whole("reversals");
    const auto addWindow = [&](const char* variant, int sequence, NodeIndex first, NodeIndex last) {
        const CurveMeasures measures = windowMeasures(roots, first, last);
        const NodeIndex start = layout.firstOf(sequence);
        summary.add({variant, blended.names[static_cast<std::size_t>(sequence)], std::int64_t{first - start},
                     std::int64_t{last - start}, std::int64_t{last - first + 1}, measures.length,
                     measures.distance, measures.greatestTurn * degreesPerRadian,
                     std::int64_t{measures.reversals}});
    };
    addWindow("source", 0, blend.path.front().source, blend.path.back().source);
    addWindow("destination", 1, blend.path.front().destination, blend.path.back().destination);
    const std::string both = blended.names[0] + " → " + blended.names[1];
    for (const BlendTrajectory& trajectory : trajectories) {
        std::int64_t frame = 0;
        for (const Vec3d& centre : trajectory.centres)
            table.add({nameOf(trajectory.alignment), frame++, centre.x(), centre.y(), centre.z()});
        summary.add({nameOf(trajectory.alignment), both, std::int64_t{0}, frame - 1, frame,
                     trajectory.measures.length, trajectory.measures.distance,
                     trajectory.measures.greatestTurn * degreesPerRadian,
                     std::int64_t{trajectory.measures.reversals}});
    }
    Result result;
    result.tables = {std::move(table).table(), std::move(summary).table()};
    return result;
}

BuildStep trajectoryStep(const CharacterInputs& work, const EvaluationEntry& evaluation,
                         std::optional<double> constantWeight)
{
    const Project& project = work.opener->project();
    TransitionSettings settings = transitionSettings(work.graph, project.settings.fps);
    settings.length = TransitionLength::Path;
    BuildStep step = evaluationStep(work, evaluation);
    step.version = 2;
    std::vector<JsonLine> list{evaluation.sequences, work.sequences, settings.longest(), settings.slope,
                               settings.cost == TransitionCost::Sum ? "sum" : "mean"};
    for (JsonLine& setting : distanceSettings(work.graph.pose))
        list.push_back(std::move(setting));
    step.settings = work.settings + jsonLine(list);
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.compute = [=](const StepContext&, const Progress& progress) {
        const BlendedSequences blended = blendedSequences(work, evaluation, progress.part(0, 0.4));
        const CharacterFrames frames(blended.sequences);
        const PoseDistances poses =
            poseDistances(frames, ofGraph(work.graph.pose, frames.frameCount()), progress.part(0.4, 0.7));
        const Transition blend = longBlend(poses.distances, poses.layout, settings);
        const CoordinateSystem& axes = work.opener->project().settings.axes;
        const RootPoses roots = rootPoses(frames, axes.up, progress.part(0.7, 1));
        return trajectoryResult(evaluation.table, blended, roots, poses.layout, blend,
                                blendTrajectories(roots, blend, constantWeight),
                                unitText(axes.metresPerUnit));
    };
    return step;
}

} // namespace

BuildStep fig11Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    return trajectoryStep(work, evaluation, 0.5);
}

BuildStep fig12Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    return trajectoryStep(work, evaluation, std::nullopt);
}

} // namespace quadrille
