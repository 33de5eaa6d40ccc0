// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/graphtables.h"

#include <atomic>
#include <tbb/parallel_for.h>

namespace quadrille {

DataTable graphTable(const char* name, const char* description, const Digraph& graph)
{
    TableBuilder table(name, description);
    table.whole("i").whole("j").real("weight").text("kind");
    for (const Edge& edge : graph.edges())
        table.add({std::int64_t{edge.from}, std::int64_t{edge.to}, edge.weight,
                   edge.kind == EdgeKind::Original ? "original" : "transition"});
    return std::move(table).table();
}

std::vector<CostParts> partsOfEdges(const Digraph& graph,
                                    const std::function<CostParts(const FramePair&)>& partsOf,
                                    const Progress& progress)
{
    const auto& edges = graph.edges();
    std::vector<CostParts> parts(edges.size());
    std::atomic<std::size_t> done = 0;
    tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t e) {
        if (edges[e].kind == EdgeKind::Transition)
            parts[e] = partsOf({edges[e].from, edges[e].to});
        progress.report(static_cast<double>(++done) / static_cast<double>(edges.size()));
    });
    return parts;
}

DataTable edgeTable(const char* name, const char* description, const Digraph& graph,
                    std::span<const CostParts> parts, const EdgeNaming& naming)
{
    const auto& edges = graph.edges();
    TableBuilder table(name, description);
    table.whole("i").whole("j").real("weight").text("kind").real("cost");
    table.real("pose-cost").real("contact-cost").real("velocity-cost").whole("length", "frame");
    table.text("from-sequence").whole("from-frame", "frame").text("to-sequence").whole("to-frame", "frame");
    table.reserve(edges.size());
    const FrameLayout& layout = naming.costs.layout();
    const auto sequenceOf = [&](NodeIndex node) {
        return naming.sequences[static_cast<std::size_t>(layout.sequenceOf(node))];
    };
    const auto frameOf = [&](NodeIndex node) {
        return std::int64_t{node} - layout.firstOf(layout.sequenceOf(node));
    };
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const NodeIndex i = edges[e].from;
        const NodeIndex j = edges[e].to;
        const bool isOriginal = edges[e].kind == EdgeKind::Original;
        table.add({std::int64_t{i}, std::int64_t{j}, edges[e].weight, isOriginal ? "original" : "transition",
                   isOriginal ? 0.0 : static_cast<double>(naming.costs.cost()(i, j)), parts[e].pose,
                   parts[e].contacts, parts[e].velocity,
                   isOriginal ? std::int64_t{1} : std::int64_t{naming.costs.length()(i, j)}, sequenceOf(i),
                   frameOf(i), sequenceOf(j), frameOf(j)});
    }
    return std::move(table).table();
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
