// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/stretchtracker.h"
#include "tests/model/transfer/transferfixture.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A bar along x, and a pair in the middle of each of its sides, far from edges.
class StretchTrackers : public testing::Test
{
protected:
    StretchTrackers() : m_bar(makeBar(21, 5, 1.0F, 0.2F))
    {
        std::size_t triangle = 0;
        for (const Triangle& t : m_bar.topology->triangles()) {
            const Vec3d middle = middleOf(t, m_bar.positions);
            if (std::abs(middle.x() - 0.5) < 0.03 &&
                std::min(std::abs(middle.y()), std::abs(middle.z())) < 0.02)
                m_pairs.push_back({TriangleIndex(triangle), TriangleIndex(triangle)});
            ++triangle;
        }
    }

    std::vector<Eigen::Matrix3d> after(const std::vector<Vec3f>& pose) const
    {
        const PosedMesh rest{m_bar.topology, m_bar.positions};
        return StretchTracker(patchesAbout(PosedSurface(rest), m_pairs, PatchReach::Whole), m_bar.positions)
            .next(pose);
    }
    std::vector<Vec3f> stretched() const
    {
        return moved(m_bar.positions,
                     [](const Vec3d& p) -> Vec3d { return p.cwiseProduct(Vec3d(1.2, 0.9, 0.8)); });
    }
    /// Faces up or down, not to the side.
    bool facesUp(std::size_t pair) const
    {
        const Triangle& t = m_bar.topology->triangles()[m_pairs[pair].onTemplate.value];
        return std::abs(middleOf(t, m_bar.positions).z()) > 0.09;
    }

    Bar m_bar;
    std::vector<TrianglePair> m_pairs;
};

} // namespace

TEST_F(StretchTrackers, SayHowTheSurfaceIsStretchedInItsPlane)
{
    ASSERT_GE(m_pairs.size(), 4U);
    const auto found = after(stretched());
    for (std::size_t m = 0; m < m_pairs.size(); ++m) {
        const Vec3d expected = facesUp(m) ? Vec3d(1.2, 0.9, 1) : Vec3d(1.2, 1, 0.8);
        EXPECT_LT((found[m] - Eigen::Matrix3d(expected.asDiagonal())).norm(), 1e-5) << m;
    }
}

TEST_F(StretchTrackers, AreThoseOfTheReferencePoseHoweverTheBodyIsTurned)
{
    const auto turn = Eigen::AngleAxisd(2, Vec3d(1, -2, 0.5).normalized());
    const auto found =
        after(moved(stretched(), [&turn](const Vec3d& p) -> Vec3d { return turn * p + Vec3d(3, 4, 5); }));
    const auto unturned = after(stretched());
    for (std::size_t m = 0; m < m_pairs.size(); ++m)
        EXPECT_LT((found[m] - unturned[m]).norm(), 1e-5) << m;
}

TEST_F(StretchTrackers, AreMeansOverWhatIsNear)
{
    // One corner of one triangle is pulled out far.
    std::vector<Vec3f> pose = m_bar.positions;
    pose[m_bar.topology->triangles()[m_pairs[0].onTemplate.value][0].value].x() += 0.04F;
    const auto found = after(pose);
    EXPECT_GT((found[0] - Eigen::Matrix3d::Identity()).norm(), 0.01);
    EXPECT_LT((found[0] - Eigen::Matrix3d::Identity()).norm(), 0.3);
    // However far, no triangle counts for more than what skin gives.
    pose = moved(m_bar.positions, [](const Vec3d& p) -> Vec3d { return p.cwiseProduct(Vec3d(50, 1, 1)); });
    for (const Eigen::Matrix3d& stretch : after(pose))
        EXPECT_LT(stretch.eigenvalues().cwiseAbs().maxCoeff(), 4.001);
}

TEST_F(StretchTrackers, KnowNothingWhereThereIsNoArea)
{
    const std::vector<Vec3f> line = moved(m_bar.positions, [](const Vec3d& p) -> Vec3d {
        return {p.x(), 0, 0};
    });
    for (const Eigen::Matrix3d& stretch : after(line))
        EXPECT_EQ(stretch, Eigen::Matrix3d::Identity());
}
