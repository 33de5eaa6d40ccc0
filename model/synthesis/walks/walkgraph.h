// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/transitioncosts.h"
#include "model/synthesis/walks/constraints.h"

#include <span>
#include <vector>

namespace quadrille {

/// A way on from a frame of a walk.
struct WalkMove
{
    NodeIndex from = 0;
    NodeIndex to = 0;
    double weight = 0;
    std::int32_t elapsed = 1;   ///< output frames that go by: 1, or L − 1 of a transition
    std::int32_t required = -1; ///< which of the required transitions it is; −1: none
    EdgeKind kind = EdgeKind::Transition;
};

/// Numbers a move of a WalkGraph; noMove: none.
using MoveIndex = std::int32_t;
inline constexpr MoveIndex noMove = -1;

/// A walk as its moves.
struct WalkRoute
{
    NodeIndex start = 0;
    std::vector<MoveIndex> moves;
};

/// What moves cost otherwise than in the graph.
struct MoveCharges
{
    std::vector<double> frames = {}; ///< of the edge that plays on from each node; empty: as in the graph
    std::vector<bool> inAir = {};    ///< in which frames no foot stands; empty: nobody knows
    double flight = 0; ///< added to transitions of which one end is in the air and the other is not
    std::vector<double> paces = {}; ///< how fast the body gets on around each frame; empty: nobody knows
    double pace = 0;                ///< added to transitions for each unit by which these differ
};

/// Where walks can go: a graph without the banned transitions and with those that are required, and how long
/// each edge lasts.
class WalkGraph
{
public:
    /// \throws Error BadArgument for α (requireAlpha), and for a required transition that does not exist or
    /// is banned.
    WalkGraph(const Digraph& graph, const TransitionCosts& costs, double alpha, const Junctions& junctions,
              const MoveCharges& charges = {});

    NodeIndex nodeCount() const { return static_cast<NodeIndex>(m_firstOf.size()) - 1; }
    const FrameLayout& layout() const { return m_layout; }
    double alpha() const { return m_alpha; }
    std::span<const WalkMove> moves() const { return m_moves; }
    const WalkMove& move(MoveIndex index) const { return m_moves[static_cast<std::size_t>(index)]; }
    /// The moves that leave a frame, [begin, end): the lightest first, of two alike the one to the earlier
    /// frame.
    std::pair<MoveIndex, MoveIndex> from(NodeIndex node) const;
    /// The move that plays on; noMove behind the last frame of a sequence.
    MoveIndex playedOn(NodeIndex node) const { return m_playedOn[static_cast<std::size_t>(node)]; }
    /// Whether moves of required transitions are among those that leave frames.
    bool hasRequired() const { return m_hasRequired; }
    /// The move of a transition; noMove where the graph has none.
    MoveIndex transition(const FramePair& pair) const;
    /// Any move takes at least so much weight for each frame that goes by.
    double leastWeightPerFrame() const { return m_leastWeightPerFrame; }

    /// Cheapest ways to the goal from everywhere.
    struct Ways
    {
        std::vector<double> costs; ///< from each node; `unreachable` where there is no way
        std::vector<MoveIndex>
            moves; ///< the first move of the way; noMove at the goal, and where there is none
    };
    /// \param goal  cost at each node of being there; `unreachable` where it is no goal.
    /// \param perFrame  is added to weights for each frame, ≥ −leastWeightPerFrame.
    Ways waysTo(std::vector<double> goal, double perFrame = 0) const;
    Ways waysTo(NodeIndex goal, double perFrame = 0) const;
    /// The route by the ways from a node to where they end.
    WalkRoute route(const Ways& ways, NodeIndex from) const;
    Walk walk(const WalkRoute& route) const;

private:
    std::vector<WalkMove> m_moves;
    std::vector<MoveIndex> m_firstOf;
    std::vector<MoveIndex> m_playedOn; ///< by node
    bool m_hasRequired = false;
    std::vector<MoveIndex> m_into; ///< moves by their destination
    std::vector<MoveIndex> m_firstInto;
    FrameLayout m_layout;
    double m_alpha;
    double m_leastWeightPerFrame = 0;
};

} // namespace quadrille
