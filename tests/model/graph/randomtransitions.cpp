// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/graph/randomtransitions.h"

namespace quadrille {
namespace {

double randomCost(std::mt19937& engine, int levels)
{
    if (levels == 0)
        return std::uniform_real_distribution<double>(0, 1)(engine);
    return static_cast<double>(std::uniform_int_distribution<int>(0, levels)(engine)) / levels;
}

} // namespace

TransitionCosts makeTransitions(const RandomTransitions& random)
{
    std::mt19937 engine(random.seed);
    const FrameLayout layout(random.counts);
    const Eigen::Index frames = layout.frameCount();
    Table<float> cost = Table<float>::Constant(frames, frames, std::numeric_limits<float>::infinity());
    Table<std::uint16_t> length = Table<std::uint16_t>::Zero(frames, frames);
    for (Eigen::Index i = 0; i < frames; ++i) {
        for (Eigen::Index j = 0; j < frames; ++j) {
            if (i == j || std::bernoulli_distribution(random.missing)(engine))
                continue;
            cost(i, j) = static_cast<float>(randomCost(engine, random.levels));
            length(i, j) = static_cast<std::uint16_t>(random.shortest +
                                                      std::uniform_int_distribution<int>(0, 3)(engine));
        }
    }
    return {std::move(cost), std::move(length), 0.5, layout};
}

Digraph randomDigraph(std::uint32_t seed, NodeIndex nodes, double density, int levels)
{
    std::mt19937 engine(seed);
    std::vector<Edge> edges;
    for (NodeIndex i = 0; i < nodes; ++i)
        for (NodeIndex j = 0; j < nodes; ++j)
            if (i != j && std::bernoulli_distribution(density)(engine))
                edges.push_back({i, j, randomCost(engine, levels)});
    return {nodes, std::move(edges)};
}

Table<double> plainPathCosts(const Table<double>& weights)
{
    Table<double> costs = weights;
    costs.matrix().diagonal().setZero();
    for (Eigen::Index k = 0; k < costs.rows(); ++k)
        for (Eigen::Index i = 0; i < costs.rows(); ++i)
            for (Eigen::Index j = 0; j < costs.rows(); ++j)
                costs(i, j) = std::min(costs(i, j), costs(i, k) + costs(k, j));
    return costs;
}

std::vector<double> bellmanFord(const Table<double>& weights, NodeIndex from, NodeIndex leftOutTo)
{
    const auto nodes = static_cast<NodeIndex>(weights.rows());
    std::vector<double> costs(static_cast<std::size_t>(nodes), unreachable);
    costs[static_cast<std::size_t>(from)] = 0;
    bool isCheaper = true;
    for (NodeIndex round = 1; isCheaper && round < nodes; ++round) {
        isCheaper = false;
        for (NodeIndex i = 0; i < nodes; ++i) {
            for (NodeIndex j = 0; j < nodes; ++j) {
                if (i == j || (i == from && j == leftOutTo))
                    continue;
                double& known = costs[static_cast<std::size_t>(j)];
                const double found = costs[static_cast<std::size_t>(i)] + weights(i, j);
                if (found < known) {
                    known = found;
                    isCheaper = true;
                }
            }
        }
    }
    return costs;
}

} // namespace quadrille
