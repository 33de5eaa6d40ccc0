// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/jobs/job.h"

#include "editor/jobs/jobrunner.h"
#include "editor/jobs/jobthreads.h"

#include <utility>

namespace quadrille {

Job::Job(JobRunner& runner, JobSettings settings, std::shared_ptr<JobTask> task, Deliver deliver)
    : m_runner(runner)
    , m_settings(std::move(settings))
    , m_task(std::move(task))
    , m_deliver(std::move(deliver))
{
}

Job::~Job() = default;

std::optional<Seconds> Job::timeLeft() const
{
    constexpr qint64 shortestMs = 500; // sooner the rate says nothing
    constexpr double smallestFraction = 0.01;
    if (isOver() || !m_clock.isValid() || m_clock.elapsed() < shortestMs || m_fraction < smallestFraction)
        return std::nullopt;
    return Seconds{static_cast<double>(m_clock.elapsed()) / 1000.0 * (1.0 - m_fraction) / m_fraction};
}

void Job::cancel()
{
    m_task->token.cancel();
    m_runner.wake();
}

CancelToken Job::token() const
{
    return m_task->token;
}

void Job::setState(State state)
{
    if (m_state == state)
        return;
    m_state = state;
    emit changed();
}

bool Job::update()
{
    if (isOver())
        return false;
    if (m_task->over.load(std::memory_order_acquire)) {
        // All that the work posted is queued by now; the end comes after it, with the next update.
        if (std::exchange(m_task->isEndAwaited, true))
            return true;
        m_runner.wake();
        return false;
    }
    if (m_task->token.isCancelled()) {
        setState(State::Cancelling);
        return false;
    }
    if (m_state == State::Waiting && m_task->started.load(std::memory_order_relaxed)) {
        m_clock.start();
        setState(State::Running);
    }
    const double fraction = m_task->fraction.load(std::memory_order_relaxed);
    if (fraction > m_fraction) {
        m_fraction = fraction;
        emit changed();
    }
    return false;
}

void Job::deliver()
{
    // The task's fields are taken first: a callback may run an event loop of its own.
    const std::optional<Error> error = std::exchange(m_task->error, std::nullopt);
    const std::shared_ptr<void> result = std::exchange(m_task->result, nullptr);
    const bool cancelled = m_task->token.isCancelled() || (error && error->code() == ErrorCode::Cancelled);
    if (cancelled) {
        setState(State::Cancelled);
    } else if (m_settings.stillStands && !m_settings.stillStands()) {
        setState(State::Outdated);
    } else if (error) {
        setState(State::Failed);
        if (m_settings.failed)
            m_settings.failed(*error);
        else
            emit m_runner.failed(this, *error);
    } else {
        m_fraction = 1;
        setState(State::Done);
        m_deliver(result.get());
    }
    emit ended(m_state);
}

} // namespace quadrille

#include "moc_job.cpp"
