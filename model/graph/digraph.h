// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/transition/framelayout.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// The weight where there is no edge, the cost where there is no walk.
inline constexpr double unreachable = std::numeric_limits<double>::infinity();

enum class EdgeKind : std::uint8_t
{
    Original,   ///< from a frame to the next of its sequence
    Transition, ///< synthetic: an interpolated transition
};

/// A directed edge between two frames.
struct Edge
{
    NodeIndex from = 0;
    NodeIndex to = 0;
    double weight = 0; ///< finite, not negative
    EdgeKind kind = EdgeKind::Transition;
    bool operator==(const Edge&) const = default;
};

/// A weighted directed graph over the frames of a character: a plain value, as cheap to copy as a pointer
/// however many edges it has. At most one edge leads from one frame to another, and none from a frame to
/// itself.
class Digraph
{
public:
    Digraph() : Digraph(0, {}) {}
    /// \param edges  of frames in [0, nodeCount), sorted by source, then destination.
    Digraph(NodeIndex nodeCount, std::vector<Edge> edges);

    NodeIndex nodeCount() const { return static_cast<NodeIndex>(m_content->firstOf.size()) - 1; }
    /// All edges, sorted by source, then destination.
    std::span<const Edge> edges() const { return m_content->edges; }
    /// The edges that leave a frame, sorted by destination.
    std::span<const Edge> edgesFrom(NodeIndex node) const;
    /// The edge between two frames; null where there is none.
    const Edge* find(NodeIndex from, NodeIndex to) const;
    /// How many of the edges are of a kind.
    std::int64_t count(EdgeKind kind) const;
    /// Edges divided by the most that there could be, V(V−1); 0 for fewer than two nodes.
    double density() const;
    bool operator==(const Digraph& other) const
    {
        return m_content == other.m_content || *m_content == *other.m_content;
    }

private:
    struct Content
    {
        std::vector<Edge> edges;
        std::vector<std::size_t> firstOf{0}; ///< position of each node's first edge, and the number of edges
        bool operator==(const Content&) const = default;
    };
    std::shared_ptr<const Content> m_content; ///< never null
};

/// The graph with at most `edgeCount` edges that is left when the heaviest transitions go first (the later
/// one of two alike); original edges all stay, even where they are more.
Digraph thinned(const Digraph& graph, std::int64_t edgeCount);

/// The weights as a table, nodes × nodes: `unreachable` where there is no edge, and on the diagonal.
Table<double> weightTable(const Digraph& graph);

} // namespace quadrille
