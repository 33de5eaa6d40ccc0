// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/walktask.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace quadrille {

namespace {

std::vector<NodeIndex> startsOf(const WalkConstraints& constraints, NodeIndex nodes)
{
    std::vector<NodeIndex> starts(static_cast<std::size_t>(nodes));
    std::iota(starts.begin(), starts.end(), 0);
    if (!constraints.start)
        return starts;
    std::set<NodeIndex> chosen;
    for (const WalkSpan& span : constraints.start->spans) {
        for (NodeIndex node = span.first; node <= span.last; ++node)
            chosen.insert(node);
    }
    return {chosen.begin(), chosen.end()};
}

/// What showing each frame costs along a path; empty where it is as in the graph.
std::vector<double> pathWeights(const WalkMaterial& material, const WalkConstraints& constraints,
                                const SearchSettings& settings)
{
    const auto& isLocomotion = material.locomotion;
    if (!constraints.path || !settings.prefersLocomotion)
        return {};
    const auto frames = static_cast<std::size_t>(material.costs.layout().frameCount());
    std::vector<double> weights(frames, 0);
    if (std::ranges::find(isLocomotion, true) == isLocomotion.end())
        return weights;
    for (std::size_t node = 0; node < frames; ++node)
        weights[node] = isLocomotion[node] ? 0 : settings.strayWeight * material.alpha;
    return weights;
}

} // namespace

WalkTask::WalkTask(const WalkMaterial& walkMaterial, const WalkConstraints& asked,
                   const SearchSettings& sought)
    : material(walkMaterial)
    , constraints(asked)
    , settings(sought)
    , frameWeights(pathWeights(walkMaterial, asked, sought))
    , graph(walkMaterial.graph, walkMaterial.costs, walkMaterial.alpha, asked.junctions,
            {.frames = frameWeights,
             .inAir = walkMaterial.inAir,
             .flight = asked.areKeysAlone() ? sought.flightWeight * walkMaterial.alpha : 0,
             .paces = walkMaterial.paces,
             .pace = asked.path ? sought.paceWeight * walkMaterial.alpha : 0})
    , starts(startsOf(asked, graph.nodeCount()))
    , beta(sought.beta.value_or(betaPerAlpha * walkMaterial.alpha))
{
    const std::vector<bool>& inAir = material.inAir;
    const bool stays = asked.path || (asked.areKeysAlone() && sought.flightWeight > 0);
    if (asked.start || inAir.empty() || !stays)
        return;
    std::erase_if(starts, [&](NodeIndex node) {
        const bool isRequested = asked.areKeysAlone() && asked.keys.front().frame == node;
        return inAir[static_cast<std::size_t>(node)] && !isRequested;
    });
}

WalkCourse::Along::Along(const WalkTask& task, const ConstraintAutomaton& automaton)
    : course(*task.constraints.path, task.material.motion.roots->up, task.material.motion.metresPerUnit)
    , costs(course, task.constraints.path->spans, task.graph.nodeCount(), task.beta, task.settings.charging,
            task.settings.steering)
    , motions(task.graph, task.material.motion, course,
              {.uneven = task.settings.unevenWeight * task.material.alpha, .frames = task.frameWeights})
    , problem{.graph = task.graph,
              .automaton = automaton,
              .course = course,
              .costs = costs,
              .motions = motions,
              .starts = task.starts,
              .mu = task.settings.mu,
              .inAir = task.material.inAir}
{
}

WalkCourse::WalkCourse(const WalkTask& task, int leastRun)
    : m_task(task)
    , m_automaton(task.graph, task.constraints, task.beta, task.constraints.path ? task.settings.mu : 1,
                  leastRun, task.settings.leftOutWeight)
{
    if (task.constraints.path)
        m_along.emplace(task, m_automaton);
}

FollowedCourse WalkCourse::followed()
{
    const WalkConstraints& asked = m_task.constraints;
    return {.graph = m_task.graph,
            .automaton = m_automaton,
            .path = path(),
            .starts = m_task.starts,
            .beginsLater = !asked.path && asked.keys.empty()};
}

WalkSolution WalkCourse::solution(const FoundRoute& route)
{
    if (!m_along)
        return solutionOf(m_task.graph, m_automaton, m_task.constraints, route, m_task.settings.mu, nullptr);
    const PathMeasure measure{m_along->course, m_along->costs, m_along->motions};
    return solutionOf(m_task.graph, m_automaton, m_task.constraints, route, m_task.settings.mu, &measure);
}

} // namespace quadrille
