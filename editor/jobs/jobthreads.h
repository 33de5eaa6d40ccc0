// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/core/progress.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace quadrille {

/// What a job's thread and the interface share. The thread writes `result` and `error` before it sets `over`;
/// the interface reads them after.
struct JobTask
{
    using Work = std::function<std::shared_ptr<void>(const Progress&)>;

    Work work; ///< holds the snapshot; released by the thread as soon as it ran
    CancelToken token;
    std::atomic<double> fraction{0};
    std::atomic<bool> started{false};
    std::atomic<bool> over{false};
    bool isEndAwaited = false; ///< it is known to be over; of the interface thread
    std::shared_ptr<void> result;
    std::optional<Error> error;
};

/// A few threads that work off tasks in the order they came. On Linux they run at a lower priority than the
/// interface.
class JobThreads
{
public:
    /// \param wake is called from the threads when a task has something to tell, seldom more often than
    /// twenty times a second and task. \param count  at most so many; a thread is started when a task finds
    /// none idle.
    JobThreads(int count, std::function<void()> wake);
    /// Cancels everything and waits for the threads.
    ~JobThreads();
    JobThreads(const JobThreads&) = delete;
    JobThreads& operator=(const JobThreads&) = delete;

    /// From any thread.
    void add(std::shared_ptr<JobTask> task);
    /// Ends tasks that were cancelled before a thread took them. They are over then, without result or error.
    void dropCancelled();

private:
    void loop();
    void run(JobTask& task);

    const int m_count;
    const std::function<void()> m_wake;
    std::mutex m_mutex;
    std::condition_variable m_available;
    bool m_stopping = false;
    int m_idle = 0;
    std::deque<std::shared_ptr<JobTask>> m_waiting;
    std::vector<std::shared_ptr<JobTask>> m_running;
    std::vector<std::thread> m_threads;
};

} // namespace quadrille
