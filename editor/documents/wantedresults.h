// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"
#include "editor/jobs/jobrunner.h"
#include "editor/jobs/mailbox.h"
#include "model/core/error.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace quadrille {

/// How far a result of a document is.
enum class ResultPhase
{
    Idle,       ///< nobody asked for it, or it was stopped
    Waiting,    ///< for something else first
    Computing,  ///< or being opened; there is a job
    Ready,      ///< as the project says
    Stale,      ///< there are older ones at most, and nobody asked for others
    Impossible, ///< there is nothing that it could be about
    Failed,     ///< there is an error
};

/// What is known of one; whoever holds results adds them to it.
struct ResultState
{
    ResultPhase phase = ResultPhase::Idle;
    std::optional<Error> error; ///< there when failed
    QPointer<Job> job;          ///< there while there is work
    int run = 0;                ///< numbers the work on it, so that what comes too late is known

    ResultState() = default;
    ResultState(const ResultState&) = delete;
    ResultState& operator=(const ResultState&) = delete;
    ResultState(ResultState&&) = default;
    ResultState& operator=(ResultState&&) = default;
    virtual ~ResultState() = default;
};

/// Results of a document that somebody wants, by their names: those of one kind, computed in jobs. Whoever
/// derives from it says by `update` what is to be done next for which of them, and starts it; this class
/// holds them, follows the document, renames and lets go, and sees to it that only the latest work on a
/// result counts, under the name that it has by then. Everything is called on the interface thread but
/// `Post`.
class WantedResults : public QObject
{
    Q_OBJECT

public:
    ~WantedResults() override;

    /// Ends the work on a result; what is there so far stays. Nothing happens where there is none.
    virtual void stop(const QString& name);

signals:
    /// The phase or the content of a result is another now, or it has come or gone.
    void changed(const QString& name);

protected:
    /// \param section  whose entries bear the names; none where renaming an entry renames no result.
    /// \param delay  how long edits may follow each other until `update`.
    WantedResults(ProjectDocument& document, JobRunner& jobs, std::optional<Section> section,
                  std::chrono::milliseconds delay, QObject* parent);

    using States = std::map<QString, std::unique_ptr<ResultState>>;

    /// Takes what comes before the end from the thread of the work to the interface, for as long as there is
    /// somebody to take it and it is of the latest work. From any thread.
    class Post
    {
    public:
        /// \param take  `void take(const QString& name, ResultState& state)`; `changed` is told after it.
        void operator()(std::function<void(const QString&, ResultState&)> take) const;

    private:
        friend class WantedResults;
        Post(WantedResults& owner, int run)
            : m_address(owner.m_mailbox.address()), m_owner(&owner), m_run(run)
        {
        }
        Mailbox::Address m_address;
        WantedResults* m_owner; ///< is there when something posted is taken
        int m_run;
    };

    /// How work is shown.
    struct Shown
    {
        QString text; ///< what the user reads in the status bar, translated
        bool background = false;
    };

    /// Does what is to be done next, after edits and when it is asked for.
    virtual void update() = 0;
    /// A change of the document; the project may be another. By default `update` comes soon.
    virtual void follow(const ChangeEvent& event);
    /// An entry has another name, and its result with it, if there is one; the work on it goes on.
    virtual void renamed(const QString& /*before*/, const QString& /*name*/) {}
    /// The user stopped the work on it; its job is gone. By default it is idle.
    virtual void stopped(const QString& name, ResultState& state);

    /// Those that somebody looks at; `update` comes at once where they are others. Renamed entries stay among
    /// them, another project has none.
    void setWanted(const QStringList& names);
    const QStringList& wanted() const { return m_wanted; }

    ProjectDocument& document() const { return m_document; }
    /// For work that is of no single result.
    JobRunner& jobs() const { return m_jobs; }
    const States& states() const { return m_states; }
    /// Null where there is none of this name. Good until it is forgotten.
    ResultState* find(const QString& name) const;
    /// \param State  what the derived class made by `make`.
    template <typename State>
    State* find(const QString& name) const
    {
        return static_cast<State*>(find(name));
    }
    /// The one of this name, made if there is none yet.
    template <typename State>
    State& make(const QString& name)
    {
        std::unique_ptr<ResultState>& state = m_states[name];
        if (state == nullptr)
            state = std::make_unique<State>();
        return static_cast<State&>(*state);
    }
    /// Lets go of those for which `isGone` holds, and of the work on them.
    void forget(const std::function<bool(const QString&, const ResultState&)>& isGone);

    /// Nothing that is under way for it counts any more, and it has no error.
    void end(ResultState& state);
    /// Starts work in place of what is under way. \param work  `Result work(const Progress&, const Post&)`,
    /// on a thread of its own. \param done  `void done(const QString& name, Result)`, without a result where
    /// work has none; not where it failed, was stopped or replaced. `changed` is told after it.
    template <typename Work, typename Done>
    void start(const QString& name, ResultState& state, const Shown& shown, Work work, Done done);

    /// After the delay, counted from the last call.
    void updateSoon() { m_delay.start(); }
    bool isUpdateDue() const { return m_delay.isActive(); }
    /// At once, instead of what is due.
    void updateNow();

private:
    void rename(const ChangeEvent& event);
    void take(const ChangeEvent& event);
    /// Null where nobody works under this number any more.
    States::value_type* ofRun(int run);
    JobSettings settingsOf(int run, const Shown& shown);
    void setJob(const QString& name, ResultState& state, Job* job);

    ProjectDocument& m_document;
    JobRunner& m_jobs;
    std::optional<Section> m_section;
    QTimer m_delay; ///< edits follow each other quickly
    States m_states;
    QStringList m_wanted;
    int m_runs = 0;
    Mailbox m_mailbox{this};
};

template <typename Work, typename Done>
void WantedResults::start(const QString& name, ResultState& state, const Shown& shown, Work work, Done done)
{
    end(state);
    const int run = state.run;
    auto posting = [work = std::move(work), post = Post(*this, run)](const Progress& progress) mutable {
        return work(progress, post);
    };
    // Nobody hears of a result that is not the latest (settingsOf).
    auto tell = [this, run, done = std::move(done)](auto&&... result) mutable {
        const QString current = ofRun(run)->first;
        done(current, std::forward<decltype(result)>(result)...);
        emit changed(current);
    };
    setJob(name, state, m_jobs.start(settingsOf(run, shown), std::move(posting), std::move(tell)));
}

} // namespace quadrille
