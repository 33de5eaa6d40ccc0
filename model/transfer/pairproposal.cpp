// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/pairproposal.h"

#include "model/core/error.h"
#include "model/transfer/solidtarget.h"
#include "model/variation/parts/bodylimbs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace quadrille {

namespace {

/// Hands, feet, head.
constexpr std::size_t landmarks = 5;
/// How much of a distance over the body two opposite normals are worth.
constexpr float normalWeight = 0.15F;
/// A pair whose places differ so much is worth half.
constexpr double halfQuality = 0.12;

/// Landmarks between which places are told: each place by how far it is on the way from one to the other.
constexpr std::array<std::array<std::size_t, 2>, 8> ways{
    {{0, 4}, {1, 4}, {2, 4}, {3, 4}, {0, 2}, {1, 3}, {0, 1}, {2, 3}}};

/// Where a triangle lies on a body: shares of ways between landmarks and the direction that it faces.
struct Place
{
    using Values = Eigen::Matrix<float, static_cast<int>(ways.size()) + 3, 1>;
    Values values = Values::Zero();
    bool isUsable = false;
};

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
    // The head is what lies farthest from all limbs.
    VertexIndex head;
    float farthest = -1;
    for (std::uint32_t v = 0; v < graph.vertexCount(); ++v) {
        const float nearest = std::min({limbs.hands[0].distances[v], limbs.hands[1].distances[v],
                                        limbs.feet[0].distances[v], limbs.feet[1].distances[v]});
        if (std::isfinite(nearest) && nearest > farthest) {
            farthest = nearest;
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

/// The places of all triangles of a mesh. Components that hang on the body by nothing have none.
std::vector<Place> placesOf(const PosedMesh& mesh, UpAxis up, ErrorCode withoutLimbs,
                            const Progress& progress)
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
    std::vector<Place> places(mesh.topology->triangles().size());
    for (std::size_t t = 0; t < places.size(); ++t) {
        const auto own = solid.triangleOf(TriangleIndex(t));
        if (!own)
            continue;
        const Triangle& triangle = solid.topology()->triangles()[*own];
        Place& place = places[t];
        std::array<float, landmarks> distances{};
        for (std::size_t l = 0; l < landmarks; ++l) {
            for (const VertexIndex v : triangle)
                distances[l] += found.distances[l][v.value];
        }
        for (std::size_t w = 0; w < ways.size(); ++w) {
            const auto& [from, to] = ways[w];
            place.values[static_cast<Eigen::Index>(w)] = distances[from] / (distances[from] + distances[to]);
        }
        const auto corner = [&](std::size_t c) -> Vec3d {
            return graph.pose()[triangle[c].value].cast<double>();
        };
        const Vec3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        place.isUsable = normal.norm() > 0 && place.values.allFinite();
        if (place.isUsable)
            place.values.tail<3>() = normalWeight * (axes * normal.normalized()).cast<float>();
    }
    return places;
}

/// Triangles of a pose that lie far from each other.
std::vector<std::size_t> spread(const PosedMesh& mesh, const std::vector<Place>& places, std::size_t count)
{
    std::vector<Vec3f> middles;
    middles.reserve(places.size());
    for (const Triangle& t : mesh.topology->triangles())
        middles.emplace_back(
            (mesh.positions[t[0].value] + mesh.positions[t[1].value] + mesh.positions[t[2].value]) / 3);
    std::vector<float> distances(places.size());
    for (std::size_t t = 0; t < places.size(); ++t)
        distances[t] = places[t].isUsable ? std::numeric_limits<float>::max() : -1;
    std::vector<std::size_t> chosen;
    while (chosen.size() < count) {
        const auto next = static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin());
        if (distances[next] <= 0)
            break;
        chosen.push_back(next);
        for (std::size_t t = 0; t < distances.size(); ++t)
            distances[t] = std::min(distances[t], (middles[t] - middles[next]).squaredNorm());
    }
    return chosen;
}

} // namespace

std::vector<ProposedPair> proposePairs(const PosedMesh& reference, const PosedMesh& target, UpAxis up,
                                       std::size_t count, const Progress& progress)
{
    const std::vector<Place> from =
        placesOf(reference, up, ErrorCode::TransferNoLimbsOfTemplate, progress.part(0, 0.4));
    const std::vector<Place> onto =
        placesOf(target, up, ErrorCode::TransferNoLimbsOfTarget, progress.part(0.4, 0.8));
    std::vector<ProposedPair> pairs;
    std::set<std::size_t> taken;
    for (const std::size_t triangle : spread(reference, from, count)) {
        std::size_t best = onto.size();
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t t = 0; t < onto.size(); ++t) {
            const float difference = (onto[t].values - from[triangle].values).squaredNorm();
            if (onto[t].isUsable && difference < least) {
                least = difference;
                best = t;
            }
        }
        progress.report(0.8 + 0.2 * static_cast<double>(pairs.size()) / static_cast<double>(count));
        if (best == onto.size() || !taken.insert(best).second)
            continue;
        const double difference = std::sqrt(static_cast<double>(least)) / halfQuality;
        pairs.push_back({{TriangleIndex(triangle), TriangleIndex(best)}, 1 / (1 + difference * difference)});
    }
    return pairs;
}

} // namespace quadrille
