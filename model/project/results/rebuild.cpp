// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/results/rebuild.h"

#include "model/core/caughterror.h"
#include "model/core/mediacache.h"
#include "model/core/message.h"
#include "model/project/document/paths.h"
#include "model/project/exports/exportsteps.h"
#include "model/project/media/media.h"
#include "model/project/media/projectguard.h"
#include "model/project/results/makesteps.h"
#include "model/project/results/stepstate.h"
#include "model/project/store/resultplaces.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <utility>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

Issue unstoredIssue(const fs::path& file)
{
    Issue issue;
    issue.context.file = file;
    issue.context.values = {{"text", QUADRILLE_MESSAGE("This result cannot be stored anywhere and is kept in "
                                                       "memory, until the program ends. Free some space, or "
                                                       "choose another folder for results.")}};
    return issue;
}

/// Runs the stale ones of some steps, each as soon as its inputs are there.
class Rebuilder
{
public:
    Rebuilder(const std::vector<BuildStep>& steps, const fs::path& projectFile, const RebuildOptions& options,
              const Progress& progress, const StepListener& listener)
        : m_steps(steps)
        , m_projectFile(projectFile)
        , m_folder(projectFolder(projectFile))
        , m_session(options.session ? options.session : std::make_shared<ResultSession>())
        , m_store(cacheFolder(projectFile), m_session->results())
        , m_hashes(m_session->hashes(cacheFolder(projectFile)))
        , m_options(options)
        , m_progress(progress)
        , m_listener(listener)
        , m_reports(steps.size())
        , m_waiting(steps.size())
        , m_fractions(steps.size())
        , m_users(steps.size())
        , m_given(steps.size())
    {
        for (std::size_t i = 0; i < steps.size(); ++i)
            m_byName[steps[i].name] = i;
    }

    RebuildReport run()
    {
        m_status = stepStatus(m_steps, m_store, m_folder, m_hashes, m_progress.part(0, planning));
        for (std::size_t i = 0; i < m_steps.size(); ++i)
            plan(i);
        if (!m_options.dryRun && !m_options.onlyInMemory && isAnyStale())
            prepare();
        if (!m_options.dryRun)
            compute();
        if (!m_options.dryRun)
            m_hashes.save();
        m_progress.report(1);
        return {std::move(m_reports)};
    }

private:
    /// The part of the progress that finding out what is stale takes.
    static constexpr double planning = 0.1;

    bool isAnyStale() const
    {
        return std::any_of(m_reports.begin(), m_reports.end(),
                           [](const StepReport& report) { return report.state == StepState::Stale; });
    }

    /// Before minutes of computing: can what comes of it be stored?
    void prepare()
    {
        storeUnstoredResults();
        constexpr std::uint64_t least = std::uint64_t{32} << 20;
        std::uint64_t bytes = least;
        for (std::size_t i = 0; i < m_steps.size(); ++i) {
            if (m_reports[i].state == StepState::Stale)
                bytes += expectedBytes(m_steps[i]);
        }
        prepareResults(m_projectFile, bytes);
        m_store = ResultStore(cacheFolder(m_projectFile), m_session->results());
    }

    /// What the step says, or what its last result took.
    std::uint64_t expectedBytes(const BuildStep& step) const
    {
        std::error_code error;
        const auto before = fs::file_size(m_store.fileOf(step.name), error);
        const std::uint64_t known = error ? 0 : before;
        return step.bytes ? std::max(known, step.bytes(Progress(m_progress.token()))) : known;
    }

    void plan(std::size_t i)
    {
        StepReport& report = m_reports[i];
        StepStatus& status = m_status[i];
        report.step = m_steps[i].name;
        report.key = status.key;
        report.error = status.error;
        if (status.isDamaged) {
            Issue damaged;
            damaged.context.file = m_store.fileOf(report.step);
            damaged.context.values = {{"text", std::string(errorMessage(ErrorCode::ResultDamaged).sentence) +
                                                   " " + errorMessage(ErrorCode::ResultDamaged).remedy}};
            report.issues.push_back(std::move(damaged));
        }
        if (status.error) {
            report.state = StepState::Failed;
        } else if (status.isFresh && !m_options.force) {
            report.state = StepState::Fresh;
            addFiles(report, status.files);
            if (!m_options.dryRun)
                m_store.prefer(report.step, report.key);
        } else if (const auto kept = keptResult(i); kept && !m_options.force) {
            // Others, who do not share the session, find it then, too.
            report.state = StepState::Fresh;
            if (!m_options.onlyInMemory)
                store(report, kept);
        } else {
            report.state = StepState::Stale;
            report.reason = status.isFresh ? "forced" : status.reason;
        }
    }

    const std::string& kindOf(std::size_t i) const
    {
        return m_steps[i].kind.empty() ? m_steps[i].name : m_steps[i].kind;
    }

    /// A result that was computed for another state of the project, or another entry; null where there is
    /// none. Files outside of the store are written when they are asked for.
    ResultPointer keptResult(std::size_t i) const
    {
        const ResultPointer kept = m_session->results()->find(kindOf(i), m_status[i].key);
        return kept && kept->files.empty() ? kept : nullptr;
    }

    ResultPointer resultOf(std::size_t i)
    {
        if (ResultPointer kept = m_session->results()->find(kindOf(i), m_status[i].key))
            return kept;
        ResultPointer stored = m_store.freshResult(m_steps[i].name, m_status[i].key);
        m_session->results()->keep(kindOf(i), m_status[i].key, stored);
        return stored;
    }

    void store(StepReport& report, const ResultPointer& result)
    {
        if (!m_store.save(report.step, report.key, result))
            report.issues.push_back(unstoredIssue(m_store.fileOf(report.step)));
    }

    void compute()
    {
        const int jobs = m_options.jobs > 0 ? m_options.jobs : tbb::info::default_concurrency();
        tbb::task_arena arena(jobs);
        for (std::size_t i = 0; i < m_steps.size(); ++i) {
            m_waiting[i] += m_steps[i].inputs.size();
            for (const std::string& input : m_steps[i].inputs)
                m_users[m_byName.at(input)].push_back(i);
            for (const std::string& other : m_steps[i].along) {
                if (m_reports[i].state == StepState::Stale && isStale(other)) {
                    ++m_waiting[m_byName.at(other)];
                    m_users[i].push_back(m_byName.at(other));
                }
            }
        }
        std::vector<std::size_t> first; // before any is begun that starts others
        for (std::size_t i = 0; i < m_steps.size(); ++i) {
            if (m_waiting[i] == 0)
                first.push_back(i);
        }
        arena.execute([&] {
            std::ranges::for_each(first, [this](std::size_t i) { start(i); });
            m_tasks.wait();
        });
        // A step that was cancelled is not one that failed.
        m_progress.report(planning);
    }

    /// \return false where the step is none of those of this rebuild.
    bool isStale(const std::string& step) const
    {
        const auto found = m_byName.find(step);
        return found != m_byName.end() && m_reports[found->second].state == StepState::Stale;
    }

    void start(std::size_t i)
    {
        m_tasks.run([this, i] {
            runStep(i);
            for (const std::size_t user : m_users[i]) {
                if (--m_waiting[user] == 0)
                    start(user);
            }
        });
    }

    void runStep(std::size_t i)
    {
        StepReport& report = m_reports[i];
        if (m_progress.isCancelled())
            return;
        if (report.state == StepState::Stale && inputFailed(i))
            report.state = StepState::Skipped;
        if (report.state == StepState::Stale)
            computeStep(i);
        m_fractions[i] = 1;
        if (m_progress.isCancelled())
            return;
        const std::scoped_lock lock(m_listenerMutex);
        if (m_listener)
            m_listener(report);
    }

    bool inputFailed(std::size_t i) const
    {
        const auto& inputs = m_steps[i].inputs;
        return std::any_of(inputs.begin(), inputs.end(), [this](const std::string& input) {
            const StepState state = m_reports[m_byName.at(input)].state;
            return state == StepState::Failed || state == StepState::Skipped;
        });
    }

    void computeStep(std::size_t i)
    {
        StepReport& report = m_reports[i];
        const auto begin = std::chrono::steady_clock::now();
        StepContext context;
        context.session = m_session;
        context.resultOf = [this](const std::string& step) { return resultOf(m_byName.at(step)); };
        context.keyOf = [this](const std::string& step) { return m_status[m_byName.at(step)].key; };
        if (m_options.improved)
            context.improved = [this, &report](const Result& result) {
                m_options.improved(report.step, result);
            };
        context.isWanted = [this](const std::string& step) { return isStale(step); };
        context.give = [this](const std::string& step, Result result) {
            m_given[m_byName.at(step)] = std::make_shared<const Result>(std::move(result));
        };
        context.tell = [&report](Issue issue) { report.issues.push_back(std::move(issue)); };
        const Progress own(m_progress.token(), [this, i](double fraction) {
            m_fractions[i] = fraction;
            reportOverall();
        });
        try {
            const ResultPointer given = std::exchange(m_given[i], nullptr);
            const ResultPointer result =
                given ? given : std::make_shared<const Result>(m_steps[i].compute(context, own));
            own.report(1);
            m_session->countComputed(report.step);
            m_session->results()->keep(kindOf(i), report.key, result);
            if (!m_options.onlyInMemory)
                store(report, result);
            addFiles(report, result->files);
            report.state = StepState::Computed;
        } catch (...) {
            report.state = StepState::Failed;
            report.error = caughtError();
        }
        report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    void reportOverall() const
    {
        double sum = 0;
        for (const std::atomic<double>& fraction : m_fractions)
            sum += fraction;
        m_progress.report(planning + (1 - planning) * sum / static_cast<double>(m_steps.size()));
    }

    void addFiles(StepReport& report, const std::vector<WrittenFile>& files) const
    {
        for (const WrittenFile& file : files)
            report.files.push_back(resolvePath(file.path, m_folder));
    }

    const std::vector<BuildStep>& m_steps;
    fs::path m_projectFile;
    fs::path m_folder;
    std::shared_ptr<ResultSession> m_session;
    ResultStore m_store;
    FileHashes& m_hashes;
    const RebuildOptions& m_options;
    const Progress& m_progress;
    const StepListener& m_listener;
    std::vector<StepReport> m_reports;
    std::vector<StepStatus> m_status;
    std::map<std::string, std::size_t> m_byName;
    std::vector<std::atomic<std::size_t>> m_waiting;
    std::vector<std::atomic<double>> m_fractions;
    std::vector<std::vector<std::size_t>> m_users; ///< steps that use one's result
    std::vector<ResultPointer> m_given;            ///< by other steps, until they are stored
    std::mutex m_listenerMutex;
    tbb::task_group m_tasks;
};

/// Where moved media are looked for is all that is lost when they cannot be noted.
void tryToNoteMedia(const Project& project, const fs::path& projectFile, const Progress& progress)
{
    try {
        noteMedia(project, projectFile, progress);
    } catch (const Error& error) {
        if (error.code() == ErrorCode::Cancelled)
            throw;
    }
}

} // namespace

RebuildReport rebuild(const std::vector<BuildStep>& steps, const fs::path& projectFile,
                      const RebuildOptions& options, const Progress& progress, const StepListener& listener)
{
    const auto selected = selectSteps(steps, options.targets);
    if (!options.dryRun)
        checkResultsPlace(projectFile, options.permissions);
    return Rebuilder(selected, projectFile, options, progress, listener).run();
}

RebuildReport rebuild(const Project& project, const fs::path& projectFile, const RebuildOptions& options,
                      const Progress& progress, const StepListener& listener)
{
    MediaCache::shared()->setBudget(project.settings.cacheBytes());
    const fs::path folder = projectFolder(projectFile);
    RebuildOptions shared = options;
    if (shared.session == nullptr)
        shared.session = std::make_shared<ResultSession>();
    const auto opener = std::make_shared<SequenceOpener>(project, folder, cacheFolder(projectFile),
                                                         shared.session->sources());
    const auto guard = projectGuard(project, projectFile, options.permissions);
    const WrittenNote note(*guard, projectFile);
    std::vector<BuildStep> steps = makeSteps({opener, projectFile, shared.session});
    std::vector<BuildStep> guarded = exportSteps(opener, guard);
    for (BuildStep& step : guarded) {
        *std::find_if(steps.begin(), steps.end(),
                      [&](const BuildStep& made) { return made.name == step.name; }) = std::move(step);
    }
    refuseMissingInputs(steps);
    RebuildReport report = rebuild(steps, projectFile, shared, progress, listener);
    if (!options.dryRun)
        tryToNoteMedia(project, projectFile, Progress(progress.token()));
    return report;
}

} // namespace quadrille
