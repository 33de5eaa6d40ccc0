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
    WalkSolution solution{.walk = acceptedWalk(entry, graph), .start = startOf(entry, graph)};
    for (const WalkSpan& span : solution.walk.spans)
        solution.cost.edges += graph.alpha() * (span.frameCount() - 1);
    for (const Transition& transition : transitionsOf(solution.walk, graph.layout(), graph.paths()))
        solution.cost.edges +=
            graph.costs().weight(transition.frames.source, transition.frames.destination, graph.alpha());
    return solution;
}

} // namespace

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
            findWalk(graph.material(blendSettings(animation)), walk.constraints,
                     searchSettings(animation.search, graph.fps(), graph.metresPerUnit()), progress, found);
        return walk;
    } catch (const Error& error) {
        throw graph.named(error);
    }
}

ClipPlan animationPlan(const AnimationEntry& animation, const CharacterGraph& graph, const Walk& walk,
                       const GroundMotion& start)
{
    return planClip(graph.roots(), graph.layout(), graph.paths(), walk,
                    {.start = start, .blend = blendSettings(animation)});
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
    const PostProcessingInputs inputs =
        postProcessingInputs(animation, graph.work(), frames, graph.roots().stances);
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
