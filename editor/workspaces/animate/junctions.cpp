// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/junctions.h"

#include "model/project/document/groundpoint.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace quadrille {

namespace {

constexpr double nearSeconds = 0.5; ///< how far the ends of an alternative lie from those of the transition
constexpr NodeIndex apart = 3;      ///< frames by which alternatives differ at one end at least

bool isNear(const FramePair& a, const FramePair& b, NodeIndex distance)
{
    return std::abs(a.source - b.source) < distance && std::abs(a.destination - b.destination) < distance;
}

} // namespace

PricedJunction priced(const CharacterGraph& graph, const FramePair& frames)
{
    PricedJunction junction{.frames = frames,
                            .names = {graph.nameOf(frames.source), graph.nameOf(frames.destination)},
                            .length = graph.costs().length()(frames.source, frames.destination)};
    junction.duration = graph.alpha() * junction.length;
    junction.deformation =
        graph.costs().weight(frames.source, frames.destination, graph.alpha()) - junction.duration;
    return junction;
}

std::optional<std::int64_t> shownFrame(const AnimationResult& result, std::int64_t planned)
{
    const PostProcessing& post = result.entry.post.steps;
    if (!post.loop && !post.retime)
        return planned;
    const FrameProvenance& wanted = result.plan.frames[static_cast<std::size_t>(planned)].origin;
    std::optional<std::int64_t> nearest;
    double least = 2;
    for (std::size_t f = 0; f < result.origins.size(); ++f) {
        const FrameProvenance& origin = result.origins[f];
        if (origin.source != wanted.source || origin.destination != wanted.destination)
            continue;
        if (const double distance = std::abs(origin.lambda - wanted.lambda); distance < least) {
            least = distance;
            nearest = static_cast<std::int64_t>(f);
        }
    }
    return nearest;
}

std::vector<ClipJunction> junctionsOf(const AnimationResult& result)
{
    std::vector<ClipJunction> junctions;
    for (const ClipPlan::Junction& planned : result.plan.junctions) {
        ClipJunction& junction = junctions.emplace_back();
        junction.transition = priced(result.character->graph, planned.frames);
        const auto first = shownFrame(result, planned.first);
        const auto last = shownFrame(result, planned.last);
        if (first && last && *first <= *last)
            junction.shown = ClipFrames{*first, *last};
    }
    return junctions;
}

std::vector<PricedJunction> alternativesTo(const AnimationResult& result, std::size_t junction,
                                           const JunctionsEntry& decided, std::size_t count)
{
    const CharacterGraph& graph = result.character->graph;
    const Walk& walk = result.walk.solution.walk;
    const FramePair now = walk.transition(junction);
    const auto reach = static_cast<NodeIndex>(std::lround(nearSeconds * result.sequence.fps));
    const auto sequenceEnd = [&](NodeIndex frame) {
        return graph.layout().lastOf(graph.layout().sequenceOf(frame));
    };
    const auto sequenceStart = [&](NodeIndex frame) {
        return graph.layout().firstOf(graph.layout().sequenceOf(frame));
    };
    std::vector<PricedJunction> all;
    const NodeIndex lastSource = std::min(now.source + reach, sequenceEnd(now.source));
    const NodeIndex firstDestination = std::max(now.destination - reach, sequenceStart(now.destination));
    const NodeIndex lastDestination = std::min(now.destination + reach, walk.spans[junction + 1].last);
    for (NodeIndex i = std::max(now.source - reach, walk.spans[junction].first); i <= lastSource; ++i) {
        for (NodeIndex j = firstDestination; j <= lastDestination; ++j) {
            if (FramePair{i, j} != now && graph.costs().hasTransition(i, j))
                all.push_back(priced(graph, {i, j}));
        }
    }
    std::ranges::stable_sort(all, {}, &PricedJunction::weight);
    std::vector<PricedJunction> best;
    for (const PricedJunction& candidate : all) {
        if (best.size() == count)
            break;
        const bool isKnown = std::ranges::any_of(
            best, [&](const PricedJunction& taken) { return isNear(taken.frames, candidate.frames, apart); });
        if (!isKnown && !contains(decided.banned, candidate.names))
            best.push_back(candidate);
    }
    return best;
}

std::vector<JunctionEntry> neighboursOf(const CharacterGraph& graph, const FramePair& transition)
{
    std::vector<JunctionEntry> neighbours{priced(graph, transition).names};
    const FrameLayout& layout = graph.layout();
    const int from = layout.sequenceOf(transition.source);
    const int to = layout.sequenceOf(transition.destination);
    for (NodeIndex i = std::max(transition.source - apart + 1, layout.firstOf(from));
         i <= std::min(transition.source + apart - 1, layout.lastOf(from)); ++i) {
        for (const Edge& edge : graph.graph().edgesFrom(i)) {
            const FramePair other{i, edge.to};
            const bool isAlike = layout.sequenceOf(edge.to) == to && isNear(transition, other, apart);
            if (edge.kind == EdgeKind::Transition && isAlike && other != transition)
                neighbours.push_back({graph.nameOf(i), graph.nameOf(edge.to)});
        }
    }
    return neighbours;
}

std::vector<WalkSpanEntry> walkSpansOf(const AnimationResult& result)
{
    const CharacterGraph& graph = result.character->graph;
    std::vector<WalkSpanEntry> spans;
    for (const WalkSpan& span : result.walk.solution.walk.spans) {
        const NamedFrame first = graph.nameOf(span.first);
        spans.push_back({first.sequence, {first.frame, graph.nameOf(span.last).frame}});
    }
    return spans;
}

WalkEntry walkEntryOf(const AnimationResult& result)
{
    const CharacterGraph& graph = result.character->graph;
    const WalkSolution& solution = result.walk.solution;
    WalkEntry entry{.spans = walkSpansOf(result)};
    entry.turn = solution.start.turn * 180 / std::numbers::pi;
    const Vec3d centre = graph.roots().centres[static_cast<std::size_t>(solution.walk.spans.front().first)];
    entry.at = pointOfFile(solution.start(centre, Ground(result.plan.up)), result.plan.up);
    return entry;
}

bool contains(const std::vector<JunctionEntry>& junctions, const JunctionEntry& junction)
{
    return std::ranges::find(junctions, junction) != junctions.end();
}

void forget(JunctionsEntry& junctions, const JunctionEntry& junction)
{
    for (auto* list : {&junctions.banned, &junctions.locked, &junctions.chosen})
        std::erase(*list, junction);
}

void ban(JunctionsEntry& junctions, const JunctionEntry& junction)
{
    forget(junctions, junction);
    junctions.banned.push_back(junction);
}

void lock(JunctionsEntry& junctions, const JunctionEntry& junction)
{
    forget(junctions, junction);
    junctions.locked.push_back(junction);
}

void choose(JunctionsEntry& junctions, const JunctionEntry& junction, const JunctionEntry& instead)
{
    forget(junctions, junction);
    std::erase(junctions.locked, instead);
    std::erase(junctions.chosen, instead);
    junctions.chosen.push_back(junction);
}

} // namespace quadrille
