// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/animate.h"

#include "model/core/message.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/steps/clippost.h"
#include "model/project/steps/walkrequest.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/clips/makeclip.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/synthesis/finishing/variedplan.h"
#include "model/synthesis/walks/steeredplan.h"

#include <map>

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
        if (!animation.asksForSomething())
            throwInvalid("The animation “" + animation.name + "” asks for nothing",
                         QUADRILLE_MESSAGE("Give it a path, keys or actions."));
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
                       const WalkSolution& solution, const std::optional<PathConstraint>& path)
{
    ClipPlan plan = planClip(graph.roots(), graph.layout(), graph.paths(), solution.walk,
                             {.start = solution.start, .blend = blendSettings(animation)});
    plan.asked = solution.asked();
    if (!path)
        return plan;
    return steeredPlan(std::move(plan), graph.roots(), graph.layout(),
                       PathCourse(*path, graph.roots().up, graph.metresPerUnit()),
                       searchSettings(animation.search, graph.fps()).steering);
}

int playingsOf(const AnimationEntry& animation)
{
    return animation.post.steps.loop ? std::max(animation.post.steps.repeats, 1) : 1;
}

namespace {

/// Makes the clips of a walk that is played several times, with what each playing draws from variations.
class WalkPlayings
{
public:
    WalkPlayings(const AnimationEntry& animation, const CharacterGraph& graph, CharacterFrames frames,
                 const ClipPlan& plan, std::span<const TakeVariation> variations)
        : m_plan(plan)
        , m_spans(drawRepeats(plan, graph.layout(), variations, playingsOf(animation)))
        , m_each(m_spans.size() / static_cast<std::size_t>(playingsOf(animation)))
        , m_variations(variations)
        , m_supports(graph.roots().supports)
        , m_settings{.easeSeconds = animation.post.variations.value_or(VariedRepeats()).ease,
                     .interpolation = animation.interpolation}
        , m_frames(std::move(frames))
    {
    }

    const std::vector<SpanDraw>& spans() const { return m_spans; }
    double easeSeconds() const { return m_settings.easeSeconds; }
    bool doDiffer() const { return drawnBy(0) != drawnBy(m_spans.size() / m_each - 1); }

    /// Of the first playing, once it was made.
    const ClipPlan& firstPlan() const { return m_firstPlan; }

    /// Of playings that draw the same there is one.
    std::shared_ptr<const Clip> clip(std::size_t playing, const Progress& progress)
    {
        std::shared_ptr<const Clip>& made = m_clips[drawnBy(playing)];
        if (!made) {
            VariedPlan varied = planned(playing, progress.part(0, 0.2));
            made = std::make_shared<const Clip>(
                makeClip(varied.character, varied.plan, m_settings.interpolation, progress.part(0.2, 1)));
            if (playing == 0)
                m_firstPlan = std::move(varied.plan);
        }
        return made;
    }

    /// What one playing shows.
    VariedPlan planned(std::size_t playing, const Progress& progress) const
    {
        return variedPlan(m_frames, m_plan, std::span(m_spans).subspan(playing * m_each, m_each),
                          m_variations, m_supports, m_settings, progress);
    }

private:
    using Draws = std::vector<std::optional<std::size_t>>;
    Draws drawnBy(std::size_t playing) const
    {
        Draws draws;
        for (const SpanDraw& span : std::span(m_spans).subspan(playing * m_each, m_each))
            draws.push_back(span.variation);
        return draws;
    }

    const ClipPlan& m_plan;
    ClipPlan m_firstPlan;
    std::vector<SpanDraw> m_spans;
    std::size_t m_each; ///< spans of a playing
    std::span<const TakeVariation> m_variations;
    std::span<const Support> m_supports;
    VariedPlanSettings m_settings;
    CharacterFrames m_frames;
    std::map<Draws, std::shared_ptr<const Clip>> m_clips;
};

} // namespace

PlannedClip plannedClip(const AnimationEntry& animation, const CharacterGraph& graph,
                        const CharacterFrames& frames, const ClipPlan& plan,
                        std::span<const TakeVariation> variations, const Progress& progress)
{
    const WalkPlayings playings(animation, graph, frames, plan, variations);
    return {.plan = playings.planned(0, progress).plan, .spans = playings.spans()};
}

AnimationClip animationClip(const AnimationEntry& animation, const CharacterGraph& graph,
                            const CharacterFrames& frames, const ClipPlan& plan,
                            std::span<const TakeVariation> variations, const Progress& progress)
{
    WalkPlayings playings(animation, graph, frames, plan, variations);
    const std::shared_ptr<const Clip> clip = playings.clip(0, progress.part(0, 0.5));
    PostProcessingInputs inputs =
        postProcessingInputs(animation, graph.work(), frames, graph.roots().stances);
    inputs.asked = plan.asked;
    inputs.easeSeconds = playings.easeSeconds();
    if (playings.doDiffer())
        inputs.playing = [&](int playing, const Progress& own) {
            return playings.clip(static_cast<std::size_t>(playing), own);
        };
    PostProcessing steps = animation.post.steps;
    const bool hasNoFeet = steps.contacts && legsOf(frames, inputs.method.up).feet.empty();
    if (hasNoFeet)
        steps.contacts.reset();
    return {.processed = postProcessed(*clip, steps, inputs, progress.part(0.5, 1)),
            .plan = playings.firstPlan(),
            .spans = playings.spans(),
            .hasNoFeet = hasNoFeet};
}

} // namespace quadrille
