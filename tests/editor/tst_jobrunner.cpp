// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/jobs/joblistmodel.h"
#include "editor/jobs/jobrunner.h"
#include "editor/jobs/mailbox.h"
#include "tests/qt/registry.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

using namespace quadrille;

namespace {

/// Work that reports every ten milliseconds until it is cancelled; far longer than any test waits.
struct Endless
{
    std::shared_ptr<std::atomic<int>> steps = std::make_shared<std::atomic<int>>(0);
    static constexpr int stepMs = 10;
    static constexpr int stepCount = 60'000;

    int operator()(const Progress& progress) const
    {
        for (int step = 0; step < stepCount; ++step) {
            progress.report(step, stepCount);
            ++*steps;
            std::this_thread::sleep_for(std::chrono::milliseconds(stepMs));
        }
        return stepCount;
    }
    bool hasStarted() const { return *steps > 0; }
};

void ignoreResult(int) {}

} // namespace

class JobRunnerTest : public QObject
{
    Q_OBJECT
private slots:
    void resultArrivesOnTheInterfaceThread();
    void workRunsOnAnotherThread();
    void whatTheWorkPostsComesBeforeItsEnd();
    void errorIsDeliveredAsData();
    void errorWithoutHandlerIsSignalled();
    void foreignExceptionBecomesAnError();
    void cancellingStopsTheWorkAndShowsNoError();
    void cancellingTakesEffectWithin200Milliseconds();
    void jobCanBeCancelledFromAnyThread();
    void waitingJobIsCancelledWithoutAThread();
    void resultThatCameAfterCancellingIsDropped();
    void resultIsDroppedWhenSettingsNoLongerStand();
    void errorIsDroppedWhenSettingsNoLongerStand();
    void jobIsCancelledWhenItsReceiverGoes();
    void endedJobGoesWithItsRunner();
    void progressIsThrottledAndNeverGoesBack();
    void runnerIsDestroyedWhileJobsRun();
    void snapshotIsReleasedWhenTheWorkIsDone();
    void jobsRunInParallel();
    void modelListsRunningJobs();
    void timeLeftIsRounded();
};

void JobRunnerTest::resultArrivesOnTheInterfaceThread()
{
    JobRunner runner;
    int result = 0;
    QThread* where = nullptr;
    QPointer<Job> job = runner.start(
        {.name = "Sum"}, [](const Progress&) { return 42; },
        [&](int value) {
            result = value;
            where = QThread::currentThread();
        });
    QCOMPARE(job->name(), QString("Sum"));
    QCOMPARE(result, 0);
    QTRY_COMPARE(result, 42);
    QCOMPARE(where, QThread::currentThread());
    QTRY_VERIFY(job.isNull());
    QVERIFY(runner.jobs().empty());
}

// Even where all is over before the interface looks at what the work told first.
void JobRunnerTest::whatTheWorkPostsComesBeforeItsEnd()
{
    JobRunner runner;
    const Mailbox mailbox(this);
    QStringList told;
    std::atomic<bool> hasPosted = false;
    runner.start(
        {},
        [&](const Progress& progress) {
            progress.report(0.5);
            mailbox.address().post([&told] { told += "posted"; });
            hasPosted = true;
        },
        [&told] { told += "end"; });
    while (!hasPosted)
        std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    QTRY_COMPARE(told.size(), 2);
    QCOMPARE(told, QStringList({"posted", "end"}));
}

void JobRunnerTest::workRunsOnAnotherThread()
{
    JobRunner runner;
    std::thread::id worker;
    bool done = false;
    runner.start(
        {}, [](const Progress&) { return std::this_thread::get_id(); },
        [&](std::thread::id id) {
            worker = id;
            done = true;
        });
    QTRY_VERIFY(done);
    QVERIFY(worker != std::this_thread::get_id());
}

void JobRunnerTest::errorIsDeliveredAsData()
{
    JobRunner runner;
    std::optional<Error> seen;
    bool done = false;
    runner.start(
        {.failed = [&](const Error& error) { seen = error; }},
        [](const Progress&) -> int {
            throw Error(ErrorCode::FileEmpty, {.file = "a.obj", .place = {.line = 3}});
        },
        [&](int) { done = true; });
    QTRY_VERIFY(seen.has_value());
    QCOMPARE(seen->code(), ErrorCode::FileEmpty);
    QCOMPARE(seen->context().file, std::filesystem::path("a.obj"));
    QCOMPARE(seen->context().place.line.value(), 3);
    QVERIFY(!done);
}

void JobRunnerTest::errorWithoutHandlerIsSignalled()
{
    JobRunner runner;
    ErrorCode code = ErrorCode::Cancelled;
    connect(&runner, &JobRunner::failed, this, [&](Job*, const Error& error) { code = error.code(); });
    runner.start(
        {}, [](const Progress&) { throw Error(ErrorCode::NoFaces); }, [] {});
    QTRY_COMPARE(code, ErrorCode::NoFaces);
}

void JobRunnerTest::foreignExceptionBecomesAnError()
{
    JobRunner runner;
    std::optional<Error> seen;
    runner.start(
        {.failed = [&](const Error& error) { seen = error; }},
        [](const Progress&) { throw std::runtime_error("beyond us"); }, [] {});
    QTRY_VERIFY(seen.has_value());
    QCOMPARE(seen->code(), ErrorCode::Unexpected);
    QVERIFY(QString(seen->what()).contains("beyond us"));
}

void JobRunnerTest::cancellingStopsTheWorkAndShowsNoError()
{
    JobRunner runner;
    const Endless work;
    bool failed = false;
    bool done = false;
    Job* job =
        runner.start({.failed = [&](const Error&) { failed = true; }}, work, [&](int) { done = true; });
    QSignalSpy ended(job, &Job::ended);
    QTRY_VERIFY(work.hasStarted());
    job->cancel();
    QTRY_COMPARE(ended.count(), 1);
    QCOMPARE(ended.at(0).at(0).value<Job::State>(), Job::State::Cancelled);
    QVERIFY(!failed);
    QVERIFY(!done);
    QVERIFY(*work.steps < Endless::stepCount);
}

void JobRunnerTest::cancellingTakesEffectWithin200Milliseconds()
{
    // Counted in the work's own steps of at least ten milliseconds, so that a slow machine cannot fail it.
    JobRunner runner;
    const Endless work;
    Job* job = runner.start({}, work, ignoreResult);
    QTRY_VERIFY(work.hasStarted());
    job->cancel();
    const int atCancel = *work.steps;
    QTRY_VERIFY(runner.jobs().empty());
    QVERIFY(*work.steps - atCancel <= 200 / Endless::stepMs);
}

void JobRunnerTest::jobCanBeCancelledFromAnyThread()
{
    JobRunner runner;
    const Endless byJob;
    const Endless byToken;
    Job* first = runner.start({}, byJob, ignoreResult);
    CancelToken token = runner.start({}, byToken, ignoreResult)->token();
    QTRY_VERIFY(byJob.hasStarted() && byToken.hasStarted());
    std::thread other([first, token]() mutable {
        first->cancel();
        token.cancel();
    });
    other.join();
    QTRY_VERIFY(runner.jobs().empty());
}

void JobRunnerTest::waitingJobIsCancelledWithoutAThread()
{
    JobRunner runner(nullptr, 1);
    const Endless busy;
    const Endless waiting;
    runner.start({}, busy, ignoreResult);
    QPointer<Job> job = runner.start({}, waiting, ignoreResult);
    QTRY_VERIFY(busy.hasStarted());
    QCOMPARE(job->state(), Job::State::Waiting);
    job->cancel();
    QTRY_VERIFY(job.isNull());
    QCOMPARE(*waiting.steps, 0);
    QCOMPARE(runner.jobs().size(), std::size_t{1});
}

void JobRunnerTest::resultThatCameAfterCancellingIsDropped()
{
    JobRunner runner;
    std::atomic<bool> computed = false;
    bool done = false;
    Job* job = runner.start(
        {}, [&](const Progress&) { computed = true; }, [&] { done = true; });
    while (!computed)
        std::this_thread::yield();
    QSignalSpy ended(job, &Job::ended);
    job->cancel();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(!done);
}

void JobRunnerTest::resultIsDroppedWhenSettingsNoLongerStand()
{
    JobRunner runner;
    int settings = 1;
    bool done = false;
    Job* job = runner.start(
        {.stillStands = [&settings, taken = settings] { return settings == taken; }},
        [](const Progress&) { return 1; }, [&](int) { done = true; });
    QSignalSpy ended(job, &Job::ended);
    settings = 2;
    QTRY_COMPARE(ended.count(), 1);
    QCOMPARE(ended.at(0).at(0).value<Job::State>(), Job::State::Outdated);
    QVERIFY(!done);
}

void JobRunnerTest::errorIsDroppedWhenSettingsNoLongerStand()
{
    JobRunner runner;
    bool failed = false;
    Job* job = runner.start(
        {.stillStands = [] { return false; }, .failed = [&](const Error&) { failed = true; }},
        [](const Progress&) { throw Error(ErrorCode::NoFaces); }, [] {});
    QSignalSpy ended(job, &Job::ended);
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(!failed);
}

void JobRunnerTest::jobIsCancelledWhenItsReceiverGoes()
{
    JobRunner runner;
    const Endless work;
    auto receiver = std::make_unique<QObject>();
    runner.start({.receiver = receiver.get()}, work, ignoreResult);
    QTRY_VERIFY(work.hasStarted());
    receiver.reset();
    QTRY_VERIFY(runner.jobs().empty());
}

void JobRunnerTest::endedJobGoesWithItsRunner()
{
    QObject receiver; // outlives the runner, as the widgets of a window do
    auto runner = std::make_unique<JobRunner>();
    bool done = false;
    const QPointer<Job> job = runner->start(
        {.receiver = &receiver}, [](const Progress&) { return 1; }, [&](int) { done = true; });
    while (!done)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    QVERIFY(!job.isNull()); // over, and waiting for its deletion
    runner.reset();
    QVERIFY(job.isNull());
}

void JobRunnerTest::progressIsThrottledAndNeverGoesBack()
{
    JobRunner runner;
    constexpr int reports = 100'000;
    std::vector<double> seen;
    bool done = false;
    Job* job = runner.start(
        {},
        [](const Progress& progress) {
            for (int i = 1; i <= reports; ++i)
                progress.report(i, reports);
            std::this_thread::sleep_for(std::chrono::milliseconds(60));
            progress.report(1.0);
        },
        [&] { done = true; });
    connect(job, &Job::changed, this, [&] { seen.push_back(job->fraction()); });
    QTRY_VERIFY(done);
    QVERIFY(seen.size() < reports / 100);
    QVERIFY(std::is_sorted(seen.begin(), seen.end()));
    QCOMPARE(seen.back(), 1.0);
}

void JobRunnerTest::runnerIsDestroyedWhileJobsRun()
{
    bool done = false;
    QPointer<Job> job;
    const Endless work;
    {
        JobRunner runner(nullptr, 2);
        job = runner.start({}, work, [&](int) { done = true; });
        runner.start({}, Endless(), [&](int) { done = true; });
        runner.start({}, Endless(), [&](int) { done = true; });
        QTRY_VERIFY(work.hasStarted());
    }
    QVERIFY(job.isNull());
    QCoreApplication::processEvents();
    QVERIFY(!done);
}

void JobRunnerTest::snapshotIsReleasedWhenTheWorkIsDone()
{
    JobRunner runner;
    auto snapshot = std::make_shared<int>(7);
    const std::weak_ptr<int> watch = snapshot;
    bool released = false;
    runner.start(
        {}, [snapshot = std::move(snapshot)](const Progress&) { return *snapshot; },
        [&](int value) { released = value == 7 && watch.expired(); });
    QTRY_VERIFY(released);
}

void JobRunnerTest::jobsRunInParallel()
{
    JobRunner runner(nullptr, 2);
    // Each waits for the other: one after the other they would never end.
    auto meeting = std::make_shared<std::atomic<int>>(0);
    const auto work = [meeting](const Progress& progress) {
        ++*meeting;
        while (*meeting < 2)
            progress.report(0.5);
    };
    int done = 0;
    runner.start({}, work, [&] { ++done; });
    runner.start({}, work, [&] { ++done; });
    QTRY_COMPARE(done, 2);
}

void JobRunnerTest::modelListsRunningJobs()
{
    JobRunner runner;
    JobListModel model(runner);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const Endless work;
    runner.start({.name = "Thumbnail", .background = true}, Endless(), ignoreResult);
    runner.start({.name = "Export"}, work, ignoreResult);
    QCOMPARE(model.rowCount(), 1);
    const QModelIndex row = model.index(0);
    QCOMPARE(row.data().toString(), QString("Export"));
    QTRY_COMPARE(row.data(JobListModel::StateRole).value<Job::State>(), Job::State::Running);
    QTRY_VERIFY(row.data(JobListModel::FractionRole).toDouble() > 0);
    model.cancel(row);
    QTRY_COMPARE(model.rowCount(), 0);
    QCOMPARE(runner.jobs().size(), std::size_t{1});
}

void JobRunnerTest::timeLeftIsRounded()
{
    QCOMPARE(timeLeftText({0.2}), QString("less than a second left"));
    QVERIFY(timeLeftText({11.3}).startsWith("12 "));
    QVERIFY(timeLeftText({61}).startsWith("2 "));
}

QUADRILLE_QT_TEST_IN(QCoreApplication, JobRunnerTest);
#include "tst_jobrunner.moc"
