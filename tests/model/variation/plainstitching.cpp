// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/variation/plainstitching.h"

#include "model/geometry/procrustes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <tuple>

namespace quadrille::test {

namespace {

/// −1, 0 or 1: how an edge crosses the half plane behind the axis.
int windingOf(const Vec3f& from, const Vec3f& to)
{
    const float product = from.y() * to.z() - from.z() * to.y();
    if ((from.z() < 0) == (to.z() < 0))
        return 0;
    // It crosses z = 0 at a y that is negative when the turn goes the long way of the sign of z.
    const float t = from.z() / (from.z() - to.z());
    if (from.y() + t * (to.y() - from.y()) > 0)
        return 0;
    return product > 0 ? 1 : -1;
}

using Matrix32 = Eigen::Matrix<double, 3, 2>;

/// Rotation and stretch of the map that takes edges and unit normal to others.
std::pair<Eigen::AngleAxisd, Eigen::Matrix3d> polar(const Matrix32& from, const Matrix32& to)
{
    const auto frame = [](const Matrix32& edges) {
        Eigen::Matrix3d full;
        full << edges, Vec3d(edges.col(0)).cross(Vec3d(edges.col(1))).normalized();
        return full;
    };
    const Eigen::Matrix3d map = frame(to) * frame(from).inverse();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {Eigen::AngleAxisd(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose())),
            svd.matrixV() * svd.singularValues().array().log().matrix().asDiagonal() *
                svd.matrixV().transpose()};
}

Eigen::Matrix3d exponential(const Eigen::Matrix3d& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
    return solver.eigenvectors() * solver.eigenvalues().array().exp().matrix().asDiagonal() *
           solver.eigenvectors().transpose();
}

/// Each part laid onto its parent, by vertices of the mesh.
std::vector<std::map<VertexIndex, Vec3d>> laidParts(const Topology& topology, const BodyParts& parts,
                                                    Positions pose, std::span<const Positions> poses)
{
    std::vector<std::map<VertexIndex, Vec3d>> laid;
    for (std::size_t p = 0; p < poses.size(); ++p) {
        const BodyPart& part = parts.parts[p];
        RigidMotion motion;
        if (part.parent >= 0) {
            std::vector<Vec3f> own;
            std::vector<Vec3f> parents;
            for (const VertexIndex v : part.overlap) {
                const auto place = std::ranges::lower_bound(part.vertices, v) - part.vertices.begin();
                own.push_back(poses[p][static_cast<std::size_t>(place)]);
                parents.push_back(laid[static_cast<std::size_t>(part.parent)].at(v).cast<float>());
            }
            std::map<VertexIndex, double> areas;
            for (const TriangleIndex t : part.overlapTriangles) {
                const auto& [a, b, c] = topology.triangles()[t.value];
                const Vec3f across = (pose[b.value] - pose[a.value]).cross(pose[c.value] - pose[a.value]);
                for (const VertexIndex v : topology.triangles()[t.value])
                    areas[v] += static_cast<double>(across.norm());
            }
            std::vector<double> weights;
            for (const VertexIndex v : part.overlap)
                weights.push_back(areas[v]);
            motion = rigidProcrustes(own, parents, weights);
        }
        laid.emplace_back();
        for (std::size_t i = 0; i < part.vertices.size(); ++i)
            laid.back()[part.vertices[i]] = motion(poses[p][i].cast<double>());
    }
    return laid;
}

} // namespace

PlainSeam plainSeam(const PartOverlap& overlap, Positions places, std::span<const double> costs)
{
    struct Way
    {
        std::size_t to;
        double cost;
        int winding;
    };
    std::vector<std::vector<Way>> ways(overlap.vertexCount());
    for (std::size_t e = 0; e < overlap.edgeCount(); ++e) {
        const auto [a, b] = overlap.endsOf(e);
        const int winding = windingOf(places[a], places[b]);
        ways[a].push_back({b, costs[e], winding});
        ways[b].push_back({a, costs[e], -winding});
    }
    PlainSeam best{.vertices = {}, .cost = std::numeric_limits<double>::infinity()};
    const std::size_t count = overlap.vertexCount();
    for (std::size_t source = 0; source < count; ++source) {
        std::vector<double> distances(3 * count, std::numeric_limits<double>::infinity());
        std::vector<std::size_t> from(3 * count, 0);
        std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>,
                            std::greater<>>
            queue;
        distances[count + source] = 0;
        queue.emplace(0.0, count + source);
        while (!queue.empty()) {
            const auto [distance, node] = queue.top();
            queue.pop();
            if (distance > distances[node])
                continue;
            for (const Way& way : ways[node % count]) {
                const int layer = static_cast<int>(node / count) + way.winding;
                if (layer < 0 || layer > 2)
                    continue;
                const std::size_t next = static_cast<std::size_t>(layer) * count + way.to;
                if (distance + way.cost < distances[next]) {
                    distances[next] = distance + way.cost;
                    from[next] = node;
                    queue.emplace(distances[next], next);
                }
            }
        }
        const std::size_t end = 2 * count + source;
        if (distances[end] < best.cost) {
            best = {.vertices = {}, .cost = distances[end]};
            for (std::size_t node = end; node != count + source; node = from[node])
                best.vertices.push_back(static_cast<std::uint32_t>(node % count));
        }
    }
    return best;
}

std::vector<Vec3f> plainStitch(const Topology& topology, const BodyParts& parts, Positions pose,
                               std::span<const Positions> poses,
                               std::span<const std::vector<VertexIndex>> seams)
{
    const std::vector<std::map<VertexIndex, Vec3d>> laid = laidParts(topology, parts, pose, poses);
    // Of each triangle the part, and how much of it the rest being its parent's.
    std::vector<std::pair<std::size_t, double>> shares(topology.triangles().size(), {0, 1.0});
    for (std::size_t p = 0; p < poses.size(); ++p) {
        for (const TriangleIndex t : parts.parts[p].triangles)
            shares[t.value] = {p, 1.0};
    }
    for (std::size_t p = 1; p < poses.size(); ++p) {
        std::vector<std::uint32_t> seam;
        for (const VertexIndex v : seams[p])
            seam.push_back(static_cast<std::uint32_t>(std::ranges::lower_bound(parts.parts[p].overlap, v) -
                                                      parts.parts[p].overlap.begin()));
        const std::vector<double> own = PartOverlap(topology, parts.parts[p], pose).shares(seam);
        for (std::size_t i = 0; i < own.size(); ++i)
            shares[parts.parts[p].overlapTriangles[i].value] = {p, own[i]};
    }
    const auto size = static_cast<Eigen::Index>(topology.vertexCount());
    std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}};
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(size, 3);
    for (std::size_t t = 0; t < shares.size(); ++t) {
        const Triangle& triangle = topology.triangles()[t];
        const auto edgesOf = [&](std::size_t part) {
            const auto at = [&](std::size_t c) { return laid[part].at(triangle[c]); };
            Matrix32 edges;
            edges << at(0) - at(2), at(1) - at(2);
            return edges;
        };
        const auto [part, share] = shares[t];
        Matrix32 edges = edgesOf(part);
        if (share < 1) {
            const Matrix32 parents = edgesOf(static_cast<std::size_t>(parts.parts[part].parent));
            const auto [turn, stretch] = polar(parents, edges);
            const Eigen::AngleAxisd partly(share * turn.angle(), turn.axis());
            edges = partly.toRotationMatrix() * exponential(share * stretch) * parents;
        }
        const auto rest = [&](std::size_t c) -> Vec3d { return pose[triangle[c].value].cast<double>(); };
        const std::array<Vec3d, 3> wanted{edges.col(0), edges.col(1), Vec3d::Zero()};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t a = (c + 1) % 3;
            const std::size_t b = (c + 2) % 3;
            const Vec3d toA = rest(a) - rest(c);
            const Vec3d toB = rest(b) - rest(c);
            const double weight = 0.5 * toA.dot(toB) / toA.cross(toB).norm();
            const auto i = static_cast<Eigen::Index>(triangle[a].value);
            const auto j = static_cast<Eigen::Index>(triangle[b].value);
            entries.emplace_back(i, i, weight);
            entries.emplace_back(j, j, weight);
            entries.emplace_back(i, j, -weight);
            entries.emplace_back(j, i, -weight);
            right.row(i) += weight * (wanted[a] - wanted[b]).transpose();
            right.row(j) += weight * (wanted[b] - wanted[a]).transpose();
        }
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::MatrixX3d solved = solver.solve(right);
    // Where the root stays: by its vertices that no other part has, or by all where there are none.
    const auto isShared = [&](VertexIndex v) {
        return std::ranges::any_of(
            parts.parts, [v](const BodyPart& part) { return std::ranges::binary_search(part.overlap, v); });
    };
    const bool hasOwn =
        !std::ranges::all_of(laid[0], [&](const auto& placed) { return isShared(placed.first); });
    Vec3d shift = Vec3d::Zero();
    double count = 0;
    for (const auto& [v, place] : laid[0]) {
        if (hasOwn && isShared(v))
            continue;
        shift += place - solved.row(static_cast<Eigen::Index>(v.value)).transpose();
        ++count;
    }
    std::vector<Vec3f> out;
    for (Eigen::Index v = 0; v < size; ++v)
        out.push_back((solved.row(v).transpose() + shift / count).cast<float>());
    return out;
}

} // namespace quadrille::test
