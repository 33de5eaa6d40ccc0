// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Coefficients that are captured with the frames, from the takes to a variation.
#include "model/variation/variations.h"
#include "tests/model/codeof.h"
#include "tests/model/variation/swayingtakes.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::swayingTake;

double phaseAt(int frame, int frames)
{
    return 2.5 * std::sin(std::numbers::pi * frame / (frames - 1));
}

/// Two values that follow the pose, in units of their own.
RowMatrix coefficientsOf(int frames, double size)
{
    RowMatrix values(frames, 2);
    for (int f = 0; f < frames; ++f)
        values.row(f) << 40 * size * std::sin(phaseAt(f, frames)), 100 + 8 * std::cos(phaseAt(f, frames));
    return values;
}

std::vector<TrainingTake> twoTakes(bool hasCoefficients)
{
    std::vector<TrainingTake> takes;
    for (const auto& [frames, size] : {std::pair(20, 1.0), std::pair(30, 1.3)}) {
        const auto phase = [count = frames](int f) { return phaseAt(f, count); };
        TrainingTake& take = takes.emplace_back();
        take.sequence = swayingTake("take " + std::to_string(frames), frames, phase, test::strideAt, size);
        if (hasCoefficients)
            take.coefficients = {coefficientsOf(frames, size)};
    }
    return takes;
}

std::shared_ptr<const Movement> movementOf(const std::vector<TrainingTake>& takes, MovementSettings settings)
{
    const auto pose = test::swayedTube(0);
    settings.alignment.cycles = false;
    return std::make_shared<const Movement>(
        makeMovement(takes, 0, cutIntoParts(*test::swayingTopology(), pose, {}, {}),
                     {{.from = 0, .to = 1, .weights = {0.5}, .across = {}}}, settings));
}

MovementSettings withAppearance()
{
    MovementSettings settings;
    settings.coefficients = {{"appearance", 3}};
    return settings;
}

} // namespace

TEST(Coefficients, BetweenFramesAreLinear)
{
    RowMatrix values(3, 2);
    values << 0, 10, 2, 20, 8, 0;
    RowMatrix expected(5, 2);
    expected << 0, 10, 1, 15, 2, 20, 6.5, 5, 8, 0;
    EXPECT_LT((valuesAt(values, std::vector<double>{-1, 0.5, 1, 1.75, 9}) - expected).norm(), 1e-12);
}

TEST(Coefficients, AreWarpedAndBlendedWithThePoses)
{
    const auto movement = movementOf(twoTakes(true), withAppearance());
    ASSERT_EQ(movement->alignment.takes.size(), 3U);
    const RowMatrix& second = movement->take(1).coefficients.at(0);
    ASSERT_EQ(second.rows(), 20);
    const RowMatrix captured = coefficientsOf(30, 1.3);
    EXPECT_LT((second.row(0) - captured.row(0)).norm(), 1e-9);
    EXPECT_LT((second.row(19) - captured.row(29)).norm(), 1e-9);
    EXPECT_LT((second - valuesAt(captured, movement->take(1).warp.positions)).norm(), 1e-9);
    EXPECT_LT(
        (movement->take(2).coefficients.at(0) - (movement->take(0).coefficients.at(0) + second) / 2).norm(),
        1e-9);
}

TEST(Coefficients, ThatAreAbsentChangeNothing)
{
    const auto with = movementOf(twoTakes(true), withAppearance());
    const auto without = movementOf(twoTakes(false), {});
    const RowMatrix& rows = without->training.front().rows;
    EXPECT_EQ(rows, with->training.front().rows.leftCols(rows.cols()));
    EXPECT_EQ(with->training.front().rows.cols(), rows.cols() + 2);
    EXPECT_EQ(without->training.front().blocks.size(), 1U);
}

TEST(Coefficients, ComeBackFromTheModelInTheTimingOfWhatIsVaried)
{
    const auto movement = movementOf(twoTakes(true), withAppearance());
    std::vector<GpdmState> states;
    for (const GpdmLearning& learning : learnParts(*movement, {.restarts = 0}))
        states.push_back(learning.state);
    const LearnedMovement learned(movement, states);
    for (const std::size_t take : {0U, 1U}) {
        const VariationSubject subject{.take = take, .to = {}, .across = {}};
        const auto found = variationCoefficients(learned, subject, {learned.trajectory(0, take)});
        const RowMatrix captured = take == 0 ? coefficientsOf(20, 1) : coefficientsOf(30, 1.3);
        ASSERT_EQ(found.size(), 1U);
        ASSERT_EQ(found.front().rows(), captured.rows());
        // Of ranges of 40 to 50 and about 15.
        EXPECT_LT((found.front() - captured).col(0).cwiseAbs().maxCoeff(), 4) << take;
        EXPECT_LT((found.front() - captured).col(1).cwiseAbs().maxCoeff(), 1.5) << take;
    }
    const VariationSubject half{.take = 0, .to = 1, .weight = 0.5, .across = {}};
    EXPECT_EQ(variationCoefficients(learned, half, {learned.trajectory(0, 2)}).front().rows(), 25);
}

TEST(Coefficients, AreNoneWhereNoneWereLearned)
{
    const auto movement = movementOf(twoTakes(false), {});
    std::vector<GpdmState> states;
    for (const GpdmLearning& learning : learnParts(*movement, {.restarts = 0}))
        states.push_back(learning.state);
    const LearnedMovement learned(movement, states);
    EXPECT_TRUE(
        variationCoefficients(learned, {.take = 0, .to = {}, .across = {}}, {learned.trajectory(0, 0)})
            .empty());
}

TEST(Coefficients, AreRefusedWhereTakesDiffer)
{
    std::vector<std::vector<TrainingTake>> bad(4, twoTakes(true));
    bad[0][1].coefficients.clear();
    bad[1][1].coefficients[0].conservativeResize(29, 2);
    bad[2][1].coefficients[0].conservativeResize(30, 3);
    bad[3][0].coefficients.push_back(bad[3][0].coefficients[0]);
    for (std::size_t b = 0; b < bad.size(); ++b)
        EXPECT_EQ(test::codeOf([&] { movementOf(bad[b], withAppearance()); }), ErrorCode::BadArgument) << b;
}

} // namespace quadrille
