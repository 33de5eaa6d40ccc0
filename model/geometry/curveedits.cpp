// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/curveedits.h"

#include "model/core/error.h"
#include "model/geometry/curveneighbourhood.h"
#include "model/geometry/surfaceroute.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace quadrille {

namespace {

CurveNeighbourhood boundedBy(const SurfaceGraph& graph, std::span<const VertexIndex> curve)
{
    auto found = neighbourhoodOf(graph, curve);
    if (!found)
        throw Error(ErrorCode::CurveBoundsNothing);
    return std::move(*found);
}

void block(std::vector<bool>& blocked, std::span<const VertexIndex> vertices)
{
    for (const VertexIndex v : vertices)
        blocked[v.value] = true;
}

std::size_t leftOrRight(const CurveNeighbourhood& around, CurveSide side)
{
    const std::size_t smaller = around.areas[0] <= around.areas[1] ? 0 : 1;
    return side == CurveSide::Smaller ? smaller : 1 - smaller;
}

} // namespace

std::vector<VertexIndex> shortenedCurve(const SurfaceGraph& graph, std::span<const VertexIndex> curve,
                                        double travel, std::span<const VertexIndex> obstacles)
{
    const CurveNeighbourhood around = boundedBy(graph, curve);
    std::vector<bool> blocked(graph.vertexCount());
    block(blocked, obstacles);
    std::vector<bool> within(graph.vertexCount());
    const auto reach = [&](std::size_t side) {
        return std::min(static_cast<float>(travel), around.depth(side) / 2);
    };
    const std::array<float, 2> reaches{reach(0), reach(1)};
    for (std::size_t v = 0; v < within.size(); ++v)
        within[v] = -reaches[1] <= around.offsets[v] && around.offsets[v] <= reaches[0];
    const OpenedSurface surface{&graph, &around.cut, &within};
    const int climb = around.cut.climbOf(curve);
    float shortest = std::numeric_limits<float>::infinity();
    std::vector<VertexIndex> best(curve.begin(), curve.end());
    for (const VertexIndex p : around.cut.path()) {
        if (!within[p.value] || blocked[p.value])
            continue;
        SurfaceDistances distances(surface);
        distances.add({p, 0}, 0);
        const float length = distances.growUntil({p, climb}, shortest);
        if (!(length < shortest))
            continue;
        auto way = shortestRoute(surface, distances, {p, 0}, {p, climb}, {.blocked = &blocked});
        if (!way)
            continue;
        shortest = length;
        way->pop_back();
        best = std::move(*way);
    }
    return best;
}

std::vector<VertexIndex> parallelCurve(const SurfaceGraph& graph, std::span<const VertexIndex> curve,
                                       double metres, CurveSide side, std::span<const VertexIndex> obstacles)
{
    const CurveNeighbourhood around = boundedBy(graph, curve);
    const std::size_t which = leftOrRight(around, side);
    const float sign = which == 0 ? 1.0F : -1.0F;
    const auto distance = static_cast<float>(metres);
    std::ostringstream text;
    text << metres;
    const Error none(ErrorCode::CurveNoParallel,
                     {.file = {}, .place = {}, .values = {{"distance", text.str()}}});
    const float depth = around.depth(which);
    if (!(distance > 0) || depth < distance + graph.meanEdge())
        throw none;
    std::vector<bool> blocked(graph.vertexCount());
    block(blocked, obstacles);
    block(blocked, curve);
    std::vector<bool> within(graph.vertexCount());
    for (std::size_t v = 0; v < within.size(); ++v) {
        const float offset = sign * around.offsets[v];
        within[v] = 0 < offset && offset < (distance + depth) / 2;
    }
    const auto missed = [&](VertexIndex v) { return std::abs(sign * around.offsets[v.value] - distance); };
    const OpenedSurface surface{&graph, &around.cut, &within};
    const auto deviation = [&](std::size_t place) {
        const float miss = missed(VertexIndex(place / surface.sheets()));
        return miss * miss;
    };
    std::optional<VertexIndex> start;
    for (const VertexIndex p : around.cut.path()) {
        if (within[p.value] && !blocked[p.value] && (!start || missed(p) < missed(*start)))
            start = p;
    }
    if (!start)
        throw none;
    const int climb = around.cut.climbOf(curve);
    auto way = routeNear(surface, {*start, 0}, {*start, climb}, deviation, {.blocked = &blocked});
    if (!way)
        throw none;
    way->pop_back();
    return std::move(*way);
}

} // namespace quadrille
