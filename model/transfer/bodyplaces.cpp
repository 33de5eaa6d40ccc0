// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/bodyplaces.h"

#include "model/transfer/solidtarget.h"
#include "model/variation/parts/bodylimbs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// Left hand, right hand, left foot, right foot, head.
constexpr std::size_t landmarks = 5;
constexpr std::size_t headLandmark = 4;
/// How much of a distance over the body two opposite normals are worth.
constexpr float normalWeight = 0.15F;
/// Limbs differ less in length, against the body, than ways that clothes lengthen: how far a place is from
/// hands and feet counts by itself up to some shares of the body's length, and by so much. Hands may be
/// fists.
struct EndWeight
{
    float weight;
    float reach;
};
constexpr std::array<EndWeight, 4> endWeights{{{1, 0.42F}, {1, 0.42F}, {4, 0.6F}, {4, 0.6F}}};

/// Landmarks between which places are told: each place by how far it is on the way from one to the other.
constexpr std::array<std::array<std::size_t, 2>, 6> ways{{{2, 4}, {3, 4}, {0, 2}, {1, 3}, {0, 1}, {2, 3}}};

/// The way that each becomes where left and right are exchanged.
constexpr std::array<std::size_t, 6> mirroredWays{1, 0, 3, 2, 4, 5};
/// Those of them that then lead the other way: their share is one less what it was.
constexpr std::size_t firstWayAcross = 4;

/// What lies about a landmark, from its end to the trunk.
struct Reach
{
    BodyRegion end;
    float endReach; ///< shares of the body's length; so for `upperReach`
    BodyRegion upper;
    float upperReach;
    float endShare; ///< at most so much of a limb whose root clothes hide
};
constexpr std::array<Reach, landmarks> reaches{
    {{BodyRegion::LeftLowerArm, 0.26F, BodyRegion::LeftUpperArm, 0.42F, 0.62F},
     {BodyRegion::RightLowerArm, 0.26F, BodyRegion::RightUpperArm, 0.42F, 0.62F},
     {BodyRegion::LeftShin, 0.4F, BodyRegion::LeftThigh, 0.54F, 0.8F},
     {BodyRegion::RightShin, 0.4F, BodyRegion::RightThigh, 0.54F, 0.8F},
     {BodyRegion::Head, 0.18F, BodyRegion::Trunk, 0.18F, 1}}};

/// The landmarks of a body: the distances of all vertices from each.
struct Landmarks
{
    std::array<std::vector<float>, landmarks> distances;
    Vec3d across = Vec3d::UnitX(); ///< from right to left
    Vec3d up = Vec3d::UnitY();
};

Landmarks landmarksOf(const SurfaceGraph& graph, UpAxis up, const Progress& progress)
{
    BodyLimbs limbs = findLimbs(graph, up, progress);
    Landmarks found;
    found.up = limbs.up;
    const auto place = [&](VertexIndex v) -> Vec3d { return graph.pose()[v.value].cast<double>(); };
    // The head is what lies farthest from all limbs; of it the highest place, as hair hangs down.
    constexpr float headShare = 0.7F;
    std::vector<float> nearest(graph.vertexCount());
    float farthest = 0;
    for (std::uint32_t v = 0; v < graph.vertexCount(); ++v) {
        nearest[v] = std::min({limbs.hands[0].distances[v], limbs.hands[1].distances[v],
                               limbs.feet[0].distances[v], limbs.feet[1].distances[v]});
        if (std::isfinite(nearest[v]))
            farthest = std::max(farthest, nearest[v]);
    }
    VertexIndex head;
    double highest = -std::numeric_limits<double>::infinity();
    for (std::uint32_t v = 0; v < graph.vertexCount(); ++v) {
        const double height = place(VertexIndex(v)).dot(found.up);
        if (std::isfinite(nearest[v]) && nearest[v] >= headShare * farthest && height > highest) {
            highest = height;
            head = VertexIndex(v);
        }
    }
    Vec3d across = place(limbs.feet[0].tip) - place(limbs.feet[1].tip) + place(limbs.hands[0].tip) -
                   place(limbs.hands[1].tip);
    across -= across.dot(found.up) * found.up;
    if (across.norm() > 0)
        found.across = across.normalized();
    found.distances = {std::move(limbs.hands[0].distances), std::move(limbs.hands[1].distances),
                       std::move(limbs.feet[0].distances), std::move(limbs.feet[1].distances),
                       distancesFrom(graph, head)};
    return found;
}

/// How long the way from one landmark to another is with its folds smoothed out, those of clothes: through
/// the middles of what lies about the shortest one, each over a sixth of it.
float straightWay(const SurfaceGraph& graph, const std::vector<float>& from, const std::vector<float>& to)
{
    constexpr std::size_t steps = 12;
    constexpr float reach = 1.5F;  // of a middle, steps
    constexpr float aside = 0.04F; // of the way, by which others may be longer
    const float way = to[static_cast<std::size_t>(std::ranges::min_element(from) - from.begin())];
    std::array<Vec3f, steps + 1> middles;
    std::array<float, steps + 1> weights{};
    middles.fill(Vec3f::Zero());
    for (std::uint32_t v = 0; v < graph.vertexCount(); ++v) {
        const float detour = (from[v] + to[v] - way) / (aside * way);
        const float weight = std::isfinite(detour) ? std::exp(-detour * detour) : 0;
        const float at = steps * (from[v] - to[v] + way) / (2 * way);
        for (std::size_t k = 0; k <= steps; ++k) {
            const float near = weight * std::max(0.0F, 1 - std::abs(at - static_cast<float>(k)) / reach);
            if (near > 0) {
                middles[k] += near * graph.pose()[v];
                weights[k] += near;
            }
        }
    }
    float length = 0;
    std::optional<Vec3f> before;
    for (std::size_t k = 0; k <= steps; ++k) {
        if (weights[k] == 0)
            continue; // a mesh so coarse that nothing lies there
        const Vec3f middle = middles[k] / weights[k];
        if (before)
            length += (middle - *before).norm();
        before = middle;
    }
    return length;
}

/// From the feet to the head.
float bodyLength(const SurfaceGraph& graph, const Landmarks& found)
{
    const auto& distances = found.distances;
    return (straightWay(graph, distances[2], distances[headLandmark]) +
            straightWay(graph, distances[3], distances[headLandmark])) /
           2;
}

/// How far each limb reaches at most, where ways from its end to others part; infinite for the head.
std::array<float, landmarks> limbLengths(const Landmarks& found)
{
    const auto& distances = found.distances;
    std::array<std::size_t, landmarks> tips{};
    for (std::size_t l = 0; l < landmarks; ++l)
        tips[l] = static_cast<std::size_t>(std::ranges::min_element(distances[l]) - distances[l].begin());
    const auto parting = [&](std::size_t from, std::size_t one, std::size_t other) {
        return (distances[from][tips[one]] + distances[from][tips[other]] - distances[one][tips[other]]) / 2;
    };
    return {parting(0, 2, headLandmark), parting(1, 3, headLandmark), parting(2, 3, headLandmark),
            parting(3, 2, headLandmark), std::numeric_limits<float>::infinity()};
}

/// By the landmark that is nearest, and how far that is.
BodyRegion regionAt(const std::array<float, landmarks>& distances, float length,
                    const std::array<float, landmarks>& limbs)
{
    const auto nearest = std::ranges::min_element(distances);
    const auto landmark = static_cast<std::size_t>(nearest - distances.begin());
    const Reach& reach = reaches[landmark];
    return *nearest < std::min(reach.endReach * length, reach.endShare * limbs[landmark]) ? reach.end
           : *nearest < std::min(reach.upperReach * length, limbs[landmark])              ? reach.upper
                                                                                          : BodyRegion::Trunk;
}

} // namespace

BodyPlaces::BodyPlaces(const PosedMesh& mesh, UpAxis up, ErrorCode withoutLimbs, const Progress& progress)
    : m_places(mesh.topology->triangles().size())
{
    const SolidTarget solid(*mesh.topology, mesh.positions);
    const SurfaceGraph graph(solid.topology(),
                             std::vector<Vec3f>(solid.positions().begin(), solid.positions().end()));
    Landmarks found;
    try {
        found = landmarksOf(graph, up, progress);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::PartsNoLimbs)
            throw;
        throw Error(withoutLimbs);
    }
    Eigen::Matrix3d axes;
    axes << found.across.transpose(), found.up.transpose(), found.across.cross(found.up).transpose();
    const float length = bodyLength(graph, found);
    const std::array<float, landmarks> limbs = limbLengths(found);
    for (std::size_t t = 0; t < m_places.size(); ++t) {
        const auto own = solid.triangleOf(TriangleIndex(t));
        if (!own)
            continue;
        const Triangle& triangle = solid.topology()->triangles()[*own];
        Place& place = m_places[t];
        std::array<float, landmarks> distances{};
        for (std::size_t l = 0; l < landmarks; ++l) {
            for (const VertexIndex v : triangle)
                distances[l] += found.distances[l][v.value] / 3;
        }
        for (std::size_t w = 0; w < ways.size(); ++w) {
            const auto& [from, to] = ways[w];
            place.values[static_cast<Eigen::Index>(w)] = distances[from] / (distances[from] + distances[to]);
        }
        for (std::size_t end = 0; end < endWeights.size(); ++end)
            place.values[static_cast<Eigen::Index>(ways.size() + end)] =
                endWeights[end].weight * std::min(distances[end] / length, endWeights[end].reach);
        const auto corner = [&](std::size_t c) -> Vec3d {
            return graph.pose()[triangle[c].value].cast<double>();
        };
        const Vec3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        place.isUsable = normal.norm() > 0 && place.values.allFinite();
        if (!place.isUsable)
            continue;
        place.values.tail<3>() = normalWeight * (axes * normal.normalized()).cast<float>();
        place.region = regionAt(distances, length, limbs);
        place.fromEnd = *std::ranges::min_element(distances) / length;
    }
}

std::optional<TriangleIndex> BodyPlaces::nearest(const Values& values) const
{
    std::optional<TriangleIndex> best;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t t = 0; t < m_places.size(); ++t) {
        const float difference = (m_places[t].values - values).squaredNorm();
        if (m_places[t].isUsable && difference < least) {
            least = difference;
            best = TriangleIndex(t);
        }
    }
    return best;
}

std::optional<TriangleIndex> BodyPlaces::mirrored(TriangleIndex triangle) const
{
    const Values& own = m_places[triangle.value].values;
    Values values = own;
    for (std::size_t w = 0; w < ways.size(); ++w) {
        const float share = own[static_cast<Eigen::Index>(mirroredWays[w])];
        values[static_cast<Eigen::Index>(w)] = w < firstWayAcross ? share : 1 - share;
    }
    for (std::size_t end = 0; end < endWeights.size(); end += 2)
        std::swap(values[static_cast<Eigen::Index>(ways.size() + end)],
                  values[static_cast<Eigen::Index>(ways.size() + end + 1)]);
    values[static_cast<Eigen::Index>(ways.size() + endWeights.size())] *=
        -1; // what faces left then faces right
    return nearest(values);
}

std::optional<TrianglePair> mirroredPair(const TrianglePair& pair, const BodyPlaces& onTemplate,
                                         const BodyPlaces& onTarget)
{
    if (!onTemplate.knows(pair.onTemplate) || !onTarget.knows(pair.onTarget))
        return std::nullopt;
    const auto first = onTemplate.mirrored(pair.onTemplate);
    const auto second = onTarget.mirrored(pair.onTarget);
    if (!first || !second || *first == pair.onTemplate || *second == pair.onTarget)
        return std::nullopt;
    return TrianglePair{*first, *second};
}

std::vector<TrianglePair> withMirroredPairs(std::vector<TrianglePair> pairs, const BodyPlaces& onTemplate,
                                            const BodyPlaces& onTarget, const Progress& progress)
{
    const std::size_t count = pairs.size();
    for (std::size_t p = 0; p < count; ++p) {
        progress.report(static_cast<double>(p) / static_cast<double>(count));
        const auto mirrored = mirroredPair(pairs[p], onTemplate, onTarget);
        const auto hasOne = [&](const TrianglePair& other) {
            return other.onTarget == mirrored->onTarget || other.onTemplate == mirrored->onTemplate;
        };
        if (mirrored && std::ranges::none_of(pairs, hasOne))
            pairs.push_back(*mirrored);
    }
    return pairs;
}

std::vector<BodyRegion> regionsWithoutPairs(std::span<const TrianglePair> pairs, const BodyPlaces& onTemplate)
{
    std::array<bool, bodyRegions> held{};
    for (const TrianglePair& pair : pairs) {
        if (onTemplate.knows(pair.onTemplate))
            held[static_cast<std::size_t>(onTemplate.regionOf(pair.onTemplate))] = true;
    }
    std::vector<BodyRegion> without;
    for (std::size_t region = 0; region < bodyRegions; ++region) {
        if (!held[region])
            without.push_back(static_cast<BodyRegion>(region));
    }
    return without;
}

} // namespace quadrille
