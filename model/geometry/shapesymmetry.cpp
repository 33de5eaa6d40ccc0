// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/shapesymmetry.h"

#include "model/geometry/nearestpoint.h"
#include "model/geometry/pointtree.h"
#include "model/geometry/procrustes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace quadrille {

namespace {

/// A share of the vertices, spread over all of them.
std::vector<Vec3f> sampled(Positions pose, std::size_t most)
{
    const std::size_t step = std::max<std::size_t>(1, pose.size() / most);
    std::vector<Vec3f> sample;
    for (std::size_t v = 0; v < pose.size(); v += step)
        sample.push_back(pose[v]);
    return sample;
}

struct Trial
{
    ReflectionPlane plane;
    double misfit = std::numeric_limits<double>::infinity(); ///< mean distance, metres
};

/// Improves a plane by turns; the worst fifth of the pairs does not count.
Trial improved(ReflectionPlane plane, Positions sample, Positions pose, const PointTree& tree, int rounds)
{
    Trial trial{.plane = plane};
    struct Pair
    {
        double distance;
        Vec3f point;
        Vec3f nearest;
    };
    for (int round = 0; round < rounds; ++round) {
        std::vector<Pair> pairs;
        for (const Vec3f& p : sample) {
            const Vec3f reflected = plane.reflected(p.cast<double>()).cast<float>();
            const Vec3f& nearest = pose[tree.nearest(reflected)];
            pairs.push_back({static_cast<double>((nearest - reflected).norm()), p, nearest});
        }
        std::ranges::stable_sort(pairs, {}, &Pair::distance);
        pairs.resize((pairs.size() * 4 + 4) / 5);
        double misfit = 0;
        std::vector<Vec3f> points;
        std::vector<Vec3f> nearest;
        for (const Pair& pair : pairs) {
            misfit += pair.distance / static_cast<double>(pairs.size());
            points.push_back(pair.point);
            nearest.push_back(pair.nearest);
        }
        if (!(misfit < trial.misfit))
            break;
        trial = {plane, misfit};
        plane = reflectionPlane(points, nearest);
    }
    return trial;
}

/// Directions spread over a half sphere, along a spiral.
std::vector<Vec3d> directions(int count)
{
    std::vector<Vec3d> found;
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5) / count;
        const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
        const double radius = std::sqrt(1 - z * z);
        found.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return found;
}

/// Finds surface points near vertices.
class SurfaceSearch
{
public:
    SurfaceSearch(const Topology& topology, Positions pose, const PointTree& tree)
        : m_topology(topology), m_pose(pose), m_tree(tree), m_trianglesAt(pose.size())
    {
        for (std::uint32_t t = 0; t < topology.triangles().size(); ++t) {
            for (const VertexIndex v : topology.triangles()[t])
                m_trianglesAt[v.value].push_back(t);
        }
    }

    /// The nearest point of the triangles around the nearest vertex and around its neighbours.
    ShapeSymmetry::Counterpart nearest(const Vec3d& p) const
    {
        std::set<std::uint32_t> triangles;
        for (const std::uint32_t t : m_trianglesAt[m_tree.nearest(p.cast<float>())]) {
            for (const VertexIndex v : m_topology.triangles()[t])
                triangles.insert(m_trianglesAt[v.value].begin(), m_trianglesAt[v.value].end());
        }
        ShapeSymmetry::Counterpart best;
        double least = std::numeric_limits<double>::infinity();
        for (const std::uint32_t t : triangles) {
            std::array<Vec3d, 3> corners;
            for (std::size_t c = 0; c < 3; ++c)
                corners[c] = m_pose[m_topology.triangles()[t][c].value].cast<double>();
            const Vec3d weights = nearestWeights(corners, p);
            const double distance =
                (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - p)
                    .squaredNorm();
            if (distance < least) {
                least = distance;
                best = {TriangleIndex(t), weights.cast<float>()};
            }
        }
        return best;
    }

private:
    const Topology& m_topology;
    Positions m_pose;
    const PointTree& m_tree;
    std::vector<std::vector<std::uint32_t>> m_trianglesAt;
};

/// Vertices that triangles use: the others have no surface near them.
std::vector<Vec3f> usedVertices(const Topology& topology, Positions pose)
{
    std::vector<Vec3f> used;
    for (std::size_t v = 0; v < pose.size(); ++v) {
        if (topology.components()[v] >= 0)
            used.push_back(pose[v]);
    }
    return used;
}

} // namespace

ShapeSymmetry shapeSymmetry(const Topology& topology, Positions pose, const Progress& progress)
{
    const std::vector<Vec3f> used = usedVertices(topology, pose);
    const PointTree usedTree(used);
    const std::vector<Vec3f> coarse = sampled(used, 400);
    const Vec3d middle = centroid(used);
    Trial best;
    const std::vector<Vec3d> tried = directions(64);
    for (std::size_t i = 0; i < tried.size(); ++i) {
        progress.report(0.6 * static_cast<double>(i) / static_cast<double>(tried.size()));
        const Trial trial = improved({tried[i], middle}, coarse, used, usedTree, 12);
        if (trial.misfit < best.misfit)
            best = trial;
    }
    best = improved(best.plane, sampled(used, 4000), used, usedTree, 40);
    ShapeSymmetry result{.plane = best.plane, .counterparts = {}};
    // Far from the surface an unused vertex counts as its own nearest; it hangs on the first triangle.
    std::vector<Vec3f> placed(pose.begin(), pose.end());
    const Vec3f far = Vec3f::Constant(1e18F);
    for (std::size_t v = 0; v < placed.size(); ++v) {
        if (topology.components()[v] < 0)
            placed[v] = far;
    }
    const PointTree tree(placed);
    const SurfaceSearch search(topology, pose, tree);
    for (std::size_t v = 0; v < pose.size(); ++v) {
        progress.part(0.7, 1).report(static_cast<std::int64_t>(v), static_cast<std::int64_t>(pose.size()));
        result.counterparts.push_back(search.nearest(result.plane.reflected(pose[v].cast<double>())));
    }
    return result;
}

} // namespace quadrille
