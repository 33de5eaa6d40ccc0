// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/core/error.h"
#include "model/sequence/io/registry.h"
#include "model/transfer/pairproposal.h"
#include "tests/model/codeof.h"
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>
#include <set>

using namespace quadrille;
using namespace quadrille::test;

namespace {

PosedMesh firstPose(const std::filesystem::path& file)
{
    const MeshSequence sequence = openSequences(file).sequences.front();
    const Frame frame = sequence.frame(FrameIndex(0));
    return {sequence.topology, {frame.positions().begin(), frame.positions().end()}};
}

Vec3d middleOf(const PosedMesh& mesh, TriangleIndex triangle)
{
    const Triangle& t = mesh.topology->triangles()[triangle.value];
    return (mesh.positions[t[0].value] + mesh.positions[t[1].value] + mesh.positions[t[2].value])
               .cast<double>() /
           3;
}

/// Two bodies whose triangles correspond one by one.
class PairProposal : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/mh_male";
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << "no real bodies";
        m_average = firstPose(folder / "rest_m_avg.obj");
        m_heavy = firstPose(folder / "rest_m_heavy.obj");
    }

    /// How far proposed triangles are from the true ones, heights of the body.
    double meanError(const std::vector<ProposedPair>& pairs) const
    {
        double sum = 0;
        for (const ProposedPair& proposed : pairs)
            sum += (middleOf(m_heavy, proposed.pair.onTarget) - middleOf(m_heavy, proposed.pair.onTemplate))
                       .norm();
        return sum / static_cast<double>(pairs.size()) / boundsOf(m_heavy.positions).size().y();
    }

    PosedMesh m_average;
    PosedMesh m_heavy;
};

} // namespace

TEST_F(PairProposal, FindsTheTrianglesOfAnotherBody)
{
    const std::vector<ProposedPair> pairs = proposePairs(m_average, m_heavy, UpAxis::Y);
    EXPECT_GT(pairs.size(), usualPairs * 9 / 10);
    EXPECT_LT(meanError(pairs), 0.005);
    std::set<TriangleIndex> onTarget;
    for (const ProposedPair& proposed : pairs) {
        EXPECT_TRUE(onTarget.insert(proposed.pair.onTarget).second);
        EXPECT_GT(proposed.quality, 0.3);
        EXPECT_LE(proposed.quality, 1);
    }
}

TEST_F(PairProposal, NeitherSizeNorHeadingMatters)
{
    for (Vec3f& p : m_heavy.positions)
        p = 30 * (Eigen::AngleAxisf(2, Vec3f::UnitY()) * p) + Vec3f(5, 1, -4);
    EXPECT_LT(meanError(proposePairs(m_average, m_heavy, UpAxis::Y, 30)), 0.005);
}

TEST_F(PairProposal, LeftStaysLeft)
{
    for (const ProposedPair& proposed : proposePairs(m_average, m_heavy, UpAxis::Y)) {
        const double from = middleOf(m_average, proposed.pair.onTemplate).x();
        const double onto = middleOf(m_heavy, proposed.pair.onTarget).x();
        EXPECT_TRUE(std::abs(from) <= 0.1 || from * onto > 0) << from << " and " << onto;
    }
}

TEST(PairProposalOfOtherThings, IsRefused)
{
    const Bar bar = makeBar(9, 3, 1.0F, 0.3F);
    const PosedMesh mesh{bar.topology, bar.positions};
    EXPECT_EQ(codeOf([&] { proposePairs(mesh, mesh, UpAxis::Y); }), ErrorCode::TransferNoLimbsOfTemplate);
}
