// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/random.h"
#include "model/parametric/similarity.h"

#include <memory>
#include <vector>

namespace quadrille::test {

/// A space of random takes that sway about a pose and walk, one for each place.
struct RandomSpace
{
    std::uint64_t seed = 1;
    std::size_t frames = 7;
    std::uint32_t vertices = 30;
    std::vector<SpacePoint> places{{1}, {3}};
    int dimension = 1;
    int bisections = 1;
    bool isCyclic = true;
};

inline std::shared_ptr<const Topology> stripOf(std::uint32_t vertices)
{
    TopologyData data;
    data.vertexCount = vertices;
    for (std::uint32_t v = 0; v + 2 < vertices; ++v)
        data.triangles.push_back({VertexIndex(v), VertexIndex(v + 1), VertexIndex(v + 2)});
    return std::make_shared<const Topology>(std::move(data));
}

inline Vec3f randomPoint(Random& random, double size)
{
    return {static_cast<float>(random.between(-size, size)), static_cast<float>(random.between(-size, size)),
            static_cast<float>(random.between(-size, size))};
}

inline SpaceReference randomReference(Random& random, std::size_t frames, std::uint32_t vertices)
{
    SpaceReference reference;
    reference.unit = 0.001F;
    const auto whole = [](Random& from) { return static_cast<std::int16_t>(from.between(-100, 100)); };
    for (std::size_t f = 0; f < frames; ++f) {
        reference.starts.push_back(static_cast<std::uint32_t>(reference.vertices.size()));
        for (std::uint32_t v = 0; v < vertices; ++v) {
            if (random.unit() > 0.3)
                continue;
            reference.vertices.push_back(v);
            reference.displacements.push_back({whole(random), whole(random), whole(random)});
        }
    }
    reference.starts.push_back(static_cast<std::uint32_t>(reference.vertices.size()));
    return reference;
}

inline MotionSpace makeSpace(const RandomSpace& made)
{
    Random random(made.seed);
    Random body(99); // the same for all spaces
    MotionSpace space;
    space.topology = stripOf(made.vertices);
    space.isCyclic = made.isCyclic;
    std::vector<Vec3f> mean;
    for (std::uint32_t v = 0; v < made.vertices; ++v)
        mean.push_back(randomPoint(body, 1));
    for (std::size_t t = 0; t < made.places.size(); ++t) {
        SpaceTake take;
        for (std::size_t f = 0; f < made.frames; ++f) {
            for (std::uint32_t v = 0; v < made.vertices; ++v)
                take.poses.push_back(mean[v] + randomPoint(random, 0.2));
            take.steps.push_back({random.between(-0.2, 0.2), Vec2d(random.unit(), random.unit()) * 0.1});
            take.seconds.push_back(random.between(0.02, 0.06));
        }
        space.takes.push_back(std::move(take));
    }
    space.weights = WeightSpace(made.places, made.dimension);
    for (int round = 0; round < made.bisections; ++round) {
        for (const std::array<int, 2>& edge : space.weights.edges()) {
            space.weights.bisect(edge);
            space.references.push_back(randomReference(random, made.frames, made.vertices));
            if (made.dimension > 1)
                break; // one edge a round is enough there
        }
    }
    return space;
}

} // namespace quadrille::test
