// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/jobs/jobrunner.h"

#include "editor/jobs/jobthreads.h"

#include <QMetaObject>
#include <QThread>
#include <algorithm>

namespace quadrille {

namespace {

int threadCount(int wanted)
{
    return wanted > 0 ? wanted : std::clamp(QThread::idealThreadCount(), 2, 8);
}

} // namespace

JobRunner::JobRunner(QObject* parent, int threads)
    : QObject(parent), m_threads(std::make_unique<JobThreads>(threadCount(threads), [this] { wake(); }))
{
}

JobRunner::~JobRunner()
{
    m_threads.reset();
    for (Job* job : m_jobs)
        delete job;
}

std::vector<Job*> JobRunner::jobs() const
{
    return m_jobs;
}

void JobRunner::cancelAll()
{
    for (Job* job : m_jobs)
        job->cancel();
}

Job* JobRunner::add(JobSettings settings, ErasedWork work, Deliver deliver)
{
    auto task = std::make_shared<JobTask>();
    task->work = std::move(work);
    QObject* const receiver = settings.receiver;
    auto* job = new Job(*this, std::move(settings), task, std::move(deliver));
    // One that is over and waits for its deletion must not outlive the runner that it would wake.
    job->setParent(this);
    if (receiver)
        connect(receiver, &QObject::destroyed, job, &Job::cancel);
    m_jobs.push_back(job);
    emit started(job);
    m_threads->add(std::move(task));
    return job;
}

void JobRunner::wake()
{
    // By name, so that the event is made and read inside Qt: the thread sanitizer cannot see Qt's own locks.
    if (!m_woken.exchange(true))
        QMetaObject::invokeMethod(this, "update", Qt::QueuedConnection);
}

void JobRunner::update()
{
    m_woken.store(false);
    m_threads->dropCancelled();
    const std::vector<Job*> jobs = m_jobs; // what is handed on may start or end jobs
    for (Job* job : jobs) {
        if (!job->update())
            continue;
        std::erase(m_jobs, job);
        job->deliver();
        emit ended(job);
        job->deleteLater();
    }
}

} // namespace quadrille

#include "moc_jobrunner.cpp"
