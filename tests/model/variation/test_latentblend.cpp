// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/variation/latentblend.h"
#include "tests/model/codeof.h"

#include <limits>
#include <vector>

using namespace quadrille;
using namespace quadrille::test;

namespace {

const std::vector<double> threeWeights{0, 0.5, 1};

} // namespace

TEST(LatentBlend, takesTheTwoLearnedBlendsAroundAWeight)
{
    const BlendNeighbours quarter = blendNeighbours(threeWeights, 0.25);
    EXPECT_EQ(quarter, (BlendNeighbours{0, 1, 0.5}));
    const BlendNeighbours late = blendNeighbours(threeWeights, 0.9);
    EXPECT_EQ(late.first, 1u);
    EXPECT_EQ(late.second, 2u);
    EXPECT_NEAR(late.share, 0.2, 1e-15);
}

TEST(LatentBlend, isALearnedBlendAtItsWeight)
{
    EXPECT_EQ(blendNeighbours(threeWeights, 0), (BlendNeighbours{0, 1, 1}));
    EXPECT_EQ(blendNeighbours(threeWeights, 0.5), (BlendNeighbours{1, 2, 1}));
    EXPECT_EQ(blendNeighbours(threeWeights, 1), (BlendNeighbours{1, 2, 0}));
    EXPECT_EQ(blendNeighbours(std::vector<double>{0, 1}, 1), (BlendNeighbours{0, 1, 0}));
}

TEST(LatentBlend, refusesWeightsThatItCannotServe)
{
    for (const double wanted : {-0.01, 1.01, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(codeOf([&] { blendNeighbours(threeWeights, wanted); }), ErrorCode::BadArgument) << wanted;
    for (const std::vector<double>& learned :
         std::vector<std::vector<double>>{{}, {0}, {0, 0.5}, {0.5, 1}, {0, 0.5, 0.5, 1}, {0, 0.7, 0.3, 1}})
        EXPECT_EQ(codeOf([&] { blendNeighbours(learned, 0.5); }), ErrorCode::BadArgument) << learned.size();
}

// w* = 0.3 between 0 and 0.5: 0.4 of the first and 0.6 of the second.
TEST(LatentBlend, interpolatesTrajectories)
{
    const RowMatrix a = normals(5, 3, 1);
    const RowMatrix b = normals(5, 3, 2);
    const BlendNeighbours n = blendNeighbours(threeWeights, 0.3);
    const std::array shares{LatentShare{a, n.share}, LatentShare{b, 1 - n.share}};
    EXPECT_LT((latentBlend(shares) - (0.4 * a + 0.6 * b)).norm(), 1e-14);
}

TEST(LatentBlend, isBilinearBetweenFour)
{
    const std::array<RowMatrix, 4> corners{normals(4, 2, 1), normals(4, 2, 2), normals(4, 2, 3),
                                           normals(4, 2, 4)};
    const BlendCell cell = blendCell(threeWeights, std::vector<double>{0, 1}, 0.6, 0.75);
    EXPECT_EQ(cell.across.first, 1u);
    EXPECT_EQ(cell.along.first, 0u);
    // 0.8 and 0.2 across, 0.25 and 0.75 along.
    const std::array<double, 4> expected{0.2, 0.05, 0.6, 0.15};
    RowMatrix sum = RowMatrix::Zero(4, 2);
    std::vector<LatentShare> shares;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(cell.shares()[i], expected[i], 1e-15);
        sum += expected[i] * corners[i];
        shares.push_back({corners[i], cell.shares()[i]});
    }
    EXPECT_LT((latentBlend(shares) - sum).norm(), 1e-14);
    EXPECT_EQ(codeOf([] { blendCell(threeWeights, threeWeights, 0.5, 1.5); }), ErrorCode::BadArgument);
}
