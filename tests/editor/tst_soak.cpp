// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The same hour of work over and over: what it takes must not grow. A few rounds as a test; with
// QUADRILLE_SOAK_MINUTES (and QTEST_FUNCTION_TIMEOUT, in milliseconds) set for that long, with the memory
// printed.
#include "animatedproject.h"
#include "editor/application/memory.h"
#include "editor/commands/animationedits.h"
#include "editor/commands/projectedits.h"
#include "editor/jobs/jobrunner.h"
#include "editor/playback/player.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "tests/qt/registry.h"

#include <QElapsedTimer>
#include <QFile>
#include <memory>

namespace quadrille {

namespace {

/// Megabytes of memory that the process has; 0 where the system does not tell.
double residentMegabytes()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    constexpr double pagesOfAMegabyte = 256;
    return file.readAll().split(' ').value(1).toDouble() / pagesOfAMegabyte;
}

} // namespace

class SoakTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }

    void lookAround(Workspace& workspace)
    {
        workspace.player().play();
        QTest::qWait(100);
        workspace.player().pause();
        for (const int frame : {5, 30, 12, 0})
            workspace.player().goTo(frame);
        QTest::keyClick(&workspace.viewport(), Qt::Key_H);
        QTest::qWait(50);
        QTest::keyClick(&workspace.viewport(), Qt::Key_H);
    }

    void compareTakes()
    {
        m_window->workspaces().select("sequences");
        context().selection.selectSequences({"first", "second"});
        lookAround(m_window->sequences());
        context().selection.selectSequences({"third"});
        QVERIFY(QTest::qWaitFor([&] { return m_window->sequences().scene().frameCount() > 0; }));
        lookAround(m_window->sequences());
    }

    void moveAlpha(double alpha)
    {
        m_window->workspaces().select("graph");
        GraphEntry graph = graphEntry(document().project(), "spire");
        graph.alpha = alpha;
        setGraph(document(), "alpha", "alpha", graph);
        context().graphs.ask("spire");
        QVERIFY(QTest::qWaitFor(
            [&] {
                const auto* resultState = context().graphs.resultState("spire");
                return resultState->phase == ResultPhase::Ready &&
                       resultState->opened->graph.alpha() == alpha;
            },
            test::patience));
    }

    void editAnimation(int last)
    {
        m_window->workspaces().select("animate");
        AnimationEntry entry = *document().animation("dance");
        std::get<ActionEntry>(entry.constraints[1]).frames.range =
            FrameRange{FrameIndex(2), FrameIndex(last)};
        setAnimation(document(), "dance", "range", "range", entry);
        QVERIFY(test::waitForResult(context(), "dance"));
        lookAround(m_window->animate());
    }

    /// Leaves the project as it was.
    void work(int round)
    {
        const Project before = document().project();
        const int commands = document().undoStack()->index();
        compareTakes();
        moveAlpha(round % 2 == 0 ? 0.02 : 0.05);
        editAnimation(40 + round % 10);
        while (document().undoStack()->index() > commands)
            document().undo();
        QVERIFY(document().project() == before);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        keepMemoryTight();
        test::isolate();
        test::writeSwayingTakes(m_folder.path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1280, 720);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        document().reset(test::swayingProject(m_folder.path()));
        for (const char* name : {"first", "second", "third"})
            QVERIFY(test::waitForSequence(*m_window, name));
    }
    void cleanupTestCase() { m_window.reset(); }

    void memoryDoesNotGrowWithUse()
    {
        const double minutes = qEnvironmentVariable("QUADRILLE_SOAK_MINUTES").toDouble();
        constexpr int shortRounds = 3;
        constexpr int warmUp = 10; // until caches are full and all code was used
        QElapsedTimer clock;
        clock.start();
        const auto isOver = [&](int round) {
            return minutes > 0 ? static_cast<double>(clock.elapsed()) > minutes * 60000
                               : round >= shortRounds;
        };
        double warm = 0;
        for (int round = 0; !isOver(round); ++round) {
            work(round);
            if (round == warmUp)
                warm = residentMegabytes();
            if (minutes > 0 && round % 10 == 0)
                qInfo("round %d after %.1f min: %.0f MB", round, static_cast<double>(clock.elapsed()) / 60000,
                      residentMegabytes());
        }
        QTRY_VERIFY(context().jobs.jobs().empty());
        // MB: what allocators keep of the memory that was freed grows for a quarter of an hour, then it is
        // full.
        constexpr double tolerated = 192;
        if (warm > 0)
            QVERIFY2(residentMegabytes() < warm + tolerated,
                     qPrintable(QStringLiteral("%1 MB, then %2 MB").arg(warm).arg(residentMegabytes())));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::SoakTest);
#include "tst_soak.moc"
