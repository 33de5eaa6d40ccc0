// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"

#include <QObject>
#include <atomic>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille {

class JobThreads;

/// Runs long work off the interface thread and hands its result back on it. Jobs take their input by value
/// (captured by `work`), never by reference to what the user may edit meanwhile.
///
///     m_jobs.start({.name = tr("Opening %1").arg(name), .receiver = this, .failed = show},
///                  [path](const Progress& progress) { return openSequences(path, {}, progress); },
///                  [this](ImportResult result) { take(std::move(result)); });
class JobRunner : public QObject
{
    Q_OBJECT
public:
    /// Jobs that find no thread free wait, in the order they were started.
    /// \param threads that work at a time; 0: two to eight, by the cores.
    explicit JobRunner(QObject* parent = nullptr, int threads = 0);
    /// Cancels all jobs and waits for their threads; nothing is handed on any more.
    ~JobRunner() override;

    /// \param work `Result work(const Progress&)`, on a thread of its own; must report at least every 50 ms.
    /// What it posts to the interface thread (see Mailbox) is taken before its end.
    /// \param done `void done(Result)`, or `void done()` where work returns nothing; on the interface thread.
    /// \return the job, which the runner owns.
    template <typename Work, typename Done>
    Job* start(const JobSettings& settings, Work work, Done done);

    /// Jobs that are not over yet, in the order they were started.
    std::vector<Job*> jobs() const;
    /// Does not wait for them.
    void cancelAll();

signals:
    /// It waits for its thread now. Background jobs are told as well.
    void started(quadrille::Job* job);
    /// After the job's own `ended`; it is deleted when control is back in the event loop.
    void ended(quadrille::Job* job);
    /// A job failed that has no handler of its own.
    void failed(quadrille::Job* job, const quadrille::Error& error);

private:
    friend class Job;
    using ErasedWork = std::function<std::shared_ptr<void>(const Progress&)>;
    using Deliver = std::function<void(void*)>;

    Job* add(JobSettings settings, ErasedWork work, Deliver deliver);
    /// Has `update` called on the interface thread, once for any number of calls. From any thread.
    void wake();
    Q_INVOKABLE void update();

    std::vector<Job*> m_jobs;
    std::atomic<bool> m_woken{false};
    std::unique_ptr<JobThreads> m_threads;
};

template <typename Work, typename Done>
Job* JobRunner::start(const JobSettings& settings, Work work, Done done)
{
    using Output = std::invoke_result_t<Work&, const Progress&>;
    if constexpr (std::is_void_v<Output>) {
        return add(
            settings,
            [work = std::move(work)](const Progress& progress) mutable -> std::shared_ptr<void> {
                work(progress);
                return nullptr;
            },
            [done = std::move(done)](void*) mutable { done(); });
    } else {
        return add(
            settings,
            [work = std::move(work)](const Progress& progress) mutable -> std::shared_ptr<void> {
                return std::make_shared<Output>(work(progress));
            },
            [done = std::move(done)](void* result) mutable {
                done(std::move(*static_cast<Output*>(result)));
            });
    }
}

} // namespace quadrille
