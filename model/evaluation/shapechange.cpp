// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/shapechange.h"

#include "model/geometry/procrustes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

constexpr std::array methods{InterpolationMethod::Linear, InterpolationMethod::Slerp,
                             InterpolationMethod::Poisson};

double lengthOf(Positions positions, const std::array<VertexIndex, 2>& edge)
{
    return (positions[edge[1].value] - positions[edge[0].value]).cast<double>().norm();
}

double volumeOf(const Topology& topology, Positions positions)
{
    double sum = 0;
    for (const Triangle& triangle : topology.triangles()) {
        const Vec3d a = positions[triangle[0].value].cast<double>();
        const Vec3d b = positions[triangle[1].value].cast<double>();
        const Vec3d c = positions[triangle[2].value].cast<double>();
        sum += a.dot(b.cross(c));
    }
    return sum / 6;
}

} // namespace

std::vector<std::array<VertexIndex, 2>> edgesOf(const Topology& topology)
{
    std::vector<std::array<VertexIndex, 2>> edges;
    edges.reserve(topology.triangles().size() * 3);
    for (const Triangle& triangle : topology.triangles()) {
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back(
                {std::min(triangle[k], triangle[(k + 1) % 3]), std::max(triangle[k], triangle[(k + 1) % 3])});
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

ShapeChange shapeChange(const Topology& topology, std::span<const std::array<VertexIndex, 2>> edges,
                        Positions source, Positions target, double lambda, Positions between)
{
    ShapeChange change;
    double sum = 0;
    double squares = 0;
    std::int64_t count = 0;
    for (const auto& edge : edges) {
        const double expected = (1 - lambda) * lengthOf(source, edge) + lambda * lengthOf(target, edge);
        if (!(expected > 0))
            continue;
        const double part = lengthOf(between, edge) / expected - 1;
        sum += part;
        squares += part * part;
        change.greatestEdge = std::max(change.greatestEdge, std::abs(part));
        ++count;
    }
    if (count > 0) {
        change.meanEdge = sum / static_cast<double>(count);
        change.edgeDeviation = std::sqrt(squares / static_cast<double>(count));
    }
    const double expected = (1 - lambda) * volumeOf(topology, source) + lambda * volumeOf(topology, target);
    change.volume = topology.isClosed() && expected != 0 ? volumeOf(topology, between) / expected - 1
                                                         : std::numeric_limits<double>::infinity();
    return change;
}

std::vector<InterpolatedPair> interpolatePairs(const CharacterFrames& character,
                                               const std::shared_ptr<const Topology>& topology,
                                               std::span<const FramePair> pairs,
                                               std::span<const double> lambdas, const Progress& progress)
{
    const auto edges = edgesOf(*topology);
    const auto system = std::make_shared<const PoissonSystem>(topology);
    const std::size_t perPair = methods.size() * lambdas.size();
    std::vector<InterpolatedPair> all(pairs.size() * perPair);
    std::atomic<std::int64_t> done{0};
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t p) {
        progress.report(done++, std::ssize(pairs));
        const Frame source = character.frame(pairs[p].source);
        const Frame target = character.frame(pairs[p].destination);
        const RigidMotion placeTarget = rigidProcrustes(target.positions(), source.positions());
        const PoseInterpolation interpolation(std::make_shared<PreparedPose>(system, source.positions()),
                                              std::make_shared<PreparedPose>(system, target.positions()));
        std::vector<Vec3f> pose(topology->vertexCount());
        auto out = all.begin() + static_cast<std::ptrdiff_t>(p * perPair);
        for (const InterpolationMethod method : methods) {
            for (const double lambda : lambdas) {
                interpolation.at(lambda, pose, method, {}, placeTarget);
                *out++ = {
                    pairs[p], method, lambda,
                    shapeChange(*topology, edges, source.positions(), target.positions(), lambda, pose)};
            }
        }
    });
    progress.report(1);
    return all;
}

std::vector<FramePair> drawPairs(NodeIndex frameCount, int count, std::uint64_t seed)
{
    std::vector<FramePair> pairs;
    if (frameCount < 2)
        return pairs;
    std::mt19937_64 random(seed);
    const auto draw = [&random](NodeIndex below) {
        return static_cast<NodeIndex>(random() % static_cast<std::uint64_t>(below));
    };
    for (int p = 0; p < count; ++p) {
        const NodeIndex source = draw(frameCount);
        const NodeIndex other = draw(frameCount - 1);
        pairs.push_back({source, other < source ? other : other + 1});
    }
    return pairs;
}

} // namespace quadrille
