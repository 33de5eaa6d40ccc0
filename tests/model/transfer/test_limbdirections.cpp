// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/limbdirections.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

class LimbDirectionsOfBodies : public testing::Test
{
protected:
    void SetUp() override
    {
        const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/mh_male";
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << "no real bodies";
        m_average = firstPose(folder / "rest_m_avg.obj");
        m_heavy = firstPose(folder / "rest_m_heavy.obj");
    }
    static LimbDirections of(const PosedMesh& body)
    {
        return {BodyPlaces(body, UpAxis::Y, ErrorCode::TransferNoLimbsOfTemplate), *body.topology};
    }

    PosedMesh m_average;
    PosedMesh m_heavy;
};

} // namespace

TEST_F(LimbDirectionsOfBodies, PointFromTheirEndsToTheBody)
{
    const auto directions = of(m_average).of(m_average.positions);
    for (std::size_t limb = 0; limb < LimbDirections::limbs; ++limb)
        EXPECT_NEAR(directions[limb].norm(), 1, 1e-9) << limb;
    for (const std::size_t shin : {2U, 3U})
        EXPECT_GT(directions[shin].y(), 0.9) << shin;
    for (const std::size_t foot : {4U, 5U}) {
        EXPECT_LT(directions[foot].z(), -0.7) << foot; // toes point along z
        EXPECT_LT(std::abs(directions[foot].y()), 0.6) << foot;
    }
    // In an A-pose arms come from the sides: the left one, which is the first, along −x.
    EXPECT_LT(directions[0].x(), -0.3);
    EXPECT_GT(directions[1].x(), 0.3);
}

TEST_F(LimbDirectionsOfBodies, AreAlikeOnBodiesThatStandAlike)
{
    const LimbErrors errors =
        limbErrors(of(m_heavy).of(m_heavy.positions), of(m_average).of(m_average.positions));
    EXPECT_LT(errors.limbs, 5 * degree);
    EXPECT_LT(errors.feet, 5 * degree);
}

TEST_F(LimbDirectionsOfBodies, TellWhatIsTurned)
{
    const LimbDirections limbs = of(m_average);
    const auto before = limbs.of(m_average.positions);
    // All of it.
    const Eigen::AngleAxisd turn(0.4, Vec3d::UnitX());
    const auto leaning =
        limbs.of(moved(m_average.positions, [&](const Vec3d& p) -> Vec3d { return turn * p; }));
    for (std::size_t limb = 0; limb < LimbDirections::limbs; ++limb)
        EXPECT_LT((leaning[limb] - turn * before[limb]).norm(), 1e-5) << limb;
    // Toes that point up by half a radian, and nothing else.
    const Eigen::AngleAxisd lift(-0.5, Vec3d::UnitX());
    const auto lifted = limbs.of(
        moved(m_average.positions, [&](const Vec3d& p) -> Vec3d { return p.y() < 0.12 ? lift * p : p; }));
    const LimbErrors errors = limbErrors(lifted, before);
    EXPECT_NEAR(errors.feet, 0.5, 0.1);
    EXPECT_LT(errors.limbs, 0.05);
}

TEST(LimbErrors, AreMeansOverWhatBothHave)
{
    LimbDirections::Directions a;
    a.fill(Vec3d::UnitX());
    LimbDirections::Directions b = a;
    b[0] = Vec3d::UnitY();
    b[1] = Vec3d::Zero();
    b[5] = -Vec3d::UnitX();
    const LimbErrors errors = limbErrors(a, b);
    EXPECT_NEAR(errors.limbs, std::numbers::pi / 2 / 3, 1e-12);
    EXPECT_NEAR(errors.feet, std::numbers::pi / 2, 1e-12);
    b.fill(Vec3d::Zero());
    EXPECT_TRUE(std::isnan(limbErrors(a, b).limbs));
}
