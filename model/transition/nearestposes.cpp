// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/nearestposes.h"

#include "model/geometry/procrustes.h"
#include "model/transition/posedistancetile.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

std::vector<CentredPose> centred(std::span<const Positions> poses)
{
    std::vector<CentredPose> centred;
    for (const Positions& pose : poses)
        centred.push_back({pose, centroid(pose)});
    return centred;
}

/// The distances of one pose from all others.
/// \param vertices  all of them
/// \param covariances  3 × 3·others
std::vector<double> distancesOf(const CentredPose& pose, std::span<const CentredPose> others,
                                std::span<const std::size_t> vertices,
                                const Eigen::Ref<const Eigen::MatrixXd>& covariances)
{
    std::vector<RotationF> rotations;
    for (std::size_t o = 0; o < others.size(); ++o) {
        const Eigen::Quaterniond q =
            rotationOfCovariance(covariances.block<3, 3>(0, static_cast<Eigen::Index>(3 * o)));
        rotations.push_back({static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
                             static_cast<float>(q.z())});
    }
    std::vector<double> sums(others.size(), 0.0);
    VertexSlice slice;
    std::vector<VertexSlice> otherSlices(others.size());
    for (std::size_t s = 0; s < vertexSliceCount(vertices); ++s) {
        const std::span<const std::size_t> some = ofVertexSlice(vertices, s);
        fillVertexSlice(pose, some, slice);
        for (std::size_t o = 0; o < others.size(); ++o)
            fillVertexSlice(others[o], some, otherSlices[o]);
        addEuclideanDistances(slice, otherSlices.data(), rotations.data(), others.size(), sums.data());
    }
    return sums;
}

} // namespace

std::vector<NearestPose> nearestPoses(std::span<const Positions> poses, std::span<const Positions> others,
                                      const Progress& progress)
{
    std::vector<NearestPose> nearest(poses.size());
    if (poses.empty() || others.empty())
        return nearest;
    const std::vector<CentredPose> own = centred(poses);
    const std::vector<CentredPose> among = centred(others);
    const Eigen::MatrixXd all = covariances(own, among, progress.part(0, 0.3));
    std::vector<std::size_t> vertices(poses.front().size());
    std::iota(vertices.begin(), vertices.end(), std::size_t{0});
    const Progress rest = progress.part(0.3, 1);
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, own.size(), [&](std::size_t p) {
        const std::vector<double> sums =
            distancesOf(own[p], among, vertices, all.middleRows(static_cast<Eigen::Index>(3 * p), 3));
        const auto least = std::ranges::min_element(sums);
        nearest[p] = {least - sums.begin(), *least / static_cast<double>(own[p].positions.size())};
        rest.report(++done, static_cast<std::int64_t>(own.size()));
    });
    return nearest;
}

} // namespace quadrille
