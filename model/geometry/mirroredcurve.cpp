// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/curveedits.h"
#include "model/geometry/surfaceroute.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace quadrille {

namespace {

/// Vertex by vertex; where a polygon is cut otherwise on the other side, around its edge. Empty where it
/// would meet itself.
std::vector<VertexIndex> opposites(const SurfaceGraph& graph, const Symmetry& symmetry,
                                   std::span<const VertexIndex> curve)
{
    std::vector<bool> blocked(graph.vertexCount());
    for (const VertexIndex v : curve)
        blocked[symmetry.opposite[v.value].value] = true;
    std::vector<VertexIndex> found;
    const OpenedSurface surface{&graph};
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const SheetVertex from{symmetry.opposite[curve[i].value], 0};
        const SheetVertex to{symmetry.opposite[curve[(i + 1) % curve.size()].value], 0};
        found.push_back(from.vertex);
        if (graph.haveEdge(from.vertex, to.vertex))
            continue;
        SurfaceDistances distances(surface);
        distances.add(from, 0);
        const auto way = shortestRoute(surface, distances, from, to, {.blocked = &blocked});
        if (!way)
            return {};
        for (const VertexIndex v : std::span(*way).subspan(1, way->size() - 2)) {
            blocked[v.value] = true;
            found.push_back(v);
        }
    }
    return found;
}

/// The corner of the opposite triangle that is nearest to the point there.
VertexIndex nearestOpposite(const SurfaceGraph& graph, const OppositePoint& point)
{
    Vec3f place = Vec3f::Zero();
    for (std::size_t c = 0; c < 3; ++c)
        place += point.weights[static_cast<Eigen::Index>(c)] * graph.pose()[point.corners[c].value];
    return *std::ranges::min_element(
        point.corners, {}, [&](VertexIndex v) { return (graph.pose()[v.value] - place).squaredNorm(); });
}

/// How far a curve keeps from another at each of its vertices: the place where it is farthest, and how far.
std::pair<std::size_t, float> farthest(const SurfaceGraph& graph, std::span<const VertexIndex> curve,
                                       std::span<const VertexIndex> other)
{
    std::pair<std::size_t, float> worst{0, -1};
    for (std::size_t i = 0; i < curve.size(); ++i) {
        float nearest = std::numeric_limits<float>::infinity();
        for (const VertexIndex v : other)
            nearest = std::min(nearest, (graph.pose()[v.value] - graph.pose()[curve[i].value]).norm());
        if (nearest > worst.second)
            worst = {i, nearest};
    }
    return worst;
}

} // namespace

std::vector<VertexIndex> guidesOf(const std::shared_ptr<const SurfaceGraph>& graph,
                                  std::span<const VertexIndex> curve, const CurveSettings& settings)
{
    constexpr std::size_t fewest = 3;
    constexpr std::size_t most = 12;
    if (curve.size() <= fewest)
        return {curve.begin(), curve.end()};
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < fewest; ++i)
        chosen.push_back(i * curve.size() / fewest);
    const auto points = [&] {
        std::vector<VertexIndex> found;
        std::ranges::transform(chosen, std::back_inserter(found), [&](std::size_t i) { return curve[i]; });
        return found;
    };
    SurfaceCurve led(graph, settings);
    while (chosen.size() < most) {
        led.setPoints(points());
        const auto [place, distance] = farthest(*graph, curve, led.vertices());
        if (distance <= 1.5F * graph->meanEdge() || std::ranges::binary_search(chosen, place))
            break;
        chosen.insert(std::ranges::upper_bound(chosen, place), place);
    }
    return points();
}

GuidedCurve mirroredCurve(const std::shared_ptr<const SurfaceGraph>& graph, const Symmetry& symmetry,
                          const GuidedCurve& curve, const CurveSettings& settings)
{
    GuidedCurve mirrored;
    if (symmetry.isExact()) {
        for (const VertexIndex p : curve.points)
            mirrored.points.push_back(symmetry.opposite[p.value]);
        mirrored.vertices = opposites(*graph, symmetry, curve.vertices);
        if (!mirrored.vertices.empty() || curve.vertices.empty())
            return mirrored;
    }
    const auto points = curve.points.empty() ? guidesOf(graph, curve.vertices, settings) : curve.points;
    mirrored.points.clear();
    for (const VertexIndex p : points) {
        const VertexIndex opposite = symmetry.isExact() ? symmetry.opposite[p.value]
                                                        : nearestOpposite(*graph, symmetry.points[p.value]);
        if (std::ranges::find(mirrored.points, opposite) == mirrored.points.end())
            mirrored.points.push_back(opposite);
    }
    SurfaceCurve led(graph, settings);
    led.setPoints(std::move(mirrored.points));
    return {led.points(), led.vertices()};
}

} // namespace quadrille
