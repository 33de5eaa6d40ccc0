// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/findwalk.h"

#include "model/core/error.h"
#include "model/synthesis/walks/automatonsearch.h"
#include "model/synthesis/walks/followwalk.h"
#include "model/synthesis/walks/keywalk.h"
#include "model/synthesis/walks/reachableset.h"
#include "model/synthesis/walks/walkimprovement.h"
#include "model/synthesis/walks/walkrepair.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// \throws Error WalkKeyUnreachable.
void checkKeysReachable(const WalkGraph& graph, const std::vector<PoseKey>& keys,
                        std::vector<NodeIndex> sources)
{
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const ReachableSet reach(graph, sources, k == 0);
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
    const ReachableSet reach(graph, starts, true);
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

/// A search, and who hears of it.
struct Search
{
    const WalkTask& task;
    const Progress& progress;
    const SolutionCallback& found;
};

WalkSolution findKeys(const Search& search)
{
    const WalkTask& task = search.task;
    const auto& keys = task.constraints.keys;
    const auto seek = task.settings.globalKeys ? walkOverAllKeys : walkFromKeyToKey;
    const KeyWalk walk =
        seek(task.graph, task.starts, keys, task.beta, task.settings.budget, search.progress);
    FoundRoute route{
        .route = walk.route, .expansions = walk.expansions, .optimal = walk.optimal, .bound = walk.bound};
    std::int64_t time = 0;
    NodeIndex node = walk.route.start;
    for (std::size_t m = 0;; ++m) {
        const auto met = std::upper_bound(walk.times.begin(), walk.times.end(), time) - walk.times.begin();
        route.states.push_back({.node = node, .key = static_cast<std::int16_t>(met)});
        if (m == walk.route.moves.size())
            break;
        const WalkMove& move = task.graph.move(walk.route.moves[m]);
        time += move.elapsed;
        node = move.to;
    }
    WalkSolution solution = WalkCourse(task, 0).solution(route);
    solution.eachLeg = !task.settings.globalKeys && keys.size() > 1;
    return solution;
}

/// Why there is none.
struct Failure
{
    PathFailure path;
    SearchEffort effort;
};

/// \param known  a walk that the result is no worse than.
std::optional<WalkSolution> findByStages(const Search& search, Failure& failure, const Walk* known = nullptr)
{
    const WalkTask& task = search.task;
    WalkCourse course(task, task.settings.leastRun);
    const auto tell = [&](const FoundRoute& better) {
        if (search.found)
            search.found(course.solution(better));
    };
    const auto improve = [&](FoundRoute route) {
        return improvedRoute(task, course, std::move(route), tell, search.progress);
    };
    if (course.path() != nullptr)
        course.path()->improve = improve;
    SearchEffort& effort = failure.effort;
    const std::int64_t budget = task.settings.budget;
    std::optional<FoundRoute> route =
        course.path() != nullptr
            ? searchPath(*course.path(), budget, tell, failure.path, effort, search.progress)
            : searchAutomaton(task.graph, course.automaton(), task.starts, budget, tell, effort,
                              search.progress);
    if (known != nullptr) {
        std::optional<FoundRoute> other =
            followWalk(course.followed(), *known, route ? route->cost : unreachable);
        if (other)
            route = std::move(other);
    }
    if (!route)
        return std::nullopt;
    if (course.path() == nullptr && !route->optimal)
        route = improve(*std::move(route));
    WalkSolution solution = course.solution(*route);
    solution.expansions = effort.expansions;
    return solution;
}

bool keepsRuns(const Walk& walk, int leastRun)
{
    return walk.transitionCount() == 0 || std::ranges::all_of(walk.spans, [leastRun](const WalkSpan& span) {
               return span.frameCount() >= leastRun;
           });
}

/// Keys alone are met exactly; where that leaves a take too soon, the automaton weighs one against the other.
WalkSolution findCalmKeys(const Search& search)
{
    WalkSolution exact = findKeys(search);
    if (!keepsRuns(exact.walk, search.task.settings.leastRun)) {
        Failure unused;
        if (std::optional<WalkSolution> calm = findByStages(search, unused, &exact.walk))
            return *std::move(calm);
    }
    if (search.found)
        search.found(exact);
    return exact;
}

} // namespace

WalkSolution findWalk(const WalkMaterial& material, const WalkConstraints& constraints,
                      const SearchSettings& settings, const Progress& progress, const SolutionCallback& found)
{
    assert(!constraints.path || (material.motion.roots && material.motion.transition));
    const FrameLayout& layout = material.costs.layout();
    checkConstraints(constraints, settings, layout,
                     material.motion.roots ? material.motion.roots->up : UpAxis::Y);
    if (std::optional<WalkSolution> kept = repairedWalk(material, constraints, settings, progress)) {
        if (found)
            found(*kept);
        return *std::move(kept);
    }
    const WalkTask task(material, constraints, settings);
    checkKeysReachable(task.graph, constraints.keys, task.starts);
    checkActionsPossible(task.graph, constraints.actions, task.starts);
    const Junctions& junctions = constraints.junctions;
    const Search search{task, progress, found};
    if (constraints.areKeysAlone() && junctions.required.empty() && junctions.spans.empty())
        return findCalmKeys(search);
    Failure failure;
    std::optional<WalkSolution> solution = findByStages(search, failure);
    if (!solution)
        refuse(constraints, settings, failure.path, failure.effort);
    return *std::move(solution);
}

} // namespace quadrille
