// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/message.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/fields/writefields.h"
#include "model/project/steps/animate.h"
#include "model/project/steps/clippost.h"
#include "model/project/steps/storedwalk.h"
#include "model/project/steps/variedrepeats.h"
#include "model/project/steps/walkrequest.h"
#include "model/project/store/clipresult.h"

namespace quadrille {

namespace {

/// The work of the character that an animation shows.
CharacterInputs workOf(const StepMaking& making, const AnimationEntry& animation)
{
    const Project& project = making.opener->project();
    return characterWork(making.opener, graphOf(project, characterNameOf(project, animation)));
}

BuildStep walkStep(const CharacterInputs& work, const AnimationEntry& animation)
{
    BuildStep step;
    step.name = walkStepOf(animation.name);
    step.kind = "walk";
    step.version = 16;
    step.dataPrefix = "animations/" + animation.name;
    step.settings = walkSettings(animation, work);
    step.inputs = CharacterGraph::inputs(work);
    step.compute = [work, animation](const StepContext& context, const Progress& progress) {
        const CharacterGraph graph(work, context);
        SolutionCallback found;
        if (context.improved)
            found = [&](const WalkSolution& better) {
                context.improved(walkResult(animation, graph, {walkConstraints(animation, graph), better}));
            };
        return walkResult(animation, graph, animationWalk(animation, graph, progress, found));
    };
    return step;
}

BuildStep clipStep(const CharacterInputs& work, const AnimationEntry& animation, const BuildStep& walk)
{
    BuildStep step;
    step.name = clipStepOf("animations/" + animation.name);
    step.kind = "animation clip";
    step.version = 8;
    step.dataPrefix = walk.dataPrefix;
    const AnimationEntry made{.interpolation = animation.interpolation,
                              .gentleBlend = animation.gentleBlend,
                              .post = animation.post};
    step.settings = work.settings + animationSettings(made, work.opener->project().settings.axes.up);
    step.inputs = CharacterGraph::inputs(work);
    step.inputs.push_back(walk.name);
    if (animation.post.steps.retime)
        step.settings += "frames-before-retime";
    const std::vector<std::string> drawn = clipsDrawnFrom(work.opener->project(), animation);
    for (const std::string& clip : drawn) {
        step.settings += clip;
        step.inputs.push_back(clipStepOf(clip));
    }
    step.files = [work, animation](const Progress& progress) {
        std::vector<std::filesystem::path> files = work.files(progress);
        const auto symmetry = symmetryFiles(animation, work);
        files.insert(files.end(), symmetry.begin(), symmetry.end());
        return files;
    };
    step.compute = [work, animation, drawn, walk = walk.name](const StepContext& context,
                                                              const Progress& progress) {
        const CharacterGraph graph(work, context);
        const ClipPlan plan = animationPlan(animation, graph, shownWalkOf(*context.resultOf(walk), graph),
                                            pathOf(animation, graph));
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        const auto variations = takeVariations(drawn, graph, context);
        std::vector<std::string> names;
        for (const TakeVariation& variation : *variations)
            names.push_back(variation.name);
        const auto [processed, shown, spans, hasNoFeet] =
            animationClip(animation, graph, frames, plan, *variations, progress.part(0.05, 1));
        Result result = clipResult(processed.clip, graph.layout(), work.sequences,
                                   unitText(work.opener->project().settings.axes.metresPerUnit), names);
        if (hasNoFeet)
            context.tell({.severity = Issue::Severity::Info,
                          .context = {.values = {{"text", QUADRILLE_MESSAGE("The character has no feet that "
                                                                            "could be told apart: contacts "
                                                                            "are not corrected.")}}}});
        if (animation.post.variations) {
            result.tables.push_back(repeatsTable(spans, *variations, graph));
            if (const auto problem = problemWithMissing(drawn, names))
                context.tell({.context = {.values = {{"text", *problem}}}});
            if (const auto problem = problemWithRepeats(spans, graph))
                context.tell({.context = {.values = {{"text", *problem}}}});
        }
        if (processed.travel)
            result.arrays.push_back(groundMotionArray(
                "loop-travel",
                "From one playing of the loop to the next: turn about the up axis, radians, and shift over "
                "the ground, metres.",
                *processed.travel));
        if (animation.post.steps.retime)
            result.arrays.push_back(framesBeforeRetimeArray(processed.framesBeforeRetime));
        return result;
    };
    return step;
}

} // namespace

std::string walkStepOf(const std::string& animation)
{
    return "animations/" + animation + "/walk";
}

std::vector<BuildStep> makeAnimationSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const AnimationEntry& animation : making.opener->project().animations) {
        const CharacterInputs work = workOf(making, animation);
        if (work.sequences.empty())
            continue;
        const BuildStep walk = walkStep(work, animation);
        steps.push_back(walk);
        steps.push_back(clipStep(work, animation, walk));
    }
    return steps;
}

} // namespace quadrille
