// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/pliablesurface.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A bar, some of whose triangles are held where they are in another pose of it.
class Pliable : public testing::Test
{
protected:
    std::vector<PliableSurface::Anchor> held(const PliableSurface& surface, const std::vector<Vec3f>& pose,
                                             std::size_t step) const
    {
        std::vector<PliableSurface::Anchor> anchors;
        for (std::size_t i = 0; i < surface.size(); i += step)
            anchors.push_back(
                {i, middleOf(corners(surface, i), pose), normalOf(corners(surface, i), pose), 1});
        return anchors;
    }
    const Triangle& corners(const PliableSurface& surface, std::size_t place) const
    {
        return m_bar.topology->triangles()[surface.triangle(place).value];
    }
    /// Mean distance of the places from where they are in a pose, metres.
    double missed(const PliableSurface& surface, const std::vector<Vec3f>& pose) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < surface.size(); ++i)
            sum += (surface.position(i) - middleOf(corners(surface, i), pose)).norm();
        return sum / static_cast<double>(surface.size());
    }

    Bar m_bar = makeBar(41, 4, 2, 0.3F);
    PosedMesh m_mesh{m_bar.topology, m_bar.positions};
    PosedSurface m_surface{m_mesh};
};

} // namespace

TEST_F(Pliable, BeginsWithThePlacesThatAreWanted)
{
    const PliableSurface surface(m_surface, {TriangleIndex(7), TriangleIndex(3)});
    EXPECT_EQ(surface.triangle(0), TriangleIndex(7));
    EXPECT_EQ(surface.triangle(1), TriangleIndex(3));
    std::vector<bool> seen(m_bar.topology->triangles().size());
    for (std::size_t i = 0; i < surface.size(); ++i) {
        EXPECT_FALSE(seen[surface.triangle(i).value]);
        seen[surface.triangle(i).value] = true;
    }
    EXPECT_EQ(surface.size(), 500U);
    EXPECT_LT(missed(surface, m_bar.positions), 1e-12);
}

TEST_F(Pliable, MovesRigidlyWithWhatIsHeldRigidly)
{
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.3, Vec3d(1, 2, -1).normalized()).toRotationMatrix();
    const std::vector<Vec3f> pose =
        moved(m_bar.positions, [&](const Vec3d& p) -> Vec3d { return turn * p + Vec3d(3, -1, 2); });
    PliableSurface surface(m_surface, {});
    surface.settle(held(surface, pose, 5), 100);
    EXPECT_LT(missed(surface, pose), 1e-4);
    for (std::size_t i = 0; i < surface.size(); ++i) {
        EXPECT_LT((surface.turn(i) - turn).norm(), 2e-3);
        EXPECT_LT((surface.normal(i) - normalOf(corners(surface, i), pose)).norm(), 2e-3);
    }
}

TEST_F(Pliable, BendsBetweenWhatIsHeldAtItsEnds)
{
    const std::vector<Vec3f> pose = bent(m_bar.positions, 1, 70 * degree);
    PliableSurface surface(m_surface, {});
    std::vector<PliableSurface::Anchor> anchors = held(surface, pose, 1);
    std::erase_if(anchors, [&](const PliableSurface::Anchor& anchor) {
        return std::abs(middleOf(corners(surface, anchor.place), m_bar.positions).x() - 1) < 0.6;
    });
    ASSERT_LT(anchors.size(), surface.size() / 2);
    const double before = missed(surface, pose);
    surface.settle(anchors, 200);
    EXPECT_LT(missed(surface, pose), before / 20);
}

TEST_F(Pliable, GrowsWithALargerBody)
{
    const std::vector<Vec3f> pose = moved(m_bar.positions, [](const Vec3d& p) -> Vec3d { return 1.6 * p; });
    PliableSurface grown(m_surface, {});
    grown.settle(held(grown, pose, 7), 200);
    PliableSurface scaled(m_surface, {});
    scaled.scale(1.6);
    EXPECT_LT(missed(scaled, pose), 1e-6);
    scaled.settle(held(scaled, pose, 7), 20);
    EXPECT_LT(missed(scaled, pose), 1e-4);
    EXPECT_LT(missed(grown, pose), 0.01);
}

TEST_F(Pliable, CarriesWhatIsBesidePlaces)
{
    const std::vector<Vec3f> pose = bent(m_bar.positions, 1, 50 * degree);
    PliableSurface surface(m_surface, {});
    surface.scale(2);
    std::vector<Vec3f> twice = moved(pose, [](const Vec3d& p) -> Vec3d { return 2 * p; });
    surface.settle(held(surface, twice, 1), 100);
    const std::vector<std::optional<std::size_t>> nearest = surface.nearestPlaces(m_surface);
    double worst = 0;
    for (std::size_t t = 0; t < nearest.size(); ++t) {
        ASSERT_TRUE(nearest[t]);
        const Triangle& triangle = m_bar.topology->triangles()[t];
        worst = std::max(worst, (surface.moved(*nearest[t], middleOf(triangle, m_bar.positions)) -
                                 middleOf(triangle, twice))
                                    .norm());
    }
    EXPECT_LT(worst, 0.05); // the bar is 4 m long now
}

TEST_F(Pliable, LeavesWhatNothingHolds)
{
    PliableSurface surface(m_surface, {});
    surface.settle({}, 5);
    EXPECT_LT(missed(surface, m_bar.positions), 1e-5);
}

TEST_F(Pliable, NearnessFallsToAHalf)
{
    const PliableSurface surface(m_surface, {});
    const Vec3d there = surface.position(3);
    EXPECT_DOUBLE_EQ(surface.nearness(3, there, 0.2), 1);
    EXPECT_DOUBLE_EQ(surface.nearness(3, there + Vec3d(0, 0.2, 0), 0.2), 0.5);
    EXPECT_LT(surface.nearness(3, there + Vec3d(0, 2, 0), 0.2), 0.01);
}

TEST(Spread, OfPlaces)
{
    const std::vector<Vec3d> places{{1, 0, 0}, {3, 0, 0}, {2, 1, 0}, {2, -1, 0}};
    EXPECT_LT((spreadOf(places).middle - Vec3d(2, 0, 0)).norm(), 1e-12);
    EXPECT_NEAR(spreadOf(places).size, 1, 1e-12);
    EXPECT_EQ(spreadOf({}).size, 0);
}
