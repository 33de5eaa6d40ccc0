// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille {

/// Independent pieces of one large computation, numbered from zero.
struct TaskSet
{
    /// Plain bytes, so that a result can come from another process.
    using Result = std::vector<std::byte>;

    std::int64_t count = 0;
    /// Computes a task from inputs that stay as they are, on any thread, perhaps in another process that
    /// holds the same inputs: it leaves nothing behind but its result. Reports 0 … 1 of its own work.
    std::function<Result(std::int64_t task, const Progress& progress)> compute;
    /// Puts the result of a task into its place, in the process that called run: once for each task, on any
    /// thread, several tasks at a time.
    std::function<void(std::int64_t task, std::span<const std::byte> result)> store;
};

/// Computes tasks: on the cores of this machine, or wherever an implementation takes them. What comes out
/// does not depend on the order of the tasks, nor on how many run at a time.
class Executor
{
public:
    virtual ~Executor() = default;
    /// Returns once the results of all tasks are stored.
    /// \throws Error Cancelled, and what a task throws (the first to fail; the others are not begun any
    /// more).
    virtual void run(const TaskSet& tasks, const Progress& progress) const = 0;
};

/// The cores of this machine, by oneTBB (as many as the calling arena has).
const Executor& localExecutor();

/// Tasks whose results are arrays of plain values.
/// \param compute  (std::int64_t task, const Progress&) → std::vector<Value>.
/// \param store  (std::int64_t task, std::span<const Value>).
template <typename Value, typename Compute, typename Store>
TaskSet makeTasks(std::int64_t count, Compute compute, Store store)
{
    static_assert(std::is_trivially_copyable_v<Value>);
    return {.count = count,
            .compute =
                [compute = std::move(compute)](std::int64_t task, const Progress& progress) {
                    const std::vector<Value> values = compute(task, progress);
                    const auto bytes = std::as_bytes(std::span(values));
                    return TaskSet::Result(bytes.begin(), bytes.end());
                },
            .store =
                [store = std::move(store)](std::int64_t task, std::span<const std::byte> result) {
                    std::vector<Value> values(result.size() / sizeof(Value));
                    if (!values.empty())
                        std::memcpy(values.data(), result.data(), result.size());
                    store(task, std::span<const Value>(values));
                }};
}

} // namespace quadrille
