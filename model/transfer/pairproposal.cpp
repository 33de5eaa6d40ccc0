// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/pairproposal.h"

#include "model/geometry/procrustes.h"
#include "model/geometry/trianglelogs.h"
#include "model/transfer/bodyalignment.h"
#include "model/transfer/bodyplaces.h"
#include "model/transfer/farthesttriangles.h"
#include "model/transfer/solidtarget.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace quadrille {

namespace {

/// How far from each other two places that always turn against each other by a half turn count to be beyond
/// the way between them, of the root of the body's area.
constexpr double bendShare = 0.2;
/// Over which way turns are evened out, of the root of the body's area: single triangles are noisy. In rounds
/// of means over neighbours, so many at most.
constexpr double eveningShare = 0.04;
constexpr int mostRounds = 20;

/// What even means over a surface are made of.
struct Evening
{
    explicit Evening(const PosedMesh& mesh);

    /// Some rounds of means over the triangles at each vertex, and back.
    void apply(std::vector<Eigen::Matrix3f>& values) const;

    std::vector<Triangle> triangles; ///< their corners by what vertices at one place are
    std::vector<float> areas;
    std::size_t vertices = 0;
    double area = 0;
};

Evening::Evening(const PosedMesh& mesh)
{
    const SolidTarget solid(*mesh.topology, mesh.positions);
    vertices = solid.positions().size();
    for (const Triangle& t : mesh.topology->triangles()) {
        const auto corner = [&](std::size_t c) -> const Vec3f& { return mesh.positions[t[c].value]; };
        areas.push_back((corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2);
        area += static_cast<double>(areas.back());
        Triangle& own = triangles.emplace_back(t);
        for (VertexIndex& v : own)
            v = VertexIndex(solid.vertices()[v.value]);
    }
}

void Evening::apply(std::vector<Eigen::Matrix3f>& values) const
{
    std::vector<Eigen::Matrix3f> sums(vertices);
    std::vector<float> weights(vertices);
    const double edge = 1.5 * std::sqrt(area / static_cast<double>(triangles.size()));
    const double way = eveningShare * std::sqrt(area) / edge;
    const int rounds = std::clamp(static_cast<int>(std::lround(way * way)), 1, mostRounds);
    for (int round = 0; round < rounds; ++round) {
        std::ranges::fill(sums, Eigen::Matrix3f::Zero());
        std::ranges::fill(weights, 0.0F);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (const VertexIndex v : triangles[t]) {
                sums[v.value] += areas[t] * values[t];
                weights[v.value] += areas[t];
            }
        }
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (areas[t] == 0)
                continue;
            values[t].setZero();
            for (const VertexIndex v : triangles[t])
                values[t] += sums[v.value] / (3 * weights[v.value]);
        }
    }
}

/// For each triangle where it is and how it turns in each pose, so that distances between them say how far
/// from each other marks should be.
TriangleRows waysAndTurns(const PosedMesh& reference, std::span<const std::vector<Vec3f>> performed)
{
    const std::vector<Triangle>& triangles = reference.topology->triangles();
    const Evening evening(reference);
    TriangleRows rows(triangles.size(), 3 + 9 * performed.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        rows.row(static_cast<Eigen::Index>(t)).head<3>() =
            middleOf(triangles[t], reference.positions).cast<float>().transpose();
    if (performed.empty())
        return rows;
    // Matrices of opposite rotations are this far from each other.
    const double opposite = std::sqrt(8.0 * static_cast<double>(performed.size()));
    const auto scale = static_cast<float>(bendShare * std::sqrt(evening.area) / opposite);
    const PoseFrames rest = poseFrames(triangles, reference.positions);
    for (std::size_t p = 0; p < performed.size(); ++p) {
        const TriangleLogs logs =
            triangleLogs(rest, poseFrames(triangles, performed[p]), Eigen::Quaterniond::Identity());
        std::vector<Eigen::Matrix3f> turns(triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const double sine = std::sin(logs.halfAngle[t]);
            turns[t] = Eigen::Quaterniond(logs.cosine[t], sine * logs.axisX[t], sine * logs.axisY[t],
                                          sine * logs.axisZ[t])
                           .toRotationMatrix()
                           .cast<float>();
        }
        evening.apply(turns);
        for (std::size_t t = 0; t < triangles.size(); ++t)
            rows.row(static_cast<Eigen::Index>(t)).segment<9>(static_cast<Eigen::Index>(3 + 9 * p)) =
                scale * turns[t].reshaped<Eigen::RowMajor>().transpose();
    }
    return rows;
}

/// What is no part of the head, though that is nearest to it: a ponytail. A head is rigid;
/// what hangs from it is laid onto a body without the like by a turn of its own.
class Hair
{
public:
    Hair(const BodyPlaces& places, const BodyAlignment& alignment)
        : m_places(&places), m_alignment(&alignment)
    {
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (std::size_t t = 0; t < places.size(); ++t) {
            if (isOnHead(TriangleIndex(t)))
                sum += alignment.turn(TriangleIndex(t)).cast<double>();
        }
        m_head = rotationOfCovariance(sum);
    }

    bool has(TriangleIndex ofTemplate) const
    {
        constexpr double most = 25 * std::numbers::pi / 180;
        const Eigen::Quaterniond turn(m_alignment->turn(ofTemplate).cast<double>());
        return isOnHead(ofTemplate) && turn.angularDistance(m_head) > most;
    }

private:
    bool isOnHead(TriangleIndex t) const
    {
        return m_places->knows(t) && m_places->regionOf(t) == BodyRegion::Head;
    }

    const BodyPlaces* m_places;
    const BodyAlignment* m_alignment;
    Eigen::Quaterniond m_head;
};

} // namespace

std::vector<ProposedPair> proposePairs(const PosedMesh& reference, const PosedMesh& target, UpAxis up,
                                       std::span<const std::vector<Vec3f>> performed, std::size_t count,
                                       const Progress& progress)
{
    const BodyPlaces from(reference, up, ErrorCode::TransferNoLimbsOfTemplate, progress.part(0, 0.3));
    const BodyPlaces onto(target, up, ErrorCode::TransferNoLimbsOfTarget, progress.part(0.3, 0.6));
    const BodyAlignment alignment(reference, from, target, onto, up, progress.part(0.6, 0.8));
    std::vector<ProposedPair> pairs;
    std::set<TriangleIndex> taken;
    const Hair hair(from, alignment);
    std::vector<bool> isUsable(from.size());
    for (std::size_t t = 0; t < from.size(); ++t)
        isUsable[t] = from.knows(TriangleIndex(t)) && !hair.has(TriangleIndex(t));
    for (const TriangleIndex triangle :
         farthestTriangles(waysAndTurns(reference, performed), isUsable, {}, count)) {
        const std::optional<TriangleIndex> best = alignment.onTarget(triangle);
        progress.report(0.8 + 0.2 * static_cast<double>(pairs.size()) / static_cast<double>(count));
        if (!best || !taken.insert(*best).second)
            continue;
        const TrianglePair pair{triangle, *best};
        pairs.push_back({pair, alignment.likeness(pair)});
    }
    return pairs;
}

} // namespace quadrille
