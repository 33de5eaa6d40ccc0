// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/random.h"
#include "model/parametric/weightspace.h"

#include <cmath>
#include <gtest/gtest.h>

namespace quadrille {
namespace {

WeightSpace square()
{
    return {std::vector<SpacePoint>{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, 2};
}

double sumOf(const NodeWeights& weights)
{
    double sum = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(weights.count); ++n) {
        EXPECT_GE(weights.weights[n], 0);
        sum += weights.weights[n];
    }
    return sum;
}

void expectRefused(const std::vector<SpacePoint>& takes, int dimension, const std::string& reason)
{
    try {
        const WeightSpace space(takes, dimension);
        ADD_FAILURE() << "taken: " << reason;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
}

} // namespace

TEST(WeightSpace, OfOneTakeHasNoParameter)
{
    const WeightSpace space(std::vector<SpacePoint>{{3, 0, 0}}, 0);
    const NodeWeights weights = space.at({7, 0, 0});
    EXPECT_EQ(weights.count, 1);
    EXPECT_EQ(weights.weights[0], 1);
    EXPECT_TRUE(space.edges().empty());
}

TEST(WeightSpace, OrdersTakesAlongOneParameter)
{
    const WeightSpace space(std::vector<SpacePoint>{{3, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 1);
    EXPECT_EQ(space.simplices().size(), 2U);
    const std::vector<double> shares = space.shares(space.at({1.25, 0, 0}));
    EXPECT_NEAR(shares[0], 0, 1e-12);
    EXPECT_NEAR(shares[1], 0.75, 1e-12);
    EXPECT_NEAR(shares[2], 0.25, 1e-12);
}

TEST(WeightSpace, CutsASquareInTwoTrianglesAlwaysAlike)
{
    const WeightSpace space = square();
    EXPECT_EQ(space.simplices().size(), 2U);
    EXPECT_EQ(space.edges().size(), 5U);
    EXPECT_EQ(space.edges(), square().edges());
}

TEST(WeightSpace, BlendsToThePlaceThatIsAskedFor)
{
    Random random(3);
    const std::vector<SpacePoint> cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    WeightSpace space(cube, 3);
    double volume = 0;
    for (const WeightSpace::Simplex& simplex : space.simplices())
        volume += 1 / std::abs(simplex.inverse.determinant()) / 6;
    EXPECT_NEAR(volume, 1, 1e-9) << "tetrahedra overlap or leave holes";
    for (int divisions = 0; divisions < 5; ++divisions) {
        for (int i = 0; i < 100; ++i) {
            const SpacePoint wanted{random.unit(), random.unit(), random.unit()};
            const NodeWeights weights = space.at(wanted);
            EXPECT_NEAR(sumOf(weights), 1, 1e-12);
            const SpacePoint found = space.placeOf(weights);
            for (std::size_t d = 0; d < 3; ++d)
                EXPECT_NEAR(found[d], wanted[d], 1e-9);
        }
        space.bisect(space.edges()[static_cast<std::size_t>(divisions) % space.edges().size()]);
    }
}

TEST(WeightSpace, GivesTakesTheSameSharesHoweverFinelyItIsDivided)
{
    WeightSpace divided = square();
    for (int i = 0; i < 6; ++i)
        divided.bisect(divided.edges()[static_cast<std::size_t>(i * 3) % divided.edges().size()]);
    EXPECT_EQ(divided.nodes().size(), 10U);
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        const SpacePoint place{2 * random.unit(), random.unit(), 0};
        const std::vector<double> coarse = square().shares(square().at(place));
        const std::vector<double> fine = divided.shares(divided.at(place));
        for (std::size_t t = 0; t < coarse.size(); ++t)
            EXPECT_NEAR(coarse[t], fine[t], 1e-9);
    }
}

TEST(WeightSpace, GoesToTheNearestPlaceWithin)
{
    // Against the best of many places within.
    const WeightSpace triangle(std::vector<SpacePoint>{{0, 0, 0}, {1, 0, 0}, {0.2, 0.8, 0}}, 2);
    Random random(5);
    for (int i = 0; i < 50; ++i) {
        const SpacePoint wanted{4 * random.unit() - 2, 4 * random.unit() - 2, 0};
        const SpacePoint found = triangle.placeOf(triangle.at(wanted));
        const double distance = std::hypot(found[0] - wanted[0], found[1] - wanted[1]);
        constexpr int steps = 100;
        for (int a = 0; a <= steps; ++a) {
            for (int b = 0; a + b <= steps; ++b) {
                const double x = (a + 0.2 * b) / steps;
                const double y = 0.8 * b / steps;
                EXPECT_LE(distance, std::hypot(x - wanted[0], y - wanted[1]) + 1e-9);
            }
        }
    }
}

TEST(WeightSpace, SaysWhichTakesCannotBePlaced)
{
    expectRefused({{1, 0, 0}, {2, 0, 0}, {1, 0, 0}}, 1, "Takes 1 and 3");
    expectRefused({{1, 0, 0}, {2, 1, 0}}, 2, "at least 3 takes");
    expectRefused({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, 2, "on one line");
    expectRefused(std::vector<SpacePoint>(9), 1, "at most 8");
    expectRefused({{0, 0, 0}, {1, 0, 0}}, 4, "one to three");
}

} // namespace quadrille
