// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transition/transitiontable.h"
#include "transitiontables.h"
#include "warpreference.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <tbb/task_arena.h>

using namespace quadrille;

namespace {

FrameLayout layoutOf(std::vector<std::int64_t> counts)
{
    return FrameLayout(counts);
}

void expectReference(const Table<float>& distances, const FrameLayout& layout,
                     const TransitionSettings& settings)
{
    const TransitionTable table = transitionTable(distances, layout, settings);
    WarpReference reference(distances, layout, settings);
    int found = 0;
    for (NodeIndex i = 0; i < layout.frameCount(); ++i) {
        for (NodeIndex j = 0; j < layout.frameCount(); ++j) {
            const std::optional<WarpReference::Best> best = reference.find(i, j);
            const auto values = [&](const TransitionTable& t) {
                return std::array<double, 4>{static_cast<double>(t.cost(i, j)),
                                             static_cast<double>(t.length(i, j)),
                                             static_cast<double>(t.sourceWindow(i, j)),
                                             static_cast<double>(t.destinationWindow(i, j))};
            };
            std::array<double, 4> expected{static_cast<double>(TransitionTable::none), 0, 0, 0};
            if (best) {
                const bool mean = settings.cost == TransitionCost::Mean;
                const double cost = mean ? best->sum / best->length : best->sum;
                // Both sums are exact; only the result is rounded.
                expected = {static_cast<double>(static_cast<float>(cost)), static_cast<double>(best->length),
                            static_cast<double>(best->sourceWindow),
                            static_cast<double>(best->destinationWindow)};
                ++found;
            }
            ASSERT_EQ(values(table), expected) << "from " << i << " to " << j;
        }
    }
    EXPECT_GT(found, 0);
}

} // namespace

class TransitionTables : public ::testing::TestWithParam<std::tuple<int, TransitionCost>>
{
protected:
    TransitionSettings with(int shortest, int longest) const
    {
        return windows(shortest, longest, std::get<0>(GetParam()), std::get<1>(GetParam()));
    }
};

TEST_P(TransitionTables, EqualBruteForceOnNoise)
{
    expectReference(randomDistances(34, 1), layoutOf({34}), with(4, 11));
}

TEST_P(TransitionTables, EqualBruteForceOnWalks)
{
    expectReference(walkingDistances(40, 2, 9), layoutOf({18, 22}), with(3, 10));
}

TEST_P(TransitionTables, EqualBruteForceBetweenSequencesOfAllLengths)
{
    expectReference(randomDistances(41, 3), layoutOf({1, 9, 3, 4, 12, 2, 10}), with(4, 9));
}

TEST_P(TransitionTables, BreakTiesAsBruteForceDoes)
{
    for (const int levels : {1, 2, 3})
        expectReference(randomDistances(26, static_cast<unsigned>(levels), levels), layoutOf({15, 11}),
                        with(2, 8));
    expectReference(Table<float>::Zero(20, 20), layoutOf({20}), with(3, 7));
}

TEST_P(TransitionTables, AllowWindowsOfOneFrameAndOfOneLength)
{
    expectReference(randomDistances(14, 4), layoutOf({6, 8}), with(1, 5));
    expectReference(randomDistances(24, 5), layoutOf({24}), with(6, 6));
    expectReference(randomDistances(6, 6), layoutOf({6}), with(1, 1));
}

TEST_P(TransitionTables, EqualBruteForceWhereLongWindowsWin)
{
    // Few dear cells among cheap ones: paths go far round the dear ones.
    const Table<float> distances = randomDistances(64, 7, 8).pow(6);
    const FrameLayout layout = layoutOf({31, 33});
    const TransitionSettings settings = with(3, 22);
    const TransitionTable table = transitionTable(distances, layout, settings);
    WarpReference reference(distances, layout, settings);
    int longWindows = 0;
    for (NodeIndex i = 0; i < 29; i += 4) {
        for (NodeIndex j = 34; j < 64; j += 5) {
            const WarpReference::Best best = reference.find(i, j).value();
            const bool mean = settings.cost == TransitionCost::Mean;
            EXPECT_FLOAT_EQ(table.cost(i, j), static_cast<float>(mean ? best.sum / best.length : best.sum));
            EXPECT_EQ(table.length(i, j), best.length);
            EXPECT_EQ(table.sourceWindow(i, j), best.sourceWindow);
            EXPECT_EQ(table.destinationWindow(i, j), best.destinationWindow);
            longWindows += best.sourceWindow + best.destinationWindow >= 10 ? 1 : 0;
        }
    }
    EXPECT_GT(longWindows, 3);
}

INSTANTIATE_TEST_SUITE_P(Slopes, TransitionTables,
                         ::testing::Combine(::testing::Values(2, 3, 4, 5),
                                            ::testing::Values(TransitionCost::Sum, TransitionCost::Mean)),
                         [](const auto& instance) {
                             return (std::get<1>(instance.param) == TransitionCost::Sum ? "Sum" : "Mean") +
                                    std::to_string(std::get<0>(instance.param));
                         });

TEST(TransitionTable, TakesTheCheapestWayByHand)
{
    // Two sequences of three frames, windows of two to three frames.
    Table<float> distances = Table<float>::Constant(6, 6, 4);
    distances.matrix().diagonal().setZero();
    const auto set = [&](int i, int j, float d) { distances(i, j) = distances(j, i) = d; };
    set(0, 3, 1);
    set(1, 4, 2);
    set(1, 5, 1);
    set(2, 5, 1);
    const FrameLayout layout = layoutOf({3, 3});
    const TransitionTable table = transitionTable(distances, layout, windows(2, 3));
    // 0 → 5: (0,3) (1,4) and then (1,5) or (2,5) cost 4 in three cells: the smaller source window wins. From
    // the destination start 4, (0,4) (1,5) costs 5.
    EXPECT_EQ(table.cost(0, 5), 4);
    EXPECT_EQ(table.length(0, 5), 3);
    EXPECT_EQ(table.sourceWindow(0, 5), 2);
    EXPECT_EQ(table.destinationWindow(0, 5), 3);
    // 0 → 4: only the destination window [3, 4] fits; (0,3) (1,4).
    EXPECT_EQ(table.cost(0, 4), 3);
    EXPECT_EQ(table.length(0, 4), 2);
    // 1 → 5: windows [1, 2] and [4, 5] cost 3; (1,3) … would cost more.
    EXPECT_EQ(table.cost(1, 5), 3);
    EXPECT_EQ(table.sourceWindow(1, 5), 2);
    EXPECT_EQ(table.destinationWindow(1, 5), 2);
    // Nothing fits after the last frame or before the first, nor from a frame to itself.
    EXPECT_EQ(table.cost(2, 5), TransitionTable::none);
    EXPECT_EQ(table.cost(0, 3), TransitionTable::none);
    EXPECT_EQ(table.cost(1, 1), TransitionTable::none);
    EXPECT_EQ(table.length(2, 5), 0);
}

TEST(TransitionTable, LimitsStepsInARow)
{
    // The source stands still against a destination that runs through cheap cells: one row of zeros.
    Table<float> distances = Table<float>::Constant(14, 14, 1);
    for (int j = 4; j < 14; ++j)
        distances(1, j) = 0;
    const FrameLayout layout = layoutOf({4, 10});
    for (const int slope : {2, 3, 4, 5}) {
        // (0,·) diagonally to (1,·), `slope` steps to the right, diagonally to (2,·): cost 2.
        TransitionSettings settings = windows(3, 10, slope);
        const TransitionTable table = transitionTable(distances, layout, settings);
        EXPECT_EQ(table.cost(0, 13), 2) << slope;
        EXPECT_EQ(table.length(0, 13), 3) << slope;
        // With windows that long the path must fill up with dear cells what the slope forbids.
        settings.shortestWindow = 4;
        const WarpReference::Best best = *WarpReference(distances, layout, settings).find(0, 13);
        EXPECT_EQ(transitionTable(distances, layout, settings).cost(0, 13), static_cast<float>(best.sum));
    }
}

TEST(TransitionTable, DoesNotDependOnThreadsNorOnTheUnitOfDistances)
{
    const Table<float> distances = walkingDistances(150, 7);
    const FrameLayout layout = layoutOf({70, 5, 75});
    for (const TransitionCost cost : {TransitionCost::Sum, TransitionCost::Mean}) {
        TransitionSettings settings;
        settings.cost = cost;
        const auto on = [&](int threads, float unit) {
            tbb::task_arena arena(threads);
            const Table<float> scaled = distances * unit;
            return arena.execute([&] { return transitionTable(scaled, layout, settings); });
        };
        const TransitionTable one = on(1, 1);
        for (const TransitionTable& other : {on(4, 1), on(2, 0x1p-20F)}) {
            EXPECT_TRUE(one.length == other.length);
            EXPECT_TRUE(one.windows == other.windows);
        }
        EXPECT_TRUE(one.cost == on(3, 1).cost);
        const TransitionTable scaled = on(1, 0x1p-20F);
        EXPECT_TRUE((*one.cost * 0x1p-20F == *scaled.cost).all());
    }
}

TEST(TransitionTable, ComesFromSmallTasksInAnyOrder)
{
    class Backwards : public Executor
    {
    public:
        void run(const TaskSet& tasks, const Progress& progress) const override
        {
            for (std::int64_t task = tasks.count - 1; task >= 0; --task) {
                const TaskSet::Result result = tasks.compute(task, progress.part(0, 0));
                // Sixteen source frames of 150 entries of twelve bytes.
                EXPECT_LE(result.size(), 16U * 150 * 12);
                tasks.store(task, result);
            }
        }
    };
    const Table<float> distances = walkingDistances(150, 8);
    const FrameLayout layout = layoutOf({33, 1, 116});
    const TransitionTable table = transitionTable(distances, layout, {});
    const TransitionTable backwards = transitionTable(distances, layout, {}, {}, Backwards());
    EXPECT_TRUE(table.cost == backwards.cost);
    EXPECT_TRUE(table.length == backwards.length);
    EXPECT_TRUE(table.windows == backwards.windows);
}

TEST(TransitionTable, HasNothingWhereNothingFits)
{
    const TransitionTable empty = transitionTable(Table<float>(), FrameLayout(), {});
    EXPECT_EQ(empty.cost.size(), 0);
    const FrameLayout layout = layoutOf({8, 1, 8});
    const TransitionTable table = transitionTable(randomDistances(17, 1), layout, {});
    EXPECT_TRUE((*table.cost == TransitionTable::none).all());
    EXPECT_TRUE((*table.length == 0).all());
}

TEST(TransitionTable, LinearTransitionsAdvanceTogether)
{
    const Table<float> distances = randomDistances(30, 9);
    const FrameLayout layout = layoutOf({14, 3, 13});
    const TransitionTable linear = linearTransitionTable(distances, layout, windows(5, 12));
    double expected = 0;
    for (int k = 0; k < 5; ++k)
        expected += static_cast<double>(distances(3 + k, 21 + k));
    EXPECT_FLOAT_EQ(linear.cost(3, 25), static_cast<float>(expected));
    EXPECT_EQ(linear.length(3, 25), 5);
    EXPECT_EQ(linear.sourceWindow(3, 25), 5);
    EXPECT_EQ(linear.cost(10, 25), TransitionTable::none);
    EXPECT_EQ(linear.cost(3, 20), TransitionTable::none);
    // More freedom never costs more: linear, warped in the same windows, warped in windows of any length.
    const TransitionTable same = transitionTable(distances, layout, windows(5, 5));
    const TransitionTable any = transitionTable(distances, layout, windows(5, 12));
    EXPECT_TRUE((*any.cost <= *same.cost).all());
    EXPECT_TRUE((*same.cost <= *linear.cost).all());
    EXPECT_TRUE((any.cost->isFinite() == linear.cost->isFinite()).all());
    const TransitionTable mean =
        linearTransitionTable(distances, layout, windows(5, 12, 3, TransitionCost::Mean));
    EXPECT_FLOAT_EQ(mean.cost(3, 25), static_cast<float>(expected / 5));
}

TEST(TransitionTable, StopsWhenCancelledAndTellsHowFarItIs)
{
    const Table<float> distances = walkingDistances(200, 1);
    const FrameLayout layout = layoutOf({120, 80});
    for (const TransitionCost cost : {TransitionCost::Sum, TransitionCost::Mean}) {
        TransitionSettings settings;
        settings.cost = cost;
        std::vector<double> fractions;
        transitionTable(distances, layout, settings,
                        Progress(CancelToken(), [&](double fraction) { fractions.push_back(fraction); }));
        EXPECT_GT(fractions.size(), 100U);
        EXPECT_EQ(fractions.back(), 1);
        CancelToken token;
        const Progress stopping(token, [&token](double fraction) {
            if (fraction > 0.2)
                token.cancel();
        });
        try {
            transitionTable(distances, layout, settings, stopping);
            FAIL() << "not cancelled";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Cancelled);
        }
    }
}

TEST(TransitionSettings, AreThePapersAndFollowTheFrameRate)
{
    TransitionSettings settings;
    EXPECT_EQ(settings.shortest(), 9);
    EXPECT_EQ(settings.longest(), 50);
    EXPECT_EQ(settings.slope, 3);
    settings.fps = 30;
    EXPECT_EQ(settings.shortest(), 10);
    EXPECT_EQ(settings.longest(), 60);
    settings.fps = 29.97;
    EXPECT_EQ(settings.shortest(), 10);
    EXPECT_EQ(settings.longest(), 59);
    settings.fps = 0.3;
    EXPECT_EQ(settings.shortest(), 1);
    EXPECT_EQ(settings.longest(), 1);
}

TEST(TransitionSettings, RefuseWhatCannotBe)
{
    const Table<float> distances = randomDistances(20, 1);
    TransitionSettings badFps;
    badFps.fps = std::numeric_limits<double>::quiet_NaN();
    for (const TransitionSettings& settings :
         {windows(0, 5), windows(6, 5), windows(1, 5000), windows(4, 8, 1), windows(4, 8, 6), badFps}) {
        try {
            transitionTable(distances, layoutOf({20}), settings);
            FAIL() << "not refused";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        }
    }
}
