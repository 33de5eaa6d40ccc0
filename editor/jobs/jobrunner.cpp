// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/jobs/jobrunner.h"

#include "editor/jobs/jobthreads.h"

#include <QCoreApplication>
#include <QEvent>
#include <QThread>
#include <algorithm>

namespace quadrille {

namespace {

const auto wakeEvent = static_cast<QEvent::Type>(QEvent::registerEventType());

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
    if (receiver)
        connect(receiver, &QObject::destroyed, job, &Job::cancel);
    m_jobs.push_back(job);
    emit started(job);
    m_threads->add(std::move(task));
    return job;
}

void JobRunner::wake()
{
    if (!m_woken.exchange(true))
        QCoreApplication::postEvent(this, new QEvent(wakeEvent));
}

bool JobRunner::event(QEvent* event)
{
    if (event->type() != wakeEvent)
        return QObject::event(event);
    m_woken.store(false);
    update();
    return true;
}

void JobRunner::update()
{
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
