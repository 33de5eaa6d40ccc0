// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/core/progress.h"
#include "model/core/units.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <memory>
#include <optional>

namespace quadrille {

class JobRunner;
struct JobTask;

/// How a job is shown and what happens to what it brings. Everything here is called on the interface thread.
struct JobSettings
{
    /// What the user reads in the status bar, translated.
    QString name;
    /// Whom the result is for: once it is gone the job is cancelled. May be null.
    QObject* receiver = nullptr;
    /// Whether the settings that the job was started with still stand; a result or error that comes too late
    /// is dropped. Empty: always.
    std::function<bool()> stillStands = {};
    /// Receives the error; without it the runner's signal `failed` tells it.
    std::function<void(const Error&)> failed = {};
    /// Not worth the status bar: thumbnails, previews.
    bool background = false;
};

/// One piece of work on a thread of its own, as the interface sees it. Owned by its runner and deleted after
/// `ended`; keep it in a QPointer.
class Job : public QObject
{
    Q_OBJECT
public:
    enum class State
    {
        Waiting,
        Running,
        Cancelling,
        Done,
        Failed,
        Cancelled,
        Outdated, ///< finished, but its settings no longer stand: the result was dropped
    };
    Q_ENUM(State)

    ~Job() override;

    QString name() const { return m_settings.name; }
    State state() const { return m_state; }
    bool isOver() const { return m_state >= State::Done; }
    bool isBackground() const { return m_settings.background; }
    /// Done part of the work, 0 … 1. It never falls.
    double fraction() const { return m_fraction; }
    /// Estimate; empty until there is something to go by. As if the rest went as fast, from half a second and
    /// a hundredth of the work on.
    std::optional<Seconds> timeLeft() const;
    /// Asks the job to stop; it tells no error then. From any thread, while the job lives.
    void cancel();
    /// Stops the job as `cancel` does; may be kept and used longer than the job lives.
    CancelToken token() const;

signals:
    /// State or fraction changed; at most about twenty times a second.
    void changed();
    /// The last that is heard of the job, after its result or error was handed on.
    void ended(quadrille::Job::State state);

private:
    friend class JobRunner;
    using Deliver = std::function<void(void*)>;
    Job(JobRunner& runner, JobSettings settings, std::shared_ptr<JobTask> task, Deliver deliver);

    void setState(State state);
    /// Takes over what the thread has written since; true once the thread is through with it.
    bool update();
    /// Hands on result or error.
    void deliver();

    JobRunner& m_runner;
    JobSettings m_settings;
    std::shared_ptr<JobTask> m_task;
    Deliver m_deliver;
    State m_state = State::Waiting;
    double m_fraction = 0;
    QElapsedTimer m_clock; ///< since the job got its thread
};

} // namespace quadrille
