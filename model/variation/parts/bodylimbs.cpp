// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/bodylimbs.h"

#include "model/core/error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace quadrille {

namespace {

/// Limbs shorter than this, in heights of the figure, are ears and fingers.
constexpr double shortestLimb = 0.12;

/// The vertices of the component with the largest surface.
std::vector<VertexIndex> mainComponent(const SurfaceGraph& graph)
{
    const Topology& topology = graph.topology();
    std::vector<double> areas(static_cast<std::size_t>(topology.statistics().components));
    for (std::uint32_t t = 0; t < topology.triangles().size(); ++t) {
        const std::int32_t component = topology.components()[topology.triangles()[t][0].value];
        areas[static_cast<std::size_t>(component)] += static_cast<double>(graph.area(TriangleIndex(t)));
    }
    const auto largest = std::ranges::max_element(areas) - areas.begin();
    std::vector<VertexIndex> vertices;
    for (std::uint32_t v = 0; v < topology.vertexCount(); ++v) {
        if (topology.components()[v] == largest)
            vertices.emplace_back(v);
    }
    return vertices;
}

VertexIndex farthest(const std::vector<VertexIndex>& of, const std::vector<float>& distances)
{
    return *std::ranges::max_element(of, {}, [&](VertexIndex v) { return distances[v.value]; });
}

/// In the middle of what sticks out: the least mean distance to some vertices far from each other.
VertexIndex middleOf(const SurfaceGraph& graph, const std::vector<VertexIndex>& vertices,
                     const Progress& progress)
{
    constexpr int samples = 5;
    VertexIndex next = farthest(vertices, distancesFrom(graph, vertices.front()));
    std::vector<float> nearest(graph.vertexCount(), std::numeric_limits<float>::infinity());
    std::vector<float> sum(graph.vertexCount());
    for (int i = 0; i < samples; ++i) {
        progress.report(i, samples);
        const std::vector<float> distances = distancesFrom(graph, next);
        for (const VertexIndex v : vertices) {
            nearest[v.value] = std::min(nearest[v.value], distances[v.value]);
            sum[v.value] += distances[v.value];
        }
        next = farthest(vertices, nearest);
    }
    return *std::ranges::min_element(vertices, {}, [&](VertexIndex v) { return sum[v.value]; });
}

/// Vertices farther from the middle than all that can be reached without first coming nearer to it by some
/// length.
std::vector<VertexIndex> peaks(const SurfaceGraph& graph, std::vector<VertexIndex> vertices,
                               const std::vector<float>& distances, float length)
{
    constexpr std::uint32_t none = ~0U;
    std::ranges::stable_sort(vertices, std::greater<>(), [&](VertexIndex v) { return distances[v.value]; });
    std::vector<std::uint32_t> peakOf(graph.vertexCount(), none);
    const auto find = [&](std::uint32_t v) {
        while (peakOf[v] != v)
            v = peakOf[v] = peakOf[peakOf[v]];
        return v;
    };
    std::vector<VertexIndex> found;
    for (const VertexIndex v : vertices) {
        peakOf[v.value] = v.value;
        for (const SurfaceGraph::Edge& edge : graph.edgesOf(v)) {
            if (peakOf[edge.to] == none)
                continue;
            std::uint32_t high = find(edge.to);
            std::uint32_t low = find(v.value);
            if (high == low)
                continue;
            if (distances[high] < distances[low])
                std::swap(high, low);
            if (distances[low] - distances[v.value] > length)
                found.emplace_back(low);
            peakOf[low] = high;
        }
    }
    found.emplace_back(find(vertices.front().value));
    return found;
}

/// Mean place of the vertices that a test passes; none where it passes none.
template <typename Test>
std::optional<Vec3d> meanPlace(const SurfaceGraph& graph, Test&& passes)
{
    Vec3d sum = Vec3d::Zero();
    double count = 0;
    for (std::size_t v = 0; v < graph.vertexCount(); ++v) {
        if (!passes(v))
            continue;
        sum += graph.pose()[v].cast<double>();
        ++count;
    }
    return count > 0 ? std::optional<Vec3d>(sum / count) : std::nullopt;
}

/// Where a foot points from its heel and ankle.
Vec3d toes(const SurfaceGraph& graph, const Limb& foot, double height)
{
    const auto behind = meanPlace(graph, [&](std::size_t v) {
        const double share = static_cast<double>(foot.distances[v]) / height;
        return 0.09 < share && share < 0.15;
    });
    return behind ? Vec3d(graph.pose()[foot.tip.value].cast<double>() - *behind) : Vec3d::Zero();
}

/// From the middle of the trunk's half that is nearer to one foot to that of the other.
Vec3d acrossTrunk(const SurfaceGraph& graph, const Limb& from, const Limb& to, double height)
{
    const auto half = [&](const Limb& near, const Limb& far) {
        return meanPlace(graph, [&](std::size_t v) {
            const double share = static_cast<double>(near.distances[v]) / height;
            return near.distances[v] < far.distances[v] && 0.55 < share && share < 0.8;
        });
    };
    const auto one = half(from, to);
    const auto other = half(to, from);
    return one && other ? Vec3d(*other - *one) : Vec3d::Zero();
}

float between(const Limb& limb, const Limb& other)
{
    return limb.distances[other.tip.value];
}

} // namespace

std::vector<float> distancesFrom(const SurfaceGraph& graph, VertexIndex vertex)
{
    SurfaceDistances distances(graph);
    distances.add({vertex, 0}, 0);
    distances.growTo(std::numeric_limits<float>::infinity());
    std::vector<float> found(graph.vertexCount());
    for (std::uint32_t v = 0; v < graph.vertexCount(); ++v)
        found[v] = distances.at({VertexIndex(v), 0});
    return found;
}

BodyLimbs findLimbs(const SurfaceGraph& graph, UpAxis up, const Progress& progress)
{
    BodyLimbs body;
    body.up = Vec3d::Unit(static_cast<Eigen::Index>(up));
    const std::vector<VertexIndex> vertices = mainComponent(graph);
    const auto heightOf = [&](VertexIndex v) { return graph.pose()[v.value].cast<double>().dot(body.up); };
    const auto [lowest, highest] = std::ranges::minmax(vertices, {}, heightOf);
    body.height = heightOf(highest) - heightOf(lowest);
    const VertexIndex middle = middleOf(graph, vertices, progress.part(0, 0.5));
    const std::vector<VertexIndex> tips =
        peaks(graph, vertices, distancesFrom(graph, middle), static_cast<float>(shortestLimb * body.height));
    std::vector<Limb> limbs;
    for (const VertexIndex tip : tips) {
        progress.part(0.5, 1).report(static_cast<std::int64_t>(limbs.size()),
                                     static_cast<std::int64_t>(tips.size()));
        limbs.push_back({tip, distancesFrom(graph, tip)});
    }
    std::ranges::sort(limbs, {}, [&](const Limb& limb) { return heightOf(limb.tip); });
    constexpr double lowestHand = 0.2;
    if (limbs.size() < 4 || heightOf(limbs[2].tip) < heightOf(lowest) + lowestHand * body.height)
        throw Error(ErrorCode::PartsNoLimbs,
                    {.file = {}, .place = {}, .values = {{"found", std::to_string(tips.size())}}});
    // Of head, hair and hands the two farthest from each other come to stand behind the feet.
    std::array<std::size_t, 2> hands{2, 3};
    for (std::size_t i = 2; i < limbs.size(); ++i) {
        for (std::size_t j = 2; j < i; ++j) {
            if (between(limbs[i], limbs[j]) > between(limbs[hands[0]], limbs[hands[1]]))
                hands = {j, i};
        }
    }
    std::swap(limbs[2], limbs[hands[0]]);
    std::swap(limbs[3], limbs[hands[1]]);
    const Vec3d ahead = toes(graph, limbs[0], body.height) + toes(graph, limbs[1], body.height);
    if (body.up.cross(ahead).dot(acrossTrunk(graph, limbs[0], limbs[1], body.height)) > 0)
        std::swap(limbs[0], limbs[1]);
    if (between(limbs[0], limbs[2]) + between(limbs[1], limbs[3]) >
        between(limbs[0], limbs[3]) + between(limbs[1], limbs[2]))
        std::swap(limbs[2], limbs[3]);
    body.hasMore = limbs.size() > 4;
    body.feet = {std::move(limbs[0]), std::move(limbs[1])};
    body.hands = {std::move(limbs[2]), std::move(limbs[3])};
    return body;
}

} // namespace quadrille
