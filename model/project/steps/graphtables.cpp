// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/graphtables.h"

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <utility>

namespace quadrille {

namespace {

/// A table of edges, a column after the other: large ones are filled without a row of cells for each.
class EdgeColumns
{
public:
    explicit EdgeColumns(std::span<const Edge> edges) : m_edges(edges) {}

    /// \param valueOf  (position of an edge) → Value
    template <typename Value, typename ValueOf>
    void add(const char* name, const char* unit, const ValueOf& valueOf)
    {
        std::conditional_t<std::is_same_v<Value, std::string>, TextColumn, std::vector<Value>> values;
        values.reserve(m_edges.size());
        for (std::size_t e = 0; e < m_edges.size(); ++e)
            values.push_back(valueOf(e));
        DataArray& column = m_columns.emplace_back();
        column.name = name;
        column.unit = unit;
        column.shape = {std::ssize(m_edges)};
        column.values = std::move(values);
    }

    void addEdges()
    {
        add<std::int64_t>("i", "", [this](std::size_t e) { return m_edges[e].from; });
        add<std::int64_t>("j", "", [this](std::size_t e) { return m_edges[e].to; });
        add<double>("weight", "", [this](std::size_t e) { return m_edges[e].weight; });
        add<std::string>("kind", "", [this](std::size_t e) -> const std::string& {
            static const std::string original = "original";
            static const std::string transition = "transition";
            return m_edges[e].kind == EdgeKind::Original ? original : transition;
        });
    }

    void append(EdgeColumns&& others) { std::ranges::move(others.m_columns, std::back_inserter(m_columns)); }

    DataTable table(const char* name, const char* description) &&
    {
        return {.name = name, .description = description, .columns = std::move(m_columns)};
    }

private:
    std::vector<DataArray> m_columns;
    std::span<const Edge> m_edges;
};

} // namespace

DataTable graphTable(const char* name, const char* description, const Digraph& graph)
{
    EdgeColumns columns(graph.edges());
    columns.addEdges();
    return std::move(columns).table(name, description);
}

DataTable edgeTable(const char* name, const char* description, const Digraph& graph,
                    std::vector<EdgeCost> costs, const FrameLayout& layout,
                    const std::vector<std::string>& sequences)
{
    const std::span<const Edge> edges = graph.edges();
    EdgeColumns ofCosts(edges);
    ofCosts.add<double>("cost", "", [&](std::size_t e) { return static_cast<double>(costs[e].cost); });
    ofCosts.add<double>("pose-cost", "", [&](std::size_t e) { return costs[e].parts.pose; });
    ofCosts.add<double>("contact-cost", "", [&](std::size_t e) { return costs[e].parts.contacts; });
    ofCosts.add<double>("velocity-cost", "", [&](std::size_t e) { return costs[e].parts.velocity; });
    ofCosts.add<std::int64_t>("length", "frame", [&](std::size_t e) { return costs[e].length; });
    costs = {}; // before the other columns are made: of many edges each takes much

    EdgeColumns columns(edges);
    columns.addEdges();
    columns.append(std::move(ofCosts));
    const auto addEnd = [&](const char* sequence, const char* frame, NodeIndex Edge::*end) {
        columns.add<std::string>(sequence, "", [&, end](std::size_t e) -> const std::string& {
            return sequences[static_cast<std::size_t>(layout.sequenceOf(edges[e].*end))];
        });
        columns.add<std::int64_t>(frame, "frame", [&, end](std::size_t e) {
            return edges[e].*end - layout.firstOf(layout.sequenceOf(edges[e].*end));
        });
    };
    addEnd("from-sequence", "from-frame", &Edge::from);
    addEnd("to-sequence", "to-frame", &Edge::to);
    return std::move(columns).table(name, description);
}

TableBuilder statisticsTable(std::string name, std::string description)
{
    TableBuilder table(std::move(name), std::move(description));
    table.text("graph").real("alpha").whole("nodes").whole("edges").whole("transitions").real("density");
    table.real("mean-cost").real("cost-deviation").whole("unreachable-pairs").whole("components");
    return table;
}

void addStatistics(TableBuilder& table, const std::string& graph, double alpha,
                   const GraphStatistics& statistics)
{
    table.add({graph, alpha, std::int64_t{statistics.nodes}, statistics.edges, statistics.transitions,
               statistics.density, statistics.pathCosts.mean, statistics.pathCosts.standardDeviation,
               statistics.pathCosts.unreachablePairs,
               static_cast<std::int64_t>(statistics.connectivity.components.size())});
}

TableBuilder componentTable(std::string name)
{
    TableBuilder table(
        std::move(name),
        "Strongly connected component of all frames, from 0 for the largest; −1 for frames that no walk "
        "comes "
        "back to. Reachable: a walk leads there from the largest; returns: one leads back to it.");
    table.text("graph").real("alpha").text("sequence").whole("first", "frame").whole("last", "frame");
    table.whole("component").text("reachable").text("returns");
    return table;
}

void addComponents(TableBuilder& table, const std::string& graph, double alpha,
                   const Connectivity& connectivity, const FrameLayout& layout,
                   const std::vector<std::string>& sequences)
{
    struct State
    {
        std::int64_t component = -1;
        bool isReachable = true;
        bool returns = true;
        bool operator==(const State&) const = default;
    };
    std::vector<State> states(static_cast<std::size_t>(layout.frameCount()));
    for (std::size_t c = 0; c < connectivity.components.size(); ++c) {
        for (const NodeIndex node : connectivity.components[c]) {
            if (connectivity.components[c].size() > 1)
                states[static_cast<std::size_t>(node)].component = static_cast<std::int64_t>(c);
        }
    }
    for (const NodeIndex node : connectivity.unreachable)
        states[static_cast<std::size_t>(node)].isReachable = false;
    for (const NodeIndex node : connectivity.deadEnds)
        states[static_cast<std::size_t>(node)].returns = false;
    for (int s = 0; s < layout.sequenceCount(); ++s) {
        for (NodeIndex first = layout.firstOf(s); first <= layout.lastOf(s);) {
            const State& state = states[static_cast<std::size_t>(first)];
            NodeIndex last = first;
            while (last < layout.lastOf(s) && states[static_cast<std::size_t>(last) + 1] == state)
                ++last;
            table.add({graph, alpha, sequences[static_cast<std::size_t>(s)],
                       std::int64_t{first - layout.firstOf(s)}, std::int64_t{last - layout.firstOf(s)},
                       state.component, state.isReachable ? "yes" : "no", state.returns ? "yes" : "no"});
            first = last + 1;
        }
    }
}

} // namespace quadrille
