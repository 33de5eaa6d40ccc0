// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/variation/creases.h"
#include "tests/model/variation/partedposes.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

// Turned by five degrees about its overlap, a child keeps its turn where nothing of its parent is left; laid
// rigidly it would lose it. It may still be moved.
TEST(ChildLaying, KeepsTurnsOfChildrenThatAreOnlyMoved)
{
    const PartedBar parted;
    std::vector<Pose> poses = cutPose(parted.parts, parted.bar.positions);
    const std::size_t child = poses.size() - 1;
    const RigidMotion turn{Eigen::Quaterniond(Eigen::AngleAxisd(0.087, Vec3d::UnitX())), Vec3d(0.3, 0, -2)};
    const Pose before = poses[child];
    poses[child] = movedBy(before, turn);
    const auto turnedBy = [&](ChildLaying laying) {
        const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions, {}, laying);
        const Pose got = cutPose(parted.parts, stitched(stitching, poses))[child];
        std::vector<double> weights;
        const BodyPart& part = parted.parts.parts[child];
        for (const VertexIndex v : part.vertices)
            weights.push_back(std::ranges::binary_search(part.overlap, v) ? 0 : 1);
        return Eigen::AngleAxisd(rigidProcrustes(before, got, weights).rotation).angle();
    };
    EXPECT_NEAR(turnedBy(ChildLaying::Moved), 0.087, 0.02);
    EXPECT_NEAR(turnedBy(ChildLaying::Rigidly), 0, 0.001);
}

/// \param more  than the instances have, radians.
void expectNoCrease(ChildLaying laying, double amount, double more)
{
    const PartedBar parted;
    const Topology& topology = *parted.bar.topology;
    const EdgeNormals normals(topology);
    const Stitching stitching(parted.bar.topology, parted.parts, parted.bar.positions, {}, laying);
    const std::vector<Pose> poses = variousPoses(parted, amount);
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
                std::max({normals.creaseAt(asParent, a, b), normals.creaseAt(asChild, a, b),
                          normals.creaseAt(parted.bar.positions, a, b)});
            EXPECT_LT(normals.creaseAt(out, a, b), sharpest + more) << p << " " << i;
        }
    }
}

TEST(ChildLaying, LeavesNoCrease)
{
    expectNoCrease(ChildLaying::Rigidly, 0.15, 0.01);
}

TEST(ChildLaying, LeavesNoCreaseWhereChildrenAreTurned)
{
    // Instances are turned by up to three degrees, of which each edge across the overlap takes its share.
    expectNoCrease(ChildLaying::Moved, 0.03, 0.02);
}

} // namespace
