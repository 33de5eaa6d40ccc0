// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/clipplan.h"

#include "model/core/badargument.h"

#include <cassert>

namespace quadrille {

namespace {

/// Appends spans and transitions, each where the one before it ends.
class Planner
{
public:
    Planner(const RootPoses& roots, const PlanOptions& options)
        : m_roots(roots), m_options(options), m_place(options.start)
    {
        m_plan.up = roots.up;
    }

    void add(const WalkSpan& span)
    {
        m_plan.spanStarts.push_back(m_plan.frameCount() - (m_firstIsShown ? 1 : 0));
        for (NodeIndex node = span.first + (m_firstIsShown ? 1 : 0); node <= span.last; ++node) {
            m_plan.frames.push_back(
                {.origin = {.source = node, .destination = node},
                 .times = {.source = {.frame = node}, .destination = {.frame = node}},
                 .placeSource = m_place,
                 .placeDestination = m_place,
                 .centre = m_place(m_roots.centres[static_cast<std::size_t>(node)], Ground(m_roots.up))});
        }
    }

    void add(const Transition& transition)
    {
        const TransitionMotion motion = transitionMotion(m_roots, transition, m_options.blend);
        const std::int64_t first = m_plan.frameCount() - 1;
        for (std::size_t t = 1; t + 1 < motion.steps.size(); ++t)
            m_plan.frames.push_back(placed(motion.steps[t]));
        m_firstIsShown = motion.steps.size() == 1;
        m_plan.junctions.push_back({.frames = transition.frames,
                                    .first = first,
                                    .last = first + static_cast<std::int64_t>(motion.steps.size()) - 1,
                                    .cost = transition.cost});
        m_place = m_place * motion.exit();
    }

    ClipPlan take() { return std::move(m_plan); }

private:
    PlannedFrame placed(const TransitionMotion::Step& step) const
    {
        const NodeIndex source = step.times.source.nearest();
        const NodeIndex destination = step.times.destination.nearest();
        return {.origin = {.source = source,
                           .destination = destination,
                           .lambda = source == destination ? 0 : step.lambda},
                .times = step.times,
                .lambda = step.lambda,
                .placeSource = m_place * step.placeSource,
                .placeDestination = m_place * step.placeDestination,
                .centre = m_place(step.centre, Ground(m_roots.up))};
    }

    const RootPoses& m_roots;
    PlanOptions m_options;
    ClipPlan m_plan;
    GroundMotion m_place;        ///< of the sequence that plays
    bool m_firstIsShown = false; ///< the transition before shows the first frame of the span
};

} // namespace

void checkWalk(const Walk& walk, const FrameLayout& layout)
{
    if (walk.isEmpty())
        refuse("The walk has no frames", "Choose at least one frame.");
    for (std::size_t s = 0; s < walk.spans.size(); ++s) {
        const WalkSpan& span = walk.spans[s];
        const auto exists = [&layout](NodeIndex frame) { return frame >= 0 && frame < layout.frameCount(); };
        if (exists(span.first) && exists(span.last) && span.first <= span.last &&
            layout.sequenceOf(span.first) == layout.sequenceOf(span.last))
            continue;
        refuse("Span " + std::to_string(s + 1) + " of the walk plays frames " + std::to_string(span.first) +
                   " to " + std::to_string(span.last) + ", which are not frames of one sequence in order",
               "Choose frames of one sequence, from 0 to " + std::to_string(layout.frameCount() - 1) + ".");
    }
}

std::vector<Transition> transitionsOf(const Walk& walk, const FrameLayout& layout, const WarpPaths& paths)
{
    checkWalk(walk, layout);
    std::vector<Transition> transitions;
    transitions.reserve(walk.transitionCount());
    for (std::size_t t = 0; t < walk.transitionCount(); ++t)
        transitions.push_back(paths.get(walk.transition(t)));
    return transitions;
}

ClipPlan planClip(const RootPoses& roots, const Walk& walk, std::span<const Transition> transitions,
                  const PlanOptions& options)
{
    assert(!walk.isEmpty() && transitions.size() == walk.transitionCount());
    Planner planner(roots, options);
    for (std::size_t s = 0; s < walk.spans.size(); ++s) {
        if (s > 0) {
            assert(transitions[s - 1].frames == walk.transition(s - 1));
            planner.add(transitions[s - 1]);
        }
        planner.add(walk.spans[s]);
    }
    return planner.take();
}

ClipPlan planClip(const RootPoses& roots, const FrameLayout& layout, const WarpPaths& paths, const Walk& walk,
                  const PlanOptions& options)
{
    return planClip(roots, walk, transitionsOf(walk, layout, paths), options);
}

CentreTrajectories centreTrajectories(const RootPoses& roots, const Transition& transition,
                                      std::optional<double> constantWeight)
{
    const auto centres = [&](BlendAlignment alignment) {
        std::vector<Vec3d> points;
        const BlendSettings settings{.alignment = alignment, .constantWeight = constantWeight};
        for (const auto& step : transitionMotion(roots, transition, settings).steps)
            points.push_back(step.centre);
        return points;
    };
    return {.everyStep = centres(BlendAlignment::EveryStep),
            .midWindow = centres(BlendAlignment::MidWindow),
            .none = centres(BlendAlignment::None)};
}

} // namespace quadrille
