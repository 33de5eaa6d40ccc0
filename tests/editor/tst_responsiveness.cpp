// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The sample on all cores: its graph is computed and an animation sought while somebody uses the window. What
// the probe measures is printed, not asserted: it depends on what else the machine does.
#include "animatedproject.h"
#include "editor/jobs/jobrunner.h"
#include "editor/playback/player.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "eventprobe.h"
#include "model/sample/sample.h"
#include "tests/qt/registry.h"

#include <memory>

namespace quadrille {

class ResponsivenessTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    static test::MeasuredApplication& measured()
    {
        return static_cast<test::MeasuredApplication&>(*QCoreApplication::instance());
    }
    void measure()
    {
        measured().reset();
        m_probe.start();
    }
    void tell(const char* what)
    {
        m_probe.stop();
        qInfo("%s: longest wait of an event %lld ms, %lld of %lld events later than %lld ms", what,
              m_probe.longest(), m_probe.late(), m_probe.events(), test::EventProbe::limitMilliseconds);
        qInfo("Slowest handler: %lld ms of those that draw, %lld ms of all others",
              measured().longestPainting(), measured().longestOther());
        QVERIFY(m_probe.events() > 0);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    test::EventProbe m_probe;

private slots:
    void initTestCase()
    {
        test::isolate();
        const auto project =
            writeSample(m_folder.path().toStdString(), {.textureSize = 256, .takesPerKind = 1});
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1280, 720);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->open({QString::fromStdString(project.string())});
        for (const SequenceEntry& entry : context().document.project().sequences)
            QVERIFY(test::waitForSequence(*m_window, QString::fromStdString(entry.name)));
    }

    void cleanupTestCase() { m_window.reset(); }

    void playingWhileTheGraphIsComputed()
    {
        const QString character = context().graphs.firstCharacter();
        m_window->sequences().player().play();
        measure();
        context().graphs.ask(character);
        QTRY_VERIFY(context().graphs.resultState(character)->phase == ResultPhase::Ready);
        tell("Playing while the graph is computed");
        QVERIFY(m_window->sequences().player().isPlaying());
    }

    void playingWhileAnAnimationIsSought()
    {
        QVERIFY(!context().document.project().animations.empty());
        m_window->workspaces().select("animate");
        QElapsedTimer clock;
        clock.start();
        measure();
        const QString name = context().selection.shownAnimation();
        QTRY_VERIFY(context().animations.result(name) != nullptr);
        qInfo("“%s”: first walk on screen after %lld ms", qPrintable(name), clock.elapsed());
        m_window->animate().player().play();
        QTest::qWait(2000);
        tell("Playing while an animation is sought");
    }

    void cancellingTakesEffectAtOnce()
    {
        QElapsedTimer clock;
        clock.start();
        context().jobs.cancelAll();
        QTRY_VERIFY(context().jobs.jobs().empty());
        qInfo("All jobs were over %lld ms after they were cancelled", clock.elapsed());
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(quadrille::test::MeasuredApplication, quadrille::ResponsivenessTest);
#include "tst_responsiveness.moc"
