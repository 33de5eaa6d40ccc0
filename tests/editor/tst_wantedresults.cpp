// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/projectedits.h"
#include "editor/documents/wantedresults.h"
#include "editortest.h"
#include "tests/qt/registry.h"

#include <QSignalSpy>
#include <atomic>
#include <thread>

namespace quadrille {

namespace {

/// Results of sequences: the text that the work for each of them is told to bring.
class Texts : public WantedResults
{
public:
    struct State : ResultState
    {
        QString text;
        QStringList posted;
    };
    using WantedResults::forget;

    Texts(ProjectDocument& document, JobRunner& jobs)
        : WantedResults(document, jobs, Section::Sequences, std::chrono::milliseconds(1), nullptr)
    {
    }

    const State* stateOf(const QString& name) const { return find<const State>(name); }

    /// \param work  `QString work(const Progress&, post)`, post takes a text.
    template <typename Work>
    void seek(const QString& name, Work work)
    {
        auto& state = make<State>(name);
        state.phase = ResultPhase::Computing;
        start(
            name, state, {.text = name},
            [work](const Progress& progress, const Post& post) {
                return work(progress, [&post](const QString& text) {
                    post([text](const QString& current, ResultState& known) {
                        static_cast<State&>(known).posted += current + ": " + text;
                    });
                });
            },
            [this](const QString& current, const QString& text) {
                auto& done = *find<State>(current);
                done.text = text;
                done.phase = ResultPhase::Ready;
            });
    }

    int updates = 0;

private:
    void update() override { ++updates; }
};

/// Work goes on until this is opened.
struct Gate
{
    std::shared_ptr<std::atomic<bool>> isOpen = std::make_shared<std::atomic<bool>>(false);

    void wait(const Progress& progress) const
    {
        while (!*isOpen) {
            progress.report(0.5);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
};

} // namespace

class WantedResultsTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        Project project;
        project.sequences.resize(2);
        project.sequences[0].name = "walk";
        project.sequences[1].name = "run";
        m_document = std::make_unique<ProjectDocument>();
        m_document->reset(project);
        m_jobs = std::make_unique<JobRunner>();
        m_texts = std::make_unique<Texts>(*m_document, *m_jobs);
    }
    void cleanup()
    {
        m_texts.reset();
        m_jobs.reset();
        m_document.reset();
    }

    void tellsWhatComesBeforeTheEndAndTheEnd()
    {
        const QSignalSpy changed(m_texts.get(), &WantedResults::changed);
        const Gate gate;
        m_texts->seek("walk", [gate](const Progress& progress, const auto& post) {
            post("half");
            gate.wait(progress);
            return QString("whole");
        });
        QCOMPARE(state("walk").phase, ResultPhase::Computing);
        QVERIFY(state("walk").job);
        QTRY_COMPARE(state("walk").posted, QStringList("walk: half"));
        QCOMPARE(changed.size(), 2); // begun, and half of it
        *gate.isOpen = true;
        QTRY_COMPARE(state("walk").phase, ResultPhase::Ready);
        QCOMPARE(state("walk").text, "whole");
        QCOMPARE(changed.size(), 3);
        QVERIFY(m_texts->stateOf("run") == nullptr);
    }

    void onlyTheLatestWorkCounts()
    {
        const Gate gate;
        m_texts->seek("walk", [gate](const Progress& progress, const auto& post) {
            while (!*gate.isOpen)
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            post("late");
            progress.report(0.9);
            return QString("first");
        });
        m_texts->seek("walk", [](const Progress&, const auto&) { return QString("second"); });
        QTRY_COMPARE(state("walk").text, "second");
        *gate.isOpen = true;
        QTRY_VERIFY(m_jobs->jobs().empty());
        QCoreApplication::processEvents();
        QCOMPARE(state("walk").text, "second");
        QVERIFY(state("walk").posted.isEmpty());
    }

    void workFollowsTheNameOfItsResult()
    {
        const Gate gate;
        m_texts->seek("walk", [gate](const Progress& progress, const auto& post) {
            gate.wait(progress);
            post("half");
            return QString("whole");
        });
        QVERIFY(renameEntry(*m_document, {Section::Sequences, "walk"}, "stroll"));
        QVERIFY(m_texts->stateOf("walk") == nullptr);
        *gate.isOpen = true;
        QTRY_COMPARE(state("stroll").phase, ResultPhase::Ready);
        QCOMPARE(state("stroll").text, "whole");
        QCOMPARE(state("stroll").posted, QStringList("stroll: half"));
    }

    void stopsAtOnceAndHearsNothingMore()
    {
        m_texts->seek("walk", [](const Progress& progress, const auto& post) {
            Gate().wait(progress);
            post("never");
            return QString("never");
        });
        m_texts->stop("walk");
        QCOMPARE(state("walk").phase, ResultPhase::Idle);
        QVERIFY(!state("walk").job);
        QTRY_VERIFY(m_jobs->jobs().empty());
        QVERIFY(state("walk").text.isEmpty());
        QVERIFY(state("walk").posted.isEmpty());
        m_texts->stop("walk"); // nothing to stop
        m_texts->stop("run");
    }

    void isIdleWhenItsJobIsCancelledElsewhere()
    {
        m_texts->seek("walk", [](const Progress& progress, const auto&) {
            Gate().wait(progress);
            return QString();
        });
        m_jobs->cancelAll();
        QTRY_COMPARE(state("walk").phase, ResultPhase::Idle);
        QVERIFY(!state("walk").job);
    }

    void keepsTheErrorUntilTheNextWork()
    {
        const auto fail = [](const Progress&, const auto&) -> QString { throw Error(ErrorCode::NoFeet); };
        m_texts->seek("walk", fail);
        QTRY_COMPARE(state("walk").phase, ResultPhase::Failed);
        QCOMPARE(state("walk").error->code(), ErrorCode::NoFeet);
        m_texts->seek("walk", [](const Progress&, const auto&) { return QString("well"); });
        QVERIFY(!state("walk").error);
        QTRY_COMPARE(state("walk").text, "well");
    }

    void letsGoOfWhatIsForgotten()
    {
        const Gate gate;
        for (const char* name : {"walk", "run"}) {
            m_texts->seek(name, [gate](const Progress& progress, const auto& post) {
                gate.wait(progress);
                post("half");
                return QString("whole");
            });
        }
        const QSignalSpy changed(m_texts.get(), &WantedResults::changed);
        m_texts->forget([](const QString& name, const ResultState&) { return name == "walk"; });
        QVERIFY(m_texts->stateOf("walk") == nullptr);
        QCOMPARE(changed.size(), 1);
        *gate.isOpen = true;
        QTRY_COMPARE(state("run").text, "whole");
        QVERIFY(m_texts->stateOf("walk") == nullptr);
    }

    void goesWhileWorkIsUnderWay()
    {
        const Gate gate;
        auto posts = std::make_shared<std::atomic<int>>(0);
        m_texts->seek("walk", [gate, posts](const Progress&, const auto& post) {
            while (!*gate.isOpen)
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            post("to nobody");
            ++*posts;
            return QString("for nobody");
        });
        QTRY_VERIFY(!m_jobs->jobs().empty() && m_jobs->jobs().front()->state() == Job::State::Running);
        m_texts.reset();
        *gate.isOpen = true;
        QTRY_VERIFY(m_jobs->jobs().empty());
        QCOMPARE(*posts, 1);
    }

    void editsThatFollowEachOtherAreOneUpdate()
    {
        const int before = m_texts->updates;
        QVERIFY(renameEntry(*m_document, {Section::Sequences, "walk"}, "stroll"));
        QVERIFY(renameEntry(*m_document, {Section::Sequences, "run"}, "sprint"));
        QCOMPARE(m_texts->updates, before);
        QTRY_COMPARE(m_texts->updates, before + 1);
    }

private:
    const Texts::State& state(const char* name) const { return *m_texts->stateOf(name); }

    std::unique_ptr<ProjectDocument> m_document;
    std::unique_ptr<JobRunner> m_jobs;
    std::unique_ptr<Texts> m_texts;
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::WantedResultsTest);
#include "tst_wantedresults.moc"
