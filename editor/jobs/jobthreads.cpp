// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/jobs/jobthreads.h"

#include "model/core/caughterror.h"

#include <algorithm>
#include <chrono>
#include <utility>
#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace quadrille {

namespace {

constexpr auto wakeInterval = std::chrono::milliseconds(50);

/// Jobs, and the workers that they start (which inherit it), give way to the interface and to what it plays.
void giveWay()
{
#ifdef __linux__
    constexpr int niceness = 5; // a third of the weight
    // Of this thread alone, as Linux has it; where it is refused, jobs only compete more.
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
#endif
}

void finish(JobTask& task)
{
    task.work = {};
    task.over.store(true, std::memory_order_release);
}

} // namespace

JobThreads::JobThreads(int count, std::function<void()> wake) : m_count(count), m_wake(std::move(wake)) {}

JobThreads::~JobThreads()
{
    {
        const std::scoped_lock lock(m_mutex);
        m_stopping = true;
        for (const auto& task : m_running)
            task->token.cancel();
        m_waiting.clear();
    }
    m_available.notify_all();
    for (std::thread& thread : m_threads)
        thread.join();
}

void JobThreads::add(std::shared_ptr<JobTask> task)
{
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting.push_back(std::move(task));
        const bool crowded = m_waiting.size() > static_cast<std::size_t>(m_idle);
        if (crowded && m_threads.size() < static_cast<std::size_t>(m_count))
            m_threads.emplace_back([this] { loop(); });
    }
    m_available.notify_one();
}

void JobThreads::dropCancelled()
{
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_waiting, [](const std::shared_ptr<JobTask>& task) {
        const bool cancelled = task->token.isCancelled();
        if (cancelled)
            finish(*task);
        return cancelled;
    });
}

void JobThreads::loop()
{
    giveWay();
    std::unique_lock lock(m_mutex);
    while (true) {
        ++m_idle;
        m_available.wait(lock, [this] { return m_stopping || !m_waiting.empty(); });
        --m_idle;
        if (m_stopping)
            return;
        const std::shared_ptr<JobTask> task = std::move(m_waiting.front());
        m_waiting.pop_front();
        m_running.push_back(task);
        lock.unlock();
        run(*task);
        m_wake();
        lock.lock();
        std::erase(m_running, task);
    }
}

void JobThreads::run(JobTask& task)
{
    using Clock = std::chrono::steady_clock;
    task.started.store(true, std::memory_order_relaxed);
    m_wake();
    const Progress progress(task.token, [&task, this, woken = Clock::now()](double fraction) mutable {
        task.fraction.store(fraction, std::memory_order_relaxed);
        const auto now = Clock::now();
        if (now - woken < wakeInterval)
            return;
        woken = now;
        m_wake();
    });
    try {
        progress.report(0);
        task.result = task.work(progress);
    } catch (...) {
        task.error = caughtError();
    }
    finish(task);
}

} // namespace quadrille
