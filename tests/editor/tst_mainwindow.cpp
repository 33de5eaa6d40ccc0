// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/projectpaths.h"
#include "editor/playback/clipscene.h"
#include "editor/playback/player.h"
#include "editor/welcome/sampleflow.h"
#include "editor/welcome/welcomepage.h"
#include "editor/welcome/welcometile.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "model/project/file/projectfile.h"
#include "model/project/results/rebuild.h"
#include "model/sample/sample.h"
#include "tests/qt/registry.h"

#include <QStandardPaths>
#include <future>
#include <utility>

namespace quadrille {

class MainWindowTest : public QObject
{
    Q_OBJECT

private:
    static std::filesystem::path sampleFolder()
    {
        return toPath(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/sample");
    }
    /// Once, puts a small sample where the window makes its own: where that leads does not depend on its
    /// size.
    void makeSampleSmall()
    {
        if (std::exchange(m_isSampleSmall, true))
            return;
        std::filesystem::remove_all(sampleFolder());
        writeSample(sampleFolder(), {.textureSize = 64, .takesPerKind = 1});
    }

    std::unique_ptr<MainWindow> m_window;
    bool m_isSampleSmall = false;

private slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() { m_window.reset(); }
    void cleanupTestCase()
    {
        QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).removeRecursively();
    }

    void aTileShowsHowFarTheSampleIsAndTakesItsClickBack()
    {
        // The sample is made too quickly to be stopped for certain: it waits behind other work.
        JobRunner& jobs = m_window->context().jobs;
        std::promise<void> open;
        const std::shared_future<void> gate(open.get_future());
        const int threads = 8; // at most
        for (int i = 0; i < threads; ++i)
            jobs.start(
                {.name = "gate"}, [gate](const Progress&) { gate.wait(); }, [] {});
        auto* play = test::find<WelcomeTile>("welcome.play");
        auto* path = test::find<WelcomeTile>("welcome.path");
        QTest::mouseClick(play, Qt::LeftButton);
        QVERIFY(play->isInProgress());
        QVERIFY(!path->isEnabled());
        QCOMPARE(jobs.jobs().size(), std::size_t{threads + 1});
        m_window->findChild<WelcomePage*>()->showSampleProgress(SampleGoal::Play, 0.4);
        QCOMPARE(play->fraction(), 0.4);
        QTest::mouseClick(play, Qt::LeftButton);
        QTRY_VERIFY(!play->isInProgress());
        QVERIFY(path->isEnabled());
        QCOMPARE(jobs.jobs().size(), std::size_t{threads});
        open.set_value();
        QTRY_VERIFY(jobs.jobs().empty());
        QVERIFY(m_window->context().document.isUntitled());
    }

    void whoOpensSomethingElseDoesNotGetTheSample()
    {
        auto* play = test::find<WelcomeTile>("welcome.play");
        QTest::mouseClick(play, Qt::LeftButton);
        Project other;
        other.sequences = {{.name = "other", .source = "/nowhere/other.pc2"}};
        m_window->context().document.reset(other);
        QTRY_VERIFY(!play->isInProgress());
        QTRY_VERIFY(m_window->context().jobs.jobs().empty());
        QCOMPARE(m_window->context().document.project().sequences.front().name, std::string("other"));
    }

    void theSampleOpensPlaying()
    {
        m_window->openSample();
        const EditorContext& context = m_window->context();
        QTRY_VERIFY(!context.document.project().sequences.empty());
        const QString first = QString::fromStdString(context.document.project().sequences.front().name);
        QCOMPARE(context.selection.shownSequence(), first);
        QVERIFY(test::waitForSequence(*m_window, first));
        for (const SequenceEntry& entry : context.document.project().sequences) {
            const QString name = QString::fromStdString(entry.name);
            QVERIFY2(test::waitForSequence(*m_window, name), entry.name.c_str());
        }
        SequencesWorkspace& workspace = m_window->sequences();
        QTRY_VERIFY(workspace.player().isPlaying());
        QTRY_VERIFY(workspace.player().frame() > FrameIndex(3));
        QTRY_VERIFY(!workspace.scene().textureOf(first).isNull());
    }

    void aTileLeadsToTheTransitions()
    {
        makeSampleSmall();
        QTest::mouseClick(test::find<WelcomeTile>("welcome.transitions"), Qt::LeftButton);
        QTRY_COMPARE(m_window->workspaces().current(), QString("graph"));
        GraphResults& graphs = m_window->context().graphs;
        QTRY_VERIFY(graphs.resultState(graphs.firstCharacter())->phase == ResultPhase::Ready);
    }

    void whatIsShippedIsNotMadeAgain()
    {
        namespace fs = std::filesystem;
        const fs::path folder = sampleFolder();
        const auto isUpToDate = [](const fs::path& project) {
            const auto steps =
                rebuild(loadProject(project), project, {.targets = {"graph/Quad"}, .dryRun = true}).steps;
            // The editor has no use for Euclidean distances, nor for tables of edges.
            return steps.size() > 4 && std::ranges::all_of(steps, [](const StepReport& step) {
                       return step.state == StepState::Fresh ||
                              step.step == "graph/Quad/euclidean-distance" || step.step == "graph/Quad/edges";
                   });
        };
        if (!fs::exists(folder))
            QSKIP("no test before this one has made the sample");
        const QTemporaryDir places;
        const fs::path shipped = toPath(places.filePath("shipped"));
        const fs::path copy = toPath(places.filePath("copy"));
        QVERIFY(!copySample(shipped, copy, {}));
        fs::create_directories(shipped);
        QVERIFY(!copySample(shipped, copy, {}));
        fs::copy(folder, shipped, fs::copy_options::recursive);
        const auto project = copySample(shipped, copy, {});
        QVERIFY(project.has_value());
        QCOMPARE(*project, copy / "sample.quadrille");
        QVERIFY(isUpToDate(*project));
        QCOMPARE(loadProject(*project), loadProject(folder / "sample.quadrille"));
        // One that cannot be read whole leaves no project behind.
        fs::remove(copy / "sample.quadrille");
        fs::remove(shipped / "sample.quadrille");
        QVERIFY(!copySample(shipped, copy, {}));
        QVERIFY(!fs::exists(copy / "sample.quadrille"));
    }

    void aTileLeadsToAPerformanceAlongAPath()
    {
        makeSampleSmall();
        QTest::mouseClick(test::find<WelcomeTile>("welcome.path"), Qt::LeftButton);
        QTRY_COMPARE(m_window->workspaces().current(), QString("animate"));
        QCOMPARE(m_window->context().selection.shownAnimation(), QString("along an S"));
        QTRY_VERIFY(m_window->context().animations.result("along an S") != nullptr);
        QTRY_VERIFY(m_window->animate().player().isPlaying());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::MainWindowTest);
#include "tst_mainwindow.moc"
