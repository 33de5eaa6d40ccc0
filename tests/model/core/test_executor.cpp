// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/executor.h"

#include <atomic>
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

using namespace quadrille;

namespace {

constexpr std::int64_t taskCount = 57;

/// Task t yields t numbers, all t.
std::vector<std::int64_t> repeated(std::int64_t task)
{
    return std::vector<std::int64_t>(static_cast<std::size_t>(task), task);
}

} // namespace

TEST(Executor, StoresTheResultOfEveryTaskOnce)
{
    std::vector<std::vector<std::int64_t>> stored(taskCount, {-1});
    std::atomic<int> calls = 0;
    localExecutor().run(makeTasks<std::int64_t>(
                            taskCount, [](std::int64_t task, const Progress&) { return repeated(task); },
                            [&](std::int64_t task, std::span<const std::int64_t> values) {
                                ++calls;
                                stored[static_cast<std::size_t>(task)].assign(values.begin(), values.end());
                            }),
                        {});
    EXPECT_EQ(calls, taskCount);
    for (std::int64_t task = 0; task < taskCount; ++task)
        EXPECT_EQ(stored[static_cast<std::size_t>(task)], repeated(task));
}

TEST(Executor, HasNothingToDoWithoutTasks)
{
    double reached = -1;
    localExecutor().run({}, Progress(CancelToken(), [&](double fraction) { reached = fraction; }));
    EXPECT_EQ(reached, 1);
}

TEST(Executor, ReportsProgressInsideOfTasks)
{
    std::vector<double> reports;
    const Progress progress(CancelToken(), [&](double fraction) { reports.push_back(fraction); });
    const TaskSet tasks = makeTasks<char>(
        2,
        [](std::int64_t, const Progress& own) {
            own.report(0.5);
            return std::vector<char>();
        },
        [](std::int64_t, std::span<const char>) {});
    // On one thread the order of the reports is known.
    tbb::task_arena(1).execute([&] { localExecutor().run(tasks, progress); });
    EXPECT_EQ(reports, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
}

TEST(Executor, StopsWhenCancelled)
{
    CancelToken token;
    std::atomic<int> stored = 0;
    const TaskSet tasks = makeTasks<char>(
        1000,
        [&](std::int64_t, const Progress& own) {
            token.cancel();
            own.report(0.5);
            return std::vector<char>();
        },
        [&](std::int64_t, std::span<const char>) { ++stored; });
    try {
        localExecutor().run(tasks, Progress(token));
        FAIL() << "was not stopped";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
    EXPECT_EQ(stored, 0);
}

TEST(Executor, PassesOnWhatATaskThrows)
{
    const TaskSet tasks = makeTasks<char>(
        20,
        [](std::int64_t task, const Progress&) -> std::vector<char> {
            if (task == 7)
                throw Error(ErrorCode::OutOfMemory);
            return {};
        },
        [](std::int64_t, std::span<const char>) {});
    EXPECT_THROW(localExecutor().run(tasks, {}), Error);
}
