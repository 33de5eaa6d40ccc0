// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/findwalk.h"

#include "model/core/error.h"
#include "model/synthesis/keywalk.h"
#include "model/synthesis/pathsearch.h"
#include "model/synthesis/reach.h"
#include "model/synthesis/solution.h"
#include "model/synthesis/stagesearch.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <set>

namespace quadrille {

namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

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

/// \throws Error WalkKeyUnreachable.
void checkKeysReachable(const WalkGraph& graph, const std::vector<PoseKey>& keys,
                        std::vector<NodeIndex> sources)
{
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const Reach reach(graph, sources, k == 0);
        if (!reach.contains(keys[k].frame))
            throw Error(
                ErrorCode::WalkKeyUnreachable,
                {.values = {{"key", std::to_string(k + 1)},
                            {"frame", std::to_string(keys[k].frame)},
                            {"nearest", std::to_string(reach.nearest(keys[k].frame, graph.layout()))}}});
        sources = {keys[k].frame};
    }
}

/// \throws Error WalkActionImpossible where no walk can play enough of any span of an action.
void checkActionsPossible(const WalkGraph& graph, const std::vector<Action>& actions,
                          const std::vector<NodeIndex>& starts)
{
    const Reach reach(graph, starts, true);
    for (std::size_t a = 0; a < actions.size(); ++a) {
        const Action& action = actions[a];
        double most = 0;
        // What is behind the last frame with a way out is lost, unless the walk ends there.
        const bool isLast = a + 1 == actions.size() && (action.repetitions == 1 || action.duration);
        for (const WalkSpan& span : action.frames.spans) {
            NodeIndex entry = span.first;
            while (entry <= span.last && !reach.contains(entry))
                ++entry;
            NodeIndex exit = span.last;
            const auto leadsOut = [&](NodeIndex node) {
                const auto [begin, end] = graph.from(node);
                return std::any_of(graph.moves().begin() + begin, graph.moves().begin() + end,
                                   [&](const WalkMove& move) {
                                       return move.kind == EdgeKind::Transition || move.to > span.last;
                                   });
            };
            while (!isLast && exit >= entry && !leadsOut(exit))
                --exit;
            most = std::max(most, static_cast<double>(exit - entry + 1) / span.frameCount());
        }
        const double needed = action.duration ? 0 : action.leastShare;
        constexpr double percent = 100;
        if (most <= 0 || most < needed - 1e-9)
            throw Error(ErrorCode::WalkActionImpossible,
                        {.values = {{"name", action.frames.name},
                                    {"share", shortNumber(percent * needed)},
                                    {"most", shortNumber(std::floor(percent * std::max(most, 0.0)))}}});
    }
}

/// \throws Error WalkPathBlocked, WalkDemandUnmet, WalkNotFound; WalkPathImpassable, WalkDemandImpossible,
/// WalkImpossible where every way was tried.
[[noreturn]] void refuse(const WalkConstraints& constraints, const SearchSettings& settings,
                         const PathFailure& failure, const SearchEffort& effort)
{
    const std::string reached = shortNumber(std::max(failure.reached, 0.0));
    if (failure.obstacle >= 0)
        throw Error(
            effort.isComplete ? ErrorCode::WalkPathImpassable : ErrorCode::WalkPathBlocked,
            {.values = {
                 {"name", constraints.path->obstacles[static_cast<std::size_t>(failure.obstacle)].name},
                 {"reached", reached}}});
    if (failure.span >= 0) {
        const PathSpan& span = constraints.path->spans[static_cast<std::size_t>(failure.span)];
        throw Error(effort.isComplete ? ErrorCode::WalkDemandImpossible : ErrorCode::WalkDemandUnmet,
                    {.values = {{"name", span.demanded->name},
                                {"from", shortNumber(span.from)},
                                {"to", shortNumber(span.to)},
                                {"reached", reached}}});
    }
    throw Error(effort.isComplete ? ErrorCode::WalkImpossible : ErrorCode::WalkNotFound,
                {.values = {{"budget", std::to_string(settings.budget)}}});
}

/// What playing on from each frame costs along a path; empty where it is as in the graph.
std::vector<double> frameWeights(const WalkMaterial& material, const WalkConstraints& constraints,
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

/// What all searches share.
struct Task
{
    const WalkMaterial& material;
    const WalkConstraints& constraints;
    const SearchSettings& settings;
    const Progress& progress;
    const SolutionCallback& found;
    const WalkGraph& graph;
    std::vector<NodeIndex> starts;
    double beta = 0;
};

WalkSolution findKeys(const Task& task)
{
    const auto& keys = task.constraints.keys;
    const auto search = task.settings.globalKeys ? walkOverAllKeys : walkFromKeyToKey;
    const KeyWalk walk =
        search(task.graph, task.starts, keys, task.beta, task.settings.budget, task.progress);
    FoundRoute route{
        .route = walk.route, .expansions = walk.expansions, .optimal = walk.optimal, .bound = walk.bound};
    std::int64_t time = 0;
    NodeIndex node = walk.route.start;
    for (std::size_t m = 0;; ++m) {
        const auto met = std::upper_bound(walk.times.begin(), walk.times.end(), time) - walk.times.begin();
        route.stages.push_back({.node = node, .key = static_cast<std::int16_t>(met)});
        if (m == walk.route.moves.size())
            break;
        const WalkMove& move = task.graph.move(walk.route.moves[m]);
        time += move.elapsed;
        node = move.to;
    }
    const WalkStages stages(task.graph, task.constraints, task.beta, 1);
    WalkSolution solution =
        solutionOf(task.graph, stages, task.constraints, route, task.settings.mu, nullptr);
    solution.eachLeg = !task.settings.globalKeys && keys.size() > 1;
    if (task.found)
        task.found(solution);
    return solution;
}

WalkSolution findStages(const Task& task)
{
    const WalkStages stages(task.graph, task.constraints, task.beta, 1, task.settings.leastRun,
                            task.settings.leftOutWeight);
    const auto solve = [&](const FoundRoute& route) {
        return solutionOf(task.graph, stages, task.constraints, route, task.settings.mu, nullptr);
    };
    SearchEffort effort;
    const std::optional<FoundRoute> route = searchStages(
        task.graph, stages, task.starts, task.settings.budget,
        [&](const FoundRoute& better) {
            if (task.found)
                task.found(solve(better));
        },
        effort, task.progress);
    if (!route)
        refuse(task.constraints, task.settings, {}, effort);
    WalkSolution solution = solve(*route);
    solution.expansions = effort.expansions;
    return solution;
}

WalkSolution findAlongPath(const Task& task)
{
    const PathConstraint& path = *task.constraints.path;
    const WalkMotion& motion = task.material.motion;
    const PathCourse course(path, motion.roots->up, motion.metresPerUnit);
    const PathCosts costs(course, path.spans, task.graph.nodeCount(), task.beta, task.settings.charging);
    MoveMotions motions(task.graph, motion, course);
    const WalkStages stages(task.graph, task.constraints, task.beta, task.settings.mu, task.settings.leastRun,
                            task.settings.leftOutWeight);
    PathProblem problem{.graph = task.graph,
                        .stages = stages,
                        .course = course,
                        .costs = costs,
                        .motions = motions,
                        .starts = task.starts,
                        .mu = task.settings.mu,
                        .inAir = task.material.inAir};
    if (!task.constraints.start && !problem.inAir.empty())
        std::erase_if(problem.starts,
                      [&](NodeIndex node) { return problem.inAir[static_cast<std::size_t>(node)]; });
    const PathMeasure measure{course, costs, motions};
    const auto solve = [&](const FoundRoute& route) {
        return solutionOf(task.graph, stages, task.constraints, route, task.settings.mu, &measure);
    };
    PathFailure failure;
    SearchEffort effort;
    const std::optional<FoundRoute> route = searchPath(
        problem, task.settings.budget,
        [&](const FoundRoute& better) {
            if (task.found)
                task.found(solve(better));
        },
        failure, effort, task.progress);
    if (!route)
        refuse(task.constraints, task.settings, failure, effort);
    WalkSolution solution = solve(*route);
    solution.expansions = effort.expansions;
    return solution;
}

} // namespace

WalkSolution findWalk(const WalkMaterial& material, const WalkConstraints& constraints,
                      const SearchSettings& settings, const Progress& progress, const SolutionCallback& found)
{
    assert(!constraints.path || (material.motion.roots && material.motion.transition));
    const FrameLayout& layout = material.costs.layout();
    checkConstraints(constraints, settings, layout,
                     material.motion.roots ? material.motion.roots->up : UpAxis::Y);
    const WalkGraph graph(material.graph, material.costs, material.alpha, constraints.junctions,
                          frameWeights(material, constraints, settings));
    Task task{.material = material,
              .constraints = constraints,
              .settings = settings,
              .progress = progress,
              .found = found,
              .graph = graph,
              .starts = startsOf(constraints, graph.nodeCount()),
              .beta = settings.beta.value_or(betaPerAlpha * material.alpha)};
    checkKeysReachable(graph, constraints.keys, task.starts);
    checkActionsPossible(graph, constraints.actions, task.starts);
    if (constraints.path)
        return findAlongPath(task);
    const Junctions& junctions = constraints.junctions;
    if (constraints.actions.empty() && junctions.required.empty() && junctions.spans.empty())
        return findKeys(task);
    return findStages(task);
}

} // namespace quadrille
