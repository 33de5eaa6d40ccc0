// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/digraph.h"
#include "model/graph/replaceableedges.h"
#include "model/transition/framelayout.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille {

enum class EdgeState : std::uint8_t
{
    Kept,
    Undecided,
    Tied,
    Removed,
};

/// An edge from a frame that is known.
struct OutEdge
{
    double weight;
    NodeIndex to;
    EdgeState state;
};
using OutEdges = std::vector<OutEdge>;

/// What one looks at before the edge itself.
struct EdgeExcess
{
    float excess; ///< what it weighs more than it costs at least to arrive where it does, or a little less
    NodeIndex to;
};

/// What walks of essentialEdges are sought in.
struct OutEdgeGraph
{
    /// Without edges, and transitions unreachable.
    OutEdgeGraph(const FrameLayout& layout, double alpha);

    OutEdges& from(NodeIndex node) { return edges[static_cast<std::size_t>(node)]; }
    const OutEdges& from(NodeIndex node) const { return edges[static_cast<std::size_t>(node)]; }

    /// Sorts the edges of a frame by their excess, and notes it. \pre `arriving` is known.
    void sort(NodeIndex node);

    double alpha;                                  ///< weight of original edges
    std::vector<OutEdges> edges;                   ///< of each frame
    std::vector<std::vector<EdgeExcess>> excesses; ///< of the same edges
    std::vector<double> leaving;  ///< what it costs at least to take a transition from each frame, or later
    std::vector<double> arriving; ///< what it costs at least to come to each frame by one, or earlier
    std::vector<std::uint8_t> isLast; ///< of its sequence, by frame
    double nearlyFree = 0;            ///< round trips of so much are of interest; 0: none
};

/// The cheapest walks with a frame between from `lanes` frames in a row at once, as far as they decide
/// whether undecided edges of these frames stay. Memory for one thread, used again for each block of frames.
class EdgeWalks
{
public:
    static constexpr NodeIndex lanes = 32;
    static constexpr std::size_t groups = 4; ///< of lanes that are near to each other

    /// Up to what walks to a node count where they go on; by source.
    struct Limits
    {
        const float* nextCaps; ///< of walks to the frame after it; null at the end of a sequence
        const double* bounds;
        const double* reaches;
        double leaving; ///< what a transition costs at least
        double alpha;
    };

    explicit EdgeWalks(NodeIndex nodes);

    /// Finds the walks from the frames [first, first + lanes). A walk counts where it costs no more than an
    /// undecided edge with the same ends, and a little more; walks that cannot become one are not followed.
    /// \return whether any edge is undecided; nothing is found otherwise.
    bool run(const OutEdgeGraph& graph, NodeIndex first);

    /// Of a walk from the source `lane` to a node: exact where it counts, greater otherwise. \pre run.
    double detour(NodeIndex lane, NodeIndex node) const
    {
        return m_detours[static_cast<std::size_t>(node) * lanes + static_cast<std::size_t>(lane)];
    }

private:
    using Lanes = std::array<double, static_cast<std::size_t>(lanes)>;

    bool setBounds(const OutEdgeGraph& graph);
    void setCaps(const OutEdgeGraph& graph);
    std::vector<std::pair<double, NodeIndex>> start(const OutEdgeGraph& graph);
    Limits limitsOf(const OutEdgeGraph& graph, NodeIndex node) const;
    void pass(const OutEdgeGraph& graph, NodeIndex node);
    void take(const OutEdgeGraph& graph, NodeIndex node);
    void touch(NodeIndex node);
    void clear();

    NodeIndex m_first = 0;
    NodeIndex m_end = 0;
    Lanes m_bounds{};  ///< no walk of a source that costs more counts
    Lanes m_reaches{}; ///< no walk that costs more counts once it goes on by a transition
    // By node, sources side by side.
    std::vector<double> m_direct;  ///< weights of the sources' own edges, as far as they count
    std::vector<double> m_detours; ///< with a node between
    std::vector<double> m_passed;  ///< what was passed on of both
    std::vector<float> m_caps;     ///< no walk to the node that costs more counts, nor does what comes of it
    /// By node and group: what walks may cost more than it costs at least to arrive there, to be worth
    /// taking.
    std::vector<float> m_rooms;
    std::vector<float> m_groupRooms; ///< the same by group of sources
    std::vector<std::uint8_t> m_isTouched;
    std::vector<NodeIndex> m_touched;
    std::vector<std::uint64_t> m_waiting; ///< a bit for each node whose edges are to be followed
    std::vector<std::uint32_t> m_lowered; ///< scratch: nodes that became cheaper
};

} // namespace quadrille
