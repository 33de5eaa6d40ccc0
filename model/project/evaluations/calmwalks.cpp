// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/walkmeasures.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/animate.h"
#include "model/project/steps/walkrequest.h"
#include "model/project/store/tablebuilder.h"

namespace quadrille {

namespace {

constexpr auto walksNote =
    "Walks along five paths with the settings that animations have by default: how restless they are, and "
    "how much feet slide and speeds change in them beside the takes that they are made of.";

TableBuilder walksTable()
{
    TableBuilder table("walks", walksNote);
    table.text("path").real("length", "m").real("seconds", "s").whole("transitions");
    table.real("transitions-per-second", "1/s").whole("shortest-run", "frame").real("blended-share");
    table.real("stray-share");
    table.real("mean-deviation", "m").real("greatest-deviation", "m");
    table.real("slide", "m/s").real("slide-of-takes", "m/s").real("slide-ratio");
    table.real("speed-change", "m/s").real("speed-change-of-takes", "m/s");
    table.real("speed-change-ratio").real("cost").whole("expansions");
    return table;
}

double ratioOf(double value, double reference)
{
    return reference > 0 ? value / reference : 0;
}

} // namespace

BuildStep walksStep(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    const ProjectSettings project = work.opener->project().settings;
    const double metres = project.axes.metresPerUnit;
    AnimationEntry animation;
    animation.character = work.character;
    BuildStep step = evaluationStep(work, evaluation);
    step.version = 15;
    step.settings =
        work.settings + jsonLine({project.fps, metres, work.sequences}) + walkSettings(animation, work);
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = CharacterGraph::inputs(work);
    step.compute = [=](const StepContext& context, const Progress& progress) {
        const CharacterGraph graph(work, context);
        const CharacterFrames character = work.open(progress.part(0, 0.05));
        const RootPoses& roots = graph.roots();
        const std::vector<double> levels = standingLevels(character, roots.stances, roots.up);
        TableBuilder table = walksTable();
        for (std::size_t p = 0; p < standardPaths.size(); ++p) {
            const auto part = [&](double share) {
                return 0.05 + 0.95 * (static_cast<double>(p) + share) / standardPaths.size();
            };
            WalkConstraints constraints;
            constraints.path.emplace();
            for (const Vec2d& point : standardPath(standardPaths[p]))
                constraints.path->points.push_back(Ground(roots.up).at(point, 0));
            const WalkMaterial material = graph.material(blendSettings(animation), true);
            const WalkSolution solution =
                findWalk(material, constraints, searchSettings(animation.search, project.fps),
                         progress.part(part(0), part(0.7)));
            const ClipPlan plan = animationPlan(animation, graph, solution, constraints.path);
            const WalkCalmness calm = calmnessOf(plan, solution.walk, material.locomotion, project.fps);
            const AnimationClip made =
                animationClip(animation, graph, character, plan, {}, progress.part(part(0.7), part(0.9)));
            const MotionMeasures motion = measureMotion(made.processed.clip, roots.stances, roots.up, levels);
            const MotionMeasures takes = measureTakes(character, roots, solution.walk.spans, levels);
            table.add(
                {std::string(standardPaths[p]), solution.pathLength, calm.seconds,
                 std::int64_t{calm.transitions}, calm.transitionsPerSecond(), std::int64_t{calm.shortestRun},
                 calm.blendedShare, calm.strayShare, solution.meanDeviation, solution.greatestDeviation,
                 motion.slide95 * metres, takes.slide95 * metres, ratioOf(motion.slide95, takes.slide95),
                 motion.speedChange * metres, takes.speedChange * metres,
                 ratioOf(motion.speedChange, takes.speedChange), solution.totalCost, solution.expansions});
        }
        Result result;
        result.tables = {std::move(table).table()};
        return result;
    };
    return step;
}

} // namespace quadrille
