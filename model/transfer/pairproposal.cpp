// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/pairproposal.h"

#include "model/transfer/bodyplaces.h"

#include <algorithm>
#include <limits>
#include <set>

namespace quadrille {

namespace {

/// Triangles of a pose that lie far from each other.
std::vector<TriangleIndex> spreadOver(const PosedMesh& mesh, const BodyPlaces& places, std::size_t count)
{
    std::vector<Vec3d> middles;
    middles.reserve(places.size());
    for (const Triangle& t : mesh.topology->triangles())
        middles.push_back(middleOf(t, mesh.positions));
    std::vector<double> distances(places.size());
    for (std::size_t t = 0; t < places.size(); ++t)
        distances[t] = places.knows(TriangleIndex(t)) ? std::numeric_limits<double>::max() : -1;
    std::vector<TriangleIndex> chosen;
    while (chosen.size() < count) {
        const auto next = static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin());
        if (distances[next] <= 0)
            break;
        chosen.emplace_back(next);
        for (std::size_t t = 0; t < distances.size(); ++t)
            distances[t] = std::min(distances[t], (middles[t] - middles[next]).squaredNorm());
    }
    return chosen;
}

} // namespace

std::vector<ProposedPair> proposePairs(const PosedMesh& reference, const PosedMesh& target, UpAxis up,
                                       std::size_t count, const Progress& progress)
{
    const BodyPlaces from(reference, up, ErrorCode::TransferNoLimbsOfTemplate, progress.part(0, 0.4));
    const BodyPlaces onto(target, up, ErrorCode::TransferNoLimbsOfTarget, progress.part(0.4, 0.8));
    std::vector<ProposedPair> pairs;
    std::set<TriangleIndex> taken;
    for (const TriangleIndex triangle : spreadOver(reference, from, count)) {
        const std::optional<TriangleIndex> best = onto.nearest(from, triangle);
        progress.report(0.8 + 0.2 * static_cast<double>(pairs.size()) / static_cast<double>(count));
        if (best && taken.insert(*best).second)
            pairs.push_back({{triangle, *best}, BodyPlaces::likeness(from, triangle, onto, *best)});
    }
    return pairs;
}

} // namespace quadrille
