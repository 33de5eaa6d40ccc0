// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/executor.h"

#include <atomic>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

class LocalExecutor : public Executor
{
public:
    void run(const TaskSet& tasks, const Progress& progress) const override
    {
        progress.report(0);
        std::atomic<double> done = 0; // tasks, with the finished parts of those that run
        tbb::parallel_for(
            tbb::blocked_range<std::int64_t>(0, tasks.count, 1),
            [&](const tbb::blocked_range<std::int64_t>& range) {
                for (std::int64_t task = range.begin(); task < range.end(); ++task) {
                    double before = 0;
                    const Progress own(progress.token(), [&](double fraction) {
                        const double reached = done.fetch_add(fraction - before) + fraction - before;
                        before = fraction;
                        progress.report(reached / static_cast<double>(tasks.count));
                    });
                    own.report(0);
                    const TaskSet::Result result = tasks.compute(task, own);
                    tasks.store(task, result);
                    own.report(1);
                }
            },
            tbb::simple_partitioner());
        progress.report(1);
    }
};

} // namespace

const Executor& localExecutor()
{
    static const LocalExecutor executor;
    return executor;
}

} // namespace quadrille
