// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The sound of an animation: chosen, moved, heard, taken away.
#include "animatedproject.h"
#include "editor/playback/soundplayer.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/animationsound.h"
#include "tests/model/audio/tone.h"
#include "tests/qt/registry.h"
#include "widgets/timeline/soundlane.h"

#include <QSignalSpy>

namespace quadrille {

namespace {

/// Notes what would be heard; its time goes as the test says.
class NotedOutput : public SoundOutput
{
public:
    struct Notes
    {
        std::vector<double> starts;
        int stops = 0;
        double heard = 0;
        double gain = 0;
    };
    explicit NotedOutput(Notes& notes) : m_notes(notes) {}
    void start(std::shared_ptr<const Sound>, double gain, double from) override
    {
        m_notes.starts.push_back(from);
        m_notes.heard = from;
        m_notes.gain = gain;
    }
    void stop() override { ++m_notes.stops; }
    double heard() const override { return m_notes.heard; }

private:
    Notes& m_notes;
};

} // namespace

class AudioTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    AnimationSound& sound() { return m_window->animate().sound(); }
    widgets::SoundLane& lane() { return sound().lane(); }
    const std::optional<AudioEntry>& audio() { return context().document.animation("dance")->audio; }
    QString tonePath(double seconds)
    {
        const QString path = m_folder->filePath(QStringLiteral("tone.wav"));
        std::ofstream(path.toStdString(), std::ios::binary) << test::wavOf(test::tone(seconds, 8000));
        return path;
    }
    void useTone(double seconds)
    {
        sound().use(tonePath(seconds).toStdString());
        QTRY_VERIFY(sound().sound() != nullptr);
    }

    std::unique_ptr<QTemporaryDir> m_takes;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        m_takes = std::make_unique<QTemporaryDir>();
        test::writeSwayingTakes(m_takes->path());
    }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_window = test::openAnimated(m_takes->path());
        QVERIFY(m_window);
    }
    void cleanup()
    {
        context().document.undoStack()->setClean();
        m_window.reset();
    }

    void aChosenSoundIsDrawnAndUndoTakesItAway()
    {
        QVERIFY(!audio());
        QCOMPARE(lane().sizeHint().height(), 22);
        useTone(1.5);
        QVERIFY(audio());
        QCOMPARE(QString::fromStdString(audio()->file), m_folder->filePath("tone.wav"));
        QTRY_COMPARE(lane().height(), 34);
        QCOMPARE(lane().soundRect().width(), lane().xOf(1.5) - lane().xOf(0));
        // The tone reaches half of the height to either side.
        const QImage picture = lane().grab().toImage();
        const qreal scale = picture.devicePixelRatio();
        const auto colorAt = [&](double share) {
            const QPointF at(lane().xOf(1.3), lane().height() * share);
            return picture.pixelColor((at * scale).toPoint());
        };
        QCOMPARE(colorAt(0.35), colorAt(0.5));
        QVERIFY(colorAt(0.12) != colorAt(0.5));
        context().document.undo();
        QVERIFY(!audio());
        QTRY_COMPARE(lane().sizeHint().height(), 22);
        context().document.redo();
        QTRY_VERIFY(sound().sound() != nullptr);
    }

    void aDragMovesTheSoundInOneStep()
    {
        useTone(1);
        QVERIFY(test::activate(*m_window));
        const int steps = context().document.undoStack()->count();
        const double pixels = lane().xOf(0.8) - lane().xOf(0);
        const QPoint from(static_cast<int>(lane().xOf(0.5)), lane().height() / 2);
        QTest::mousePress(&lane(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(&lane(), from + QPoint(static_cast<int>(pixels * i / 4), 0));
        QTest::mouseRelease(&lane(), Qt::LeftButton, {}, from + QPoint(static_cast<int>(pixels), 0));
        QVERIFY(std::abs(audio()->offset - 0.8) < 0.02);
        QCOMPARE(context().document.undoStack()->count(), steps + 1);
        // Near the first frame it snaps.
        const QPoint grip(static_cast<int>(lane().xOf(1.3)), lane().height() / 2);
        QTest::mousePress(&lane(), Qt::LeftButton, {}, grip);
        QTest::mouseMove(&lane(), grip - QPoint(static_cast<int>(pixels) - 3, 0));
        QTest::mouseRelease(&lane(), Qt::LeftButton, {}, grip - QPoint(static_cast<int>(pixels) - 3, 0));
        QCOMPARE(audio()->offset, 0.0);
        context().document.undo();
        QVERIFY(std::abs(audio()->offset - 0.8) < 0.02);
        // Escape leaves it where it was.
        QTest::mousePress(&lane(), Qt::LeftButton, {}, grip);
        QTest::mouseMove(&lane(), grip + QPoint(20, 0));
        QTest::keyClick(&lane(), Qt::Key_Escape);
        QVERIFY(std::abs(audio()->offset - 0.8) < 0.02);
        QTest::mouseRelease(&lane(), Qt::LeftButton, {}, grip);
    }

    void keysMoveAndRemoveTheSound()
    {
        useTone(1);
        const double frame = 1 / context().document.project().settings.fps;
        QTest::keyClick(&lane(), Qt::Key_Right);
        QVERIFY(std::abs(audio()->offset - frame) < 1e-3);
        QTest::keyClick(&lane(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(std::abs(audio()->offset - (frame - 0.1)) < 2e-3);
        QTest::keyClick(&lane(), Qt::Key_Delete);
        QVERIFY(!audio());
        QVERIFY(!context().actions.action("animate.sound.remove")->isEnabled());
        context().document.undo();
        QVERIFY(audio());
        QVERIFY(context().actions.action("animate.sound.remove")->isEnabled());
    }

    void aSoundDoesNotMakeTheClipAgain()
    {
        QVERIFY(test::waitForResult(context(), "dance"));
        const auto before = context().animations.result("dance");
        useTone(1);
        QSignalSpy changes(&context().animations, &AnimationResults::changed);
        QVERIFY(!changes.wait(100)); // longer than edits are gathered
        QCOMPARE(context().animations.result("dance"), before);
        QCOMPARE(context().animations.resultState("dance")->phase, ResultPhase::Ready);
    }

    void aFileThatIsNoSoundSaysSo()
    {
        const QString path = m_folder->filePath(QStringLiteral("text.wav"));
        std::ofstream(path.toStdString()) << "not a sound";
        sound().use(path.toStdString());
        QTRY_COMPARE(context().issues.rowCount(), 1);
        QVERIFY(sound().sound() == nullptr);
        context().document.undo();
    }

    void itIsHeardInStepWithThePicture()
    {
        NotedOutput::Notes notes;
        sound().player().setOutput(std::make_unique<NotedOutput>(notes));
        QVERIFY(test::waitForResult(context(), "dance"));
        useTone(10);
        Player& player = m_window->animate().player();
        const double fps = context().document.project().settings.fps;
        QTRY_VERIFY(m_window->animate().scene().frameCount() > 10);
        QVERIFY(notes.starts.empty());
        player.pause();
        player.goTo(5);
        QVERIFY(notes.starts.empty()); // scrubbing is silent
        player.play();
        QCOMPARE(notes.starts.size(), 1U);
        QVERIFY(std::abs(notes.starts.back() - 5 / fps) < 1e-6);
        player.pause();
        QCOMPARE(notes.stops, 1);
        // Backwards, and faster, nothing is heard.
        player.goTo(5);
        player.play(-1);
        player.play(2);
        QCOMPARE(notes.starts.size(), 1U);
        player.pause();
        // A sound that begins later is silent first; what drifts apart is brought together.
        lane().setFocus();
        for (int i = 0; i < 10; ++i)
            QTest::keyClick(&lane(), Qt::Key_Right, Qt::ShiftModifier);
        player.goTo(2);
        player.play();
        QCOMPARE(notes.starts.size(), 2U);
        QVERIFY(std::abs(notes.starts.back() - (2 / fps - 1)) < 1e-3);
        notes.heard += 3;
        QTRY_COMPARE(notes.starts.size(), 3U);
        // Muted, it stops at once.
        const int stops = notes.stops;
        context().actions.action("animate.sound.mute")->trigger();
        QCOMPARE(notes.stops, stops + 1);
        player.pause();
        sound().player().setOutput(nullptr);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::AudioTest);
#include "tst_audio.moc"
