// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/geometry/procrustes.h"
#include "model/variation/partoverlap.h"
#include "model/variation/stitching.h"
#include "tests/model/codeof.h"
#include "tests/model/transition/bars.h"
#include "tests/model/variation/handmadeparts.h"

#include <gtest/gtest.h>
#include <numbers>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::testing;

namespace {

using Pose = std::vector<Vec3f>;

const RigidMotion someMotion{Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Vec3d(1, 2, -0.5).normalized())),
                             Vec3d(3, -1, 0.4)};
const RigidMotion otherMotion{Eigen::Quaterniond(Eigen::AngleAxisd(2.2, Vec3d(-1, 0.3, 2).normalized())),
                              Vec3d(-2, 0.1, 5)};

Pose movedBy(const Pose& pose, const RigidMotion& motion)
{
    return moved(pose, [&](const Vec3d& p) { return motion(p); });
}

double largestDistance(Positions a, Positions b)
{
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        largest = std::max(largest, (a[v] - b[v]).cast<double>().norm());
    return largest;
}

Pose stitched(const Stitching& stitching, const std::vector<Pose>& poses)
{
    Pose out(stitching.topology().vertexCount());
    stitching.stitch(viewed(poses), out);
    return out;
}

std::vector<Pose> cutDifferently(const PartedBar& parted, const std::vector<Pose>& wholes)
{
    std::vector<Pose> poses;
    for (std::size_t p = 0; p < wholes.size(); ++p)
        poses.push_back(cutPose(parted.parts, wholes[p])[p]);
    return poses;
}

/// Bars that are bent and twisted differently, one for each part.
std::vector<Pose> variousPoses(const PartedBar& parted, double amount)
{
    std::vector<Pose> wholes;
    for (int p = 0; p < 5; ++p)
        wholes.push_back(
            bent(twisted(parted.bar.positions, 2.0, amount * (p - 2)), 2.0, 0.6 + amount * (p % 3)));
    return cutDifferently(parted, wholes);
}

/// Between the normals of the two triangles at an edge, radians.
double creaseAt(const Topology& topology, Positions pose, VertexIndex a, VertexIndex b)
{
    std::vector<Vec3d> normals;
    for (const Triangle& triangle : topology.triangles()) {
        if (std::ranges::find(triangle, a) == triangle.end() ||
            std::ranges::find(triangle, b) == triangle.end())
            continue;
        const auto corner = [&](std::size_t c) -> Vec3d { return pose[triangle[c].value].cast<double>(); };
        normals.push_back((corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized());
    }
    return normals.size() == 2 ? std::atan2(normals[0].cross(normals[1]).norm(), normals[0].dot(normals[1]))
                               : 0;
}

} // namespace

// A hundredth of what is asked for; positions are stored to 6e-8 of their size.
TEST(Stitching, GivesBackAnUnchangedMesh)
{
    for (const bool closed : {true, false}) {
        const PartedBar parted(61, 4, 2.0F, 0.3F, closed);
        const Pose pose = bent(shaken(parted.bar.positions, 0.004, 1), 2.0, 1.5);
        const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
        EXPECT_LT(largestDistance(stitched(stitching, cutPose(parted.parts, pose)), pose), 2e-6) << closed;
    }
}

TEST(Stitching, TakesChildrenFromAnywhere)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    std::vector<Pose> poses = variousPoses(parted, 0.1);
    const Pose expected = stitched(stitching, poses);
    poses[1] = movedBy(poses[1], someMotion);
    poses[3] = movedBy(poses[3], otherMotion);
    poses[4] = movedBy(poses[4], otherMotion);
    EXPECT_LT(largestDistance(stitched(stitching, poses), expected), 5e-6);
}

TEST(Stitching, GoesWhereItsRootGoes)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    std::vector<Pose> poses = variousPoses(parted, 0.1);
    const Pose before = stitched(stitching, poses);
    poses[0] = movedBy(poses[0], someMotion);
    EXPECT_LT(largestDistance(stitched(stitching, poses), movedBy(before, someMotion)), 5e-6);
}

TEST(Stitching, KeepsTheShapeOfPartsAwayFromTheirEnds)
{
    const PartedBar parted;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const std::vector<Pose> poses = variousPoses(parted, 0.1);
    const Pose out = stitched(stitching, poses);
    const std::vector<Pose> back = cutPose(parted.parts, out);
    for (std::size_t p = 0; p < back.size(); ++p) {
        // The middle third of the vertices along the bar lies outside all overlaps.
        const std::size_t from = back[p].size() / 3;
        const Pose given(poses[p].begin() + from, poses[p].end() - from);
        const Pose got(back[p].begin() + from, back[p].end() - from);
        EXPECT_LT(largestDistance(movedBy(given, rigidProcrustes(given, got)), got), 2e-3) << p;
    }
}

TEST(Stitching, LeavesNoCrease)
{
    const PartedBar parted;
    const Topology& topology = *parted.bar.topology;
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions);
    const std::vector<Pose> poses = variousPoses(parted, 0.15);
    Pose out(topology.vertexCount());
    const Stitching::Seams seams = stitching.stitch(viewed(poses), out);
    ASSERT_TRUE(seams.curves[0].empty());
    for (std::size_t p = 1; p < seams.curves.size(); ++p) {
        const std::vector<VertexIndex>& seam = seams.curves[p];
        ASSERT_GE(seam.size(), 16U);
        const auto instance = [&](std::size_t part, VertexIndex v) {
            const std::vector<VertexIndex>& of = parted.parts.parts[part].vertices;
            return poses[part][static_cast<std::size_t>(std::ranges::lower_bound(of, v) - of.begin())];
        };
        Pose asParent(topology.vertexCount());
        Pose asChild(topology.vertexCount());
        for (const VertexIndex v : parted.parts.parts[p].overlap) {
            asParent[v.value] = instance(static_cast<std::size_t>(parted.parts.parts[p].parent), v);
            asChild[v.value] = instance(p, v);
        }
        for (std::size_t i = 0; i < seam.size(); ++i) {
            const VertexIndex a = seam[i];
            const VertexIndex b = seam[(i + 1) % seam.size()];
            const double sharpest =
                std::max({creaseAt(topology, asParent, a, b), creaseAt(topology, asChild, a, b),
                          creaseAt(topology, parted.bar.positions, a, b)});
            EXPECT_LT(creaseAt(topology, out, a, b), sharpest + 0.01) << p << " " << i;
        }
    }
}
