// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/subject.h"
#include "tests/model/codeof.h"

#include <gmock/gmock.h>
#include <limits>

namespace quadrille {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<std::string> names{"walk", "jog", "stroll", "run"};

/// Takes 0 … 3, then what is learned between them.
Movement movementOf(std::vector<MovementBlend> blends)
{
    checkBlends(blends, names.size());
    Movement movement;
    movement.alignment.reports.resize(names.size());
    movement.preblends = preblendsOf(blends);
    movement.blends = std::move(blends);
    return movement;
}

/// Learned at 0, 1/2, 1 along and at 0, 1/4, 1 across: takes 4 … 8 lie, row by row, at (1/2, 0), (0, 1/4),
/// (1/2, 1/4), (1, 1/4) and (1/2, 1).
MovementBlend square()
{
    return {.from = 0, .to = 1, .weights = {0.5}, .across = AcrossBlend{2, 3, {0.25}}};
}

VariationSubject between(double weight, double across)
{
    return {.take = 0, .to = 1, .weight = weight, .across = SubjectAcross{2, 3, across}};
}

std::vector<std::size_t> takesOf(const std::vector<BlendShare>& shares)
{
    std::vector<std::size_t> takes;
    for (const BlendShare& share : shares)
        takes.push_back(share.take);
    return takes;
}

} // namespace

TEST(Blends, AreLearnedAtEachWeightOfAPair)
{
    const std::vector<MovementBlend> blends{{.from = 1, .to = 0, .weights = {0.25, 0.5}, .across = {}},
                                            {.from = 2, .to = 3, .weights = {}, .across = {}}};
    const std::vector<Preblend> points = preblendsOf(blends);
    EXPECT_THAT(points, ElementsAre(Preblend{0, 0.25, 0}, Preblend{0, 0.5, 0}));
    EXPECT_EQ(preblendName(blends[0], points[0], names), "jog–walk 0.25");
    EXPECT_THAT(sharesOf(blends[0], points[0]), ElementsAre(BlendShare{1, 0.75}, BlendShare{0, 0.25}));
}

TEST(Blends, AreLearnedAtAllNodesOfAGridButItsCorners)
{
    const std::vector<MovementBlend> blends{square()};
    const std::vector<Preblend> points = preblendsOf(blends);
    EXPECT_THAT(points, ElementsAre(Preblend{0, 0.5, 0}, Preblend{0, 0, 0.25}, Preblend{0, 0.5, 0.25},
                                    Preblend{0, 1, 0.25}, Preblend{0, 0.5, 1}));
    std::vector<std::string> called;
    for (const Preblend& point : points)
        called.push_back(preblendName(blends.front(), point, names));
    EXPECT_THAT(called, ElementsAre("walk–jog 0.5", "walk–stroll 0.25", "walk–jog × stroll–run 0.5 0.25",
                                    "jog–run 0.25", "stroll–run 0.5"));
    EXPECT_THAT(sharesOf(blends.front(), points[2]), ElementsAre(BlendShare{0, 0.375}, BlendShare{1, 0.375},
                                                                 BlendShare{2, 0.125}, BlendShare{3, 0.125}));
    EXPECT_THAT(sharesOf(blends.front(), points[3]), ElementsAre(BlendShare{1, 0.75}, BlendShare{3, 0.25}));
}

TEST(Blends, RefuseWhatIsNoBlend)
{
    std::vector<MovementBlend> bad(6, square());
    bad[0].across->to = 0;
    bad[1].to = 0;
    bad[2].across->from = 4;
    bad[3].weights = {0.5, 0.5};
    bad[4].across->weights = {1};
    bad[5].across->weights = {std::numeric_limits<double>::quiet_NaN()};
    for (std::size_t b = 0; b < bad.size(); ++b)
        EXPECT_EQ(test::codeOf([&] { checkBlends(std::span(&bad[b], 1), names.size()); }),
                  ErrorCode::BadArgument)
            << b;
}

TEST(VariationSubject, AtACornerIsItsTake)
{
    const Movement movement = movementOf({square()});
    EXPECT_THAT(subjectTakes(movement, between(0, 0)), ElementsAre(BlendShare{0, 1}));
    EXPECT_THAT(subjectTakes(movement, between(1, 0)), ElementsAre(BlendShare{1, 1}));
    EXPECT_THAT(subjectTakes(movement, between(0, 1)), ElementsAre(BlendShare{2, 1}));
    EXPECT_THAT(subjectTakes(movement, between(1, 1)), ElementsAre(BlendShare{3, 1}));
}

TEST(VariationSubject, OnAnEdgeIsTheBlendOfTwoTakes)
{
    // One edge has more learned weights than the grid.
    const Movement movement = movementOf({square(), {.from = 3, .to = 2, .weights = {0.25}, .across = {}}});
    const auto pair = [&](std::size_t from, std::size_t to, double weight) {
        return subjectTakes(movement, {.take = from, .to = to, .weight = weight, .across = {}});
    };
    for (const double weight : {0.1, 0.25, 0.3, 0.5, 0.7, 0.9}) {
        EXPECT_EQ(subjectTakes(movement, between(weight, 0)), pair(0, 1, weight));
        EXPECT_EQ(subjectTakes(movement, between(weight, 1)), pair(2, 3, weight));
        EXPECT_EQ(subjectTakes(movement, between(0, weight)), pair(0, 2, weight));
        EXPECT_EQ(subjectTakes(movement, between(1, weight)), pair(1, 3, weight));
    }
    // From the middle, take 8, to three quarters of the way, take 9.
    EXPECT_THAT(pair(2, 3, 0.625), ElementsAre(BlendShare{8, 0.5}, BlendShare{9, 0.5}));
    EXPECT_THAT(pair(2, 0, 0.75), ElementsAre(BlendShare{5, 1}));
}

TEST(VariationSubject, InsideLiesBetweenTheNodesOfItsCell)
{
    const Movement movement = movementOf({square()});
    // Half-way from the first column to the second, a third of the way from the second row to the third.
    const std::vector<BlendShare> shares = subjectTakes(movement, between(0.25, 0.5));
    EXPECT_THAT(takesOf(shares), ElementsAre(5, 6, 2, 8));
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(shares[i].share, i < 2 ? 1. / 3 : 1. / 6, 1e-15);
    EXPECT_THAT(subjectTakes(movement, between(0.5, 0.25)), ElementsAre(BlendShare{6, 1}));
    // On a line of the grid two nodes are enough.
    EXPECT_THAT(takesOf(subjectTakes(movement, between(0.75, 0.25))), ElementsAre(6, 7));
}

TEST(VariationSubject, InsideOfASquareThatWasNotLearnedLiesBetweenItsCorners)
{
    const Movement movement = movementOf({{.from = 0, .to = 1, .weights = {0.5}, .across = {}}});
    const std::vector<BlendShare> shares = subjectTakes(movement, between(0.25, 0.5));
    EXPECT_THAT(shares, ElementsAre(BlendShare{0, 0.375}, BlendShare{1, 0.125}, BlendShare{2, 0.375},
                                    BlendShare{3, 0.125}));
    EXPECT_EQ(capturedShares(movement, between(0.25, 0.5)), shares);
}

TEST(VariationSubject, FindsTheGridFromEachOfItsCorners)
{
    const Movement movement = movementOf({square()});
    const auto sorted = [](std::vector<BlendShare> shares) {
        std::ranges::sort(shares, {}, &BlendShare::take);
        return shares;
    };
    const std::vector<BlendShare> expected = sorted(subjectTakes(movement, between(0.125, 0.0625)));
    ASSERT_EQ(expected.size(), 4U);
    const auto same = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d, double weight,
                          double across) {
        return sorted(subjectTakes(
                   movement,
                   {.take = a, .to = b, .weight = weight, .across = SubjectAcross{c, d, across}})) ==
               expected;
    };
    EXPECT_TRUE(same(1, 0, 3, 2, 0.875, 0.0625));
    EXPECT_TRUE(same(2, 3, 0, 1, 0.125, 0.9375));
    EXPECT_TRUE(same(3, 2, 1, 0, 0.875, 0.9375));
    EXPECT_TRUE(same(0, 2, 1, 3, 0.0625, 0.125));
    EXPECT_TRUE(same(2, 0, 3, 1, 0.9375, 0.125));
    EXPECT_TRUE(same(1, 3, 0, 2, 0.0625, 0.875));
    EXPECT_TRUE(same(3, 1, 2, 0, 0.9375, 0.875));
    // Other neighbours are another square: it has no learned inside.
    EXPECT_THAT(takesOf(subjectTakes(
                    movement, {.take = 0, .to = 3, .weight = 0.5, .across = SubjectAcross{1, 2, 0.5}})),
                ElementsAre(0, 3, 1, 2));
}

TEST(VariationSubject, RefusesWhatCannotBe)
{
    const Movement movement = movementOf({square()});
    std::vector<VariationSubject> bad{
        between(1.5, 0),   between(0.5, -0.1),
        between(0, 1.5),   between(0.5, std::numeric_limits<double>::quiet_NaN()),
        between(0.5, 0.5), between(0.5, 0.5),
        between(0.5, 0.5)};
    bad[4].across->to = 4;
    bad[5].to.reset();
    bad[6].take = 9;
    for (std::size_t b = 0; b < bad.size(); ++b) {
        EXPECT_EQ(test::codeOf([&] { subjectTakes(movement, bad[b]); }), ErrorCode::BadArgument) << b;
        EXPECT_EQ(test::codeOf([&] { capturedShares(movement, bad[b]); }), ErrorCode::BadArgument) << b;
    }
}

} // namespace quadrille
