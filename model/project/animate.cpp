// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/animate.h"

#include "model/core/message.h"
#include "model/project/clippost.h"
#include "model/project/walkrequest.h"
#include "model/synthesis/contactcorrection.h"
#include "model/synthesis/makeclip.h"
#include "model/synthesis/variedplan.h"

namespace quadrille {

BlendSettings blendSettings(const AnimationEntry& animation)
{
    return animation.gentleBlend ? BlendSettings::gentle() : BlendSettings();
}

namespace {

/// The walk that was accepted, with its cost.
WalkSolution acceptedSolution(const WalkEntry& entry, const CharacterGraph& graph)
{
    WalkSolution solution{.walk = walkOf(entry.spans, graph), .start = startOf(entry, graph)};
    for (const WalkSpan& span : solution.walk.spans)
        solution.cost.edges += graph.alpha() * (span.frameCount() - 1);
    for (const Transition& transition : transitionsOf(solution.walk, graph.layout(), graph.paths()))
        solution.cost.edges +=
            graph.costs().weight(transition.frames.source, transition.frames.destination, graph.alpha());
    return solution;
}

/// Plays the takes at both ends of a walk for longer, where they go on.
void extend(WalkSolution& solution, const FrameLayout& layout, NodeIndex frames)
{
    WalkSpan& first = solution.walk.spans.front();
    WalkSpan& last = solution.walk.spans.back();
    const NodeIndex before = std::min(frames, first.first - layout.firstOf(layout.sequenceOf(first.first)));
    const NodeIndex after = std::min(frames, layout.lastOf(layout.sequenceOf(last.last)) - last.last);
    first.first -= before;
    last.last += after;
    solution.frameCount += before + after;
    for (FrameRange& action : solution.actions)
        action = {FrameIndex(action.first.value + before), FrameIndex(action.last.value + before)};
}

} // namespace

bool hasLoopEnds(const AnimationEntry& animation)
{
    return animation.post.steps.loop && !animation.walk &&
           std::ranges::all_of(animation.constraints, [](const ConstraintEntry& constraint) {
               return std::holds_alternative<ActionEntry>(constraint);
           });
}

AnimationWalk animationWalk(const AnimationEntry& animation, const CharacterGraph& graph,
                            const Progress& progress, const SolutionCallback& found)
{
    try {
        if (animation.walk)
            return {.constraints = {}, .solution = acceptedSolution(*animation.walk, graph)};
        if (animation.constraints.empty())
            throw Error(ErrorCode::ProjectInvalid,
                        {{},
                         {},
                         {{"reason", "The animation “" + animation.name + "” asks for nothing"},
                          {"remedy", QUADRILLE_MESSAGE("Give it a path, keys or actions.")}}});
        AnimationWalk walk{.constraints = walkConstraints(animation, graph), .solution = {}};
        walk.solution =
            findWalk(graph.material(blendSettings(animation), walk.constraints.path.has_value()),
                     walk.constraints, searchSettings(animation.search, graph.fps()), progress, found);
        if (hasLoopEnds(animation))
            extend(walk.solution, graph.layout(),
                   2 * transitionSettings(graph.work().graph, graph.fps()).shortest());
        return walk;
    } catch (const Error& error) {
        throw graph.named(error);
    }
}

ClipPlan animationPlan(const AnimationEntry& animation, const CharacterGraph& graph,
                       const WalkSolution& solution)
{
    ClipPlan plan = planClip(graph.roots(), graph.layout(), graph.paths(), solution.walk,
                             {.start = solution.start, .blend = blendSettings(animation)});
    plan.asked = solution.asked();
    return plan;
}

AnimationClip animationClip(const AnimationEntry& animation, const CharacterGraph& graph,
                            const CharacterFrames& frames, ClipPlan plan,
                            std::span<const TakeVariation> variations, const Progress& progress)
{
    std::vector<SpanDraw> spans = drawRepeats(plan, graph.layout(), variations);
    VariedPlan varied = variedPlan(frames, std::move(plan), spans, variations, graph.roots().supports,
                                   {.easeSeconds = animation.post.variations.value_or(VariedRepeats()).ease,
                                    .interpolation = animation.interpolation},
                                   progress.part(0, 0.1));
    Clip clip = makeClip(varied.character, varied.plan, animation.interpolation, progress.part(0.1, 0.5));
    PostProcessingInputs inputs =
        postProcessingInputs(animation, graph.work(), frames, graph.roots().stances);
    inputs.asked = varied.plan.asked;
    PostProcessing steps = animation.post.steps;
    const bool hasNoFeet = steps.contacts && legsOf(frames, inputs.method.up).feet.empty();
    if (hasNoFeet)
        steps.contacts.reset();
    return {.processed = postProcessed(std::move(clip), steps, inputs, progress.part(0.5, 1)),
            .plan = std::move(varied.plan),
            .spans = std::move(spans),
            .hasNoFeet = hasNoFeet};
}

} // namespace quadrille
