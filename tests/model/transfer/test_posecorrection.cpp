// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/posecorrection.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A bar whose upper half the template holds bent and the target straight.
class PoseCorrection : public testing::Test
{
protected:
    PoseCorrection()
    {
        for (const TriangleIndex t : everyTriangle(*m_bar.topology, 7))
            m_pairs.push_back({t, t});
    }

    std::vector<Eigen::Quaterniond> corrections(const std::vector<Vec3f>& reference,
                                                const std::vector<Vec3f>& target) const
    {
        const PosedMesh posed{m_bar.topology, reference};
        return poseCorrections(PosedSurface(posed), {m_bar.topology, target}, m_pairs);
    }

    Bar m_bar = makeBar(41, 4, 2, 0.3F);
    std::vector<TrianglePair> m_pairs;
};

} // namespace

TEST_F(PoseCorrection, TurnsLimbsAsTheTemplateHoldsThem)
{
    constexpr double bend = 60 * degree;
    MarkTracker tracker(singleTriangles(trianglesOf(*m_bar.topology, everyTriangle(*m_bar.topology, 7))),
                        m_bar.positions);
    const std::vector<Vec3f> reference = bent(m_bar.positions, 1, bend);
    const std::vector<Eigen::Quaterniond> expected = tracker.next(reference).rotations;
    const std::vector<Eigen::Quaterniond> found = corrections(reference, m_bar.positions);
    double error = 0;
    double before = 0;
    for (std::size_t m = 0; m < m_pairs.size(); ++m) {
        error += found[m].angularDistance(expected[m]) / static_cast<double>(m_pairs.size());
        before +=
            expected[m].angularDistance(Eigen::Quaterniond::Identity()) / static_cast<double>(m_pairs.size());
        EXPECT_GE(found[m].w(), 0);
        EXPECT_NEAR(found[m].norm(), 1, 1e-9);
    }
    EXPECT_LT(error, before / 5);
    EXPECT_LT(error, 5 * degree);
}

TEST_F(PoseCorrection, LeavesDifferencesOfShapeAlone)
{
    const std::vector<Vec3f> thick = moved(m_bar.positions, [](const Vec3d& p) -> Vec3d {
        return {1.3 * p.x() + 2, 0.8 * p.y(), (1 + 0.1 * std::sin(p.x())) * p.z()};
    });
    for (const Eigen::Quaterniond& q : corrections(m_bar.positions, thick))
        EXPECT_LT(q.angularDistance(Eigen::Quaterniond::Identity()), 1e-9);
}

TEST_F(PoseCorrection, DoesNotTurnMirrorImages)
{
    const std::vector<Vec3f> mirrored =
        moved(bent(m_bar.positions, 1, 40 * degree), [](const Vec3d& p) -> Vec3d {
            return {p.x(), -p.y(), p.z()};
        });
    for (const Eigen::Quaterniond& q : corrections(bent(m_bar.positions, 1, 40 * degree), mirrored))
        EXPECT_LT(q.angularDistance(Eigen::Quaterniond::Identity()), 1e-9);
}

TEST_F(PoseCorrection, NeedsFourPairs)
{
    m_pairs.resize(3);
    const auto few = corrections(bent(m_bar.positions, 1, 1), m_bar.positions);
    ASSERT_EQ(few.size(), 3U);
    for (const Eigen::Quaterniond& q : few)
        EXPECT_LT(q.angularDistance(Eigen::Quaterniond::Identity()), 1e-9);
}

/// Triangles without an area, and marks at one place, hold nothing up.
TEST_F(PoseCorrection, StaysFiniteWhereMarksMeanNothing)
{
    std::vector<Vec3f> point(m_bar.positions.size(), Vec3f(1, 2, 3));
    for (const Eigen::Quaterniond& q : corrections(m_bar.positions, point))
        EXPECT_NEAR(q.norm(), 1, 1e-9);
}
