// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/essentialgraph.h"

#include "model/graph/detours.h"
#include "model/graph/replaceableedges.h"

#include <algorithm>
#include <tbb/parallel_for.h>

namespace quadrille {
namespace {

/// The frame that an original edge leads to; −1 at the end of a sequence.
NodeIndex nextOf(const FrameLayout& layout, NodeIndex frame)
{
    return frame < layout.lastOf(layout.sequenceOf(frame)) ? frame + 1 : -1;
}

struct Candidate
{
    Edge edge;
    bool isDoubtful = false; ///< ties with another walk that may need this very edge
};

/// Finds the detours that leave later along the source's sequence, arrive earlier in the destination's and
/// play on, or both, with one transition between; and takes out the edges that are no cheaper: most of them,
/// at the price of one pass. Each goes for an edge that leaves later or arrives earlier, so that never two go
/// for each other.
void removeDominated(Table<double>& weights, Table<double>& detours, const FrameLayout& layout, double alpha)
{
    tbb::parallel_for(0, layout.sequenceCount(), [&](int source) {
        // Of the frame after i, then of i: the cheapest edge to each frame, with what is played around it.
        std::vector<double> cheapest(static_cast<std::size_t>(layout.frameCount()), unreachable);
        for (NodeIndex i = layout.lastOf(source); i >= layout.firstOf(source); --i) {
            for (int target = 0; target < layout.sequenceCount(); ++target) {
                double before = unreachable;
                for (NodeIndex j = layout.firstOf(target); j <= layout.lastOf(target); ++j) {
                    double& here = cheapest[static_cast<std::size_t>(j)];
                    const double detour = std::min(here, before) + alpha;
                    double& weight = weights(i, j);
                    here = i == j ? unreachable : std::min(detour, weight);
                    detours(i, j) = detour;
                    if (detour <= weight)
                        weight = unreachable;
                    before = here;
                }
            }
        }
    });
}

/// Frames of which every walk passes one between any two of its transitions: after one arrives, no later than
/// the next leaves.
std::vector<NodeIndex> junctionsOf(const Table<double>& weights, const FrameLayout& layout)
{
    const auto frames = static_cast<std::size_t>(layout.frameCount());
    std::vector<std::uint8_t> arrives(frames);
    std::vector<std::uint8_t> leaves(frames);
    for (NodeIndex i = 0; i < layout.frameCount(); ++i) {
        const NodeIndex next = nextOf(layout, i);
        for (NodeIndex j = 0; j < layout.frameCount(); ++j) {
            const bool isTransition = weights(i, j) < unreachable && j != next;
            arrives[static_cast<std::size_t>(j)] |= isTransition;
            leaves[static_cast<std::size_t>(i)] |= isTransition;
        }
    }
    std::vector<NodeIndex> junctions;
    for (int sequence = 0; sequence < layout.sequenceCount(); ++sequence) {
        bool hasArrived = false;
        for (NodeIndex i = layout.firstOf(sequence); i <= layout.lastOf(sequence); ++i) {
            hasArrived |= arrives[static_cast<std::size_t>(i)] != 0;
            if (hasArrived && leaves[static_cast<std::size_t>(i)]) {
                junctions.push_back(i);
                hasArrived = false;
            }
        }
    }
    return junctions;
}

/// Edges of one frame that are on a shortest path, or may be.
std::vector<Candidate> candidatesFrom(NodeIndex i, const TransitionCosts& costs, const Table<double>& weights,
                                      const Table<double>& detours)
{
    std::vector<Candidate> candidates;
    const FrameLayout& layout = costs.layout();
    const NodeIndex next = nextOf(layout, i);
    for (NodeIndex j = 0; j < layout.frameCount(); ++j) {
        const double weight = weights(i, j);
        const double detour = detours(i, j);
        if (weight == unreachable || (detour < weight * (1 - edgeTie) && j != next))
            continue;
        const Edge edge{i, j, weight, j == next ? EdgeKind::Original : EdgeKind::Transition};
        if (j == next || detour > weight * (1 + edgeTie))
            candidates.push_back({edge, false});
        else if (std::min(detours(i, i), detours(j, j)) <= nearlyFreeTrip * weight)
            candidates.push_back({edge, true});
    }
    return candidates;
}

/// \param candidates  of every frame.
/// \param doubtful  out: positions of the edges that are doubtful.
Digraph join(const std::vector<std::vector<Candidate>>& candidates, std::vector<std::size_t>& doubtful)
{
    std::vector<std::size_t> firstOf{0};
    for (const auto& row : candidates)
        firstOf.push_back(firstOf.back() + row.size());
    std::vector<Edge> edges(firstOf.back());
    tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t row) {
        std::transform(candidates[row].begin(), candidates[row].end(), edges.data() + firstOf[row],
                       [](const Candidate& candidate) { return candidate.edge; });
    });
    for (std::size_t row = 0; row < candidates.size(); ++row)
        for (std::size_t c = 0; c < candidates[row].size(); ++c)
            if (candidates[row][c].isDoubtful)
                doubtful.push_back(firstOf[row] + c);
    return {static_cast<NodeIndex>(candidates.size()), std::move(edges)};
}

} // namespace

EssentialGraph essentialGraph(const TransitionCosts& costs, double alpha, const Progress& progress)
{
    Table<double> weights = completeWeights(costs, alpha);
    const NodeIndex frames = costs.layout().frameCount();
    EssentialGraph essential{.pathCosts = Table<double>(frames, frames)};
    Table<double>& detours = essential.pathCosts;
    removeDominated(weights, detours, costs.layout(), alpha);
    lowerDetours(weights, junctionsOf(weights, costs.layout()), detours, progress.part(0, 0.9));
    std::vector<std::vector<Candidate>> candidates(static_cast<std::size_t>(frames));
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        candidates[static_cast<std::size_t>(i)] = candidatesFrom(i, costs, weights, detours);
    });
    std::vector<std::size_t> doubtful;
    essential.graph = join(candidates, doubtful);
    if (!doubtful.empty())
        essential.graph = withoutReplaceable(essential.graph, doubtful, progress.part(0.9, 1));
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        detours.row(i) = detours.row(i).min(weights.row(i));
        detours(i, i) = 0;
    });
    progress.report(1);
    return essential;
}

} // namespace quadrille
