// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
//
// Bellman and Ford, for `lanes` sources at once: their costs of one node lie side by side, and one edge
// lowers them all. Nodes take their turns in order, so that runs of original edges are done in one sweep; an
// edge is looked at again only after the cost of its source changed.
#include "model/core/simd.h"
#include "model/graph/detours.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <tbb/parallel_for.h>
#include <vector>

namespace quadrille {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();
constexpr Eigen::Index lanes = 32;

/// The edges that lead to each node, in the order of their sources.
struct Incoming
{
    std::vector<Eigen::Index> firstOf; ///< of each node, and the number of edges
    std::vector<std::int32_t> sources;
    std::vector<double> weights;
};

Incoming incomingEdges(const Table<double>& weights)
{
    Incoming edges;
    edges.firstOf.assign(static_cast<std::size_t>(weights.cols() + 1), 0);
    const auto forEach = [&](const auto& handle) {
        for (Eigen::Index i = 0; i < weights.rows(); ++i)
            for (Eigen::Index j = 0; j < weights.cols(); ++j)
                if (i != j && weights(i, j) < unreached)
                    handle(i, j);
    };
    forEach([&](Eigen::Index, Eigen::Index j) { ++edges.firstOf[static_cast<std::size_t>(j) + 1]; });
    for (std::size_t j = 1; j < edges.firstOf.size(); ++j)
        edges.firstOf[j] += edges.firstOf[j - 1];
    edges.sources.resize(static_cast<std::size_t>(edges.firstOf.back()));
    edges.weights.resize(edges.sources.size());
    std::vector<Eigen::Index> next = edges.firstOf;
    forEach([&](Eigen::Index i, Eigen::Index j) {
        const auto position = static_cast<std::size_t>(next[static_cast<std::size_t>(j)]++);
        edges.sources[position] = static_cast<std::int32_t>(i);
        edges.weights[position] = weights(i, j);
    });
    return edges;
}

/// What is known from the sources first … first + lanes − 1 to every node.
struct Block
{
    explicit Block(Eigen::Index nodes)
        : walks(static_cast<std::size_t>(nodes * lanes), unreached)
        , detours(walks.size(), unreached)
        , changed(static_cast<std::size_t>(nodes), 0)
        , visited(static_cast<std::size_t>(nodes), -1)
    {
    }

    std::vector<double> walks;         ///< of any kind; infinite from a source to itself
    std::vector<double> detours;       ///< with a node between
    std::vector<std::int64_t> changed; ///< when a walk to the node last became cheaper
    std::vector<std::int64_t> visited; ///< when its incoming edges were last looked at
    std::int64_t now = 0;              ///< turns of nodes so far
};

/// Gives every node a turn. Returns whether any walk became cheaper.
QUADRILLE_SIMD_CLONES
bool sweep(const Incoming& edges, Eigen::Index first, Block& block)
{
    const Eigen::Index* const firstOf = edges.firstOf.data();
    const std::int32_t* const sources = edges.sources.data();
    const double* const weights = edges.weights.data();
    double* const walks = block.walks.data();
    std::int64_t* const changed = block.changed.data();
    bool isAnyLowered = false;
    for (Eigen::Index node = 0; node < std::ssize(block.changed); ++node) {
        const std::int64_t visited = block.visited[static_cast<std::size_t>(node)];
        block.visited[static_cast<std::size_t>(node)] = ++block.now;
        double costs[lanes];
        double* const known = &block.detours[static_cast<std::size_t>(node * lanes)];
        for (Eigen::Index l = 0; l < lanes; ++l)
            costs[l] = known[l];
        for (Eigen::Index e = firstOf[node]; e < firstOf[node + 1]; ++e) {
            if (changed[sources[e]] <= visited)
                continue;
            const double weight = weights[e];
            const double* const toSource = walks + sources[e] * lanes;
#pragma omp simd
            for (Eigen::Index l = 0; l < lanes; ++l) {
                const double sum = toSource[l] + weight;
                costs[l] = sum < costs[l] ? sum : costs[l];
            }
        }
        for (Eigen::Index l = 0; l < lanes; ++l)
            known[l] = costs[l];
        if (node >= first && node < first + lanes)
            costs[node - first] = unreached;
        double* const own = walks + node * lanes;
        int lowered = 0;
#pragma omp simd reduction(| : lowered)
        for (Eigen::Index l = 0; l < lanes; ++l) {
            lowered |= costs[l] < own[l];
            own[l] = costs[l] < own[l] ? costs[l] : own[l];
        }
        if (lowered) {
            changed[node] = block.now;
            isAnyLowered = true;
        }
    }
    return isAnyLowered;
}

/// The rows of a block; calls `report` before every sweep.
template <typename Report>
void relaxBlock(const Table<double>& weights, const Incoming& edges, Eigen::Index first,
                Table<double>& detours, const Report& report)
{
    Block block(weights.rows());
    const Eigen::Index end = std::min(first + lanes, weights.rows());
    for (Eigen::Index i = first; i < end; ++i) {
        for (Eigen::Index j = 0; j < weights.cols(); ++j) {
            const auto position = static_cast<std::size_t>(j * lanes + i - first);
            block.detours[position] = detours(i, j);
            block.walks[position] = i == j ? unreached : std::min(weights(i, j), detours(i, j));
        }
    }
    do
        report();
    while (sweep(edges, first, block));
    for (Eigen::Index i = first; i < end; ++i)
        for (Eigen::Index j = 0; j < weights.cols(); ++j)
            detours(i, j) = block.detours[static_cast<std::size_t>(j * lanes + i - first)];
}

} // namespace

void lowerDetoursSparsely(const Table<double>& weights, Table<double>& detours, const Progress& progress)
{
    assert(weights.rows() == weights.cols());
    assert(detours.rows() == weights.rows() && detours.cols() == weights.cols());
    const Incoming edges = incomingEdges(weights);
    const Eigen::Index blocks = (weights.rows() + lanes - 1) / lanes;
    std::atomic<Eigen::Index> done = 0;
    tbb::parallel_for(Eigen::Index{0}, blocks, [&](Eigen::Index block) {
        relaxBlock(weights, edges, block * lanes, detours, [&] { progress.report(done, blocks); });
        progress.report(++done, blocks);
    });
}

} // namespace quadrille
