// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/stitchingplan.h"

#include "model/geometry/pointtree.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <set>
#include <tuple>

namespace quadrille {

namespace {

constexpr std::size_t noPart = std::numeric_limits<std::size_t>::max();

/// Of each component the part nearest to the root that has one of its vertices, and whether it has a seam.
struct ComponentParts
{
    std::vector<std::size_t> part;
    std::vector<bool> hasSeam;

    ComponentParts(const Topology& topology, const BodyParts& parts)
        : part(static_cast<std::size_t>(topology.statistics().components), noPart)
        , hasSeam(part.size(), false)
    {
        for (std::size_t p = 0; p < parts.parts.size(); ++p) {
            for (const VertexIndex v : parts.parts[p].vertices) {
                const std::int32_t component = topology.components()[v.value];
                if (component >= 0)
                    part[static_cast<std::size_t>(component)] =
                        std::min(part[static_cast<std::size_t>(component)], p);
            }
            for (const VertexIndex v : parts.parts[p].overlap) {
                const std::int32_t component = topology.components()[v.value];
                if (component >= 0)
                    hasSeam[static_cast<std::size_t>(component)] = true;
            }
        }
    }
};

/// Marks the vertices that a part shares with its parent or a child.
std::vector<bool> sharedVertices(const Topology& topology, const BodyParts& parts)
{
    std::vector<bool> isShared(topology.vertexCount(), false);
    for (const BodyPart& part : parts.parts) {
        for (const VertexIndex v : part.overlap)
            isShared[v.value] = true;
    }
    return isShared;
}

/// Those vertices of a part that belong to some components, as PartVertex.
template <typename Predicate>
std::vector<PartVertex> verticesOf(const BodyPart& part, Predicate belongs)
{
    std::vector<PartVertex> chosen;
    for (std::uint32_t place = 0; place < part.vertices.size(); ++place) {
        if (belongs(part.vertices[place].value))
            chosen.push_back({part.vertices[place].value, place});
    }
    return chosen;
}

/// Of some vertices those that are nearest to others in the pose, each once.
std::vector<PartVertex> nearestTo(const std::vector<PartVertex>& others, const std::vector<PartVertex>& of,
                                  Positions pose)
{
    if (of.empty())
        return {};
    std::vector<Vec3f> points;
    points.reserve(of.size());
    for (const PartVertex& v : of)
        points.push_back(pose[v.vertex]);
    const PointTree tree(points);
    std::set<std::uint32_t> nearest;
    for (const PartVertex& v : others)
        nearest.insert(tree.nearest(pose[v.vertex]));
    std::vector<PartVertex> chosen;
    chosen.reserve(nearest.size());
    for (const std::uint32_t index : nearest)
        chosen.push_back(of[index]);
    return chosen;
}

} // namespace

std::vector<std::uint32_t> placesOf(const BodyPart& part, std::span<const VertexIndex> vertices)
{
    std::vector<std::uint32_t> places;
    for (const VertexIndex v : vertices) {
        const auto place = std::ranges::lower_bound(part.vertices, v);
        assert(place != part.vertices.end() && *place == v);
        places.push_back(static_cast<std::uint32_t>(place - part.vertices.begin()));
    }
    return places;
}

std::vector<PartPlan> planParts(const Topology& topology, const BodyParts& parts)
{
    std::vector<bool> isTaken(topology.triangles().size(), false);
    std::vector<PartPlan> plans(parts.parts.size());
    for (std::size_t p = 0; p < plans.size(); ++p) {
        const BodyPart& part = parts.parts[p];
        for (const TriangleIndex t : part.overlapTriangles) {
            plans[p].overlapTriangles.push_back(t.value);
            isTaken[t.value] = true;
        }
        if (part.parent >= 0) {
            plans[p].inPart = placesOf(part, part.overlap);
            plans[p].inParent = placesOf(parts.parts[static_cast<std::size_t>(part.parent)], part.overlap);
        }
    }
    for (std::size_t p = 0; p < plans.size(); ++p) {
        for (const TriangleIndex t : parts.parts[p].triangles) {
            if (isTaken[t.value])
                continue;
            isTaken[t.value] = true;
            const std::vector<std::uint32_t> corners =
                placesOf(parts.parts[p], topology.triangles()[t.value]);
            plans[p].own.push_back({t.value, {corners[0], corners[1], corners[2]}});
        }
    }
    return plans;
}

std::vector<ComponentPlan> planComponents(const Topology& topology, const BodyParts& parts, Positions pose)
{
    const ComponentParts of(topology, parts);
    const std::vector<bool> isShared = sharedVertices(topology, parts);
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < of.part.size(); ++c) {
        if (of.part[c] != noPart)
            order.push_back(c);
    }
    const auto rank = [&](std::size_t c) { return std::tuple(!of.hasSeam[c], of.part[c], c); };
    std::ranges::sort(order, {}, rank);
    std::vector<ComponentPlan> plans;
    for (const std::size_t c : order) {
        ComponentPlan plan{
            .component = static_cast<std::int32_t>(c), .part = of.part[c], .anchors = {}, .carriers = {}};
        const BodyPart& part = parts.parts[plan.part];
        const auto isInside = [&](std::uint32_t v) { return topology.components()[v] == plan.component; };
        plan.anchors = verticesOf(part, [&](std::uint32_t v) { return isInside(v) && !isShared[v]; });
        if (plan.anchors.empty())
            plan.anchors = verticesOf(part, isInside);
        // The main components of the root stay where they are.
        if (plan.part != 0 || !of.hasSeam[c]) {
            const auto carries = [&](std::uint32_t v) {
                const std::int32_t other = topology.components()[v];
                return other >= 0 && of.hasSeam[static_cast<std::size_t>(other)] &&
                       rank(static_cast<std::size_t>(other)) < rank(c);
            };
            plan.carriers = nearestTo(plan.anchors, verticesOf(part, carries), pose);
        }
        plans.push_back(std::move(plan));
    }
    return plans;
}

} // namespace quadrille
