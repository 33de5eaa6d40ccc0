// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What is done on the timeline of takes, with real keys and clicks in the whole window: labels, loops, rows.
#include "editor/playback/player.h"
#include "editor/workspaces/sequences/labeltakes.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/vtkview.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <numeric>

namespace quadrille {

namespace {

constexpr int steps = 30;

} // namespace

class SequenceTimelineTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    ClipScene& scene() { return m_window->sequences().scene(); }
    widgets::Viewport& viewport() { return m_window->sequences().viewport(); }
    widgets::Timeline& timeline() { return m_window->sequences().view().timeline(); }
    const SequenceEntry& entry(const char* name) { return *context().document.sequence(name); }
    void show(const QString& name)
    {
        context().selection.selectSequences({name});
        QTRY_VERIFY(scene().frameCount() > 0);
        QVERIFY(test::activate(*m_window));
        viewport().setFocus();
    }
    /// The field over the timeline in which a label is named; null when there is none.
    QLineEdit* nameField()
    {
        for (auto* field : timeline().findChildren<QLineEdit*>("labelName"))
            if (field->isVisible())
                return field;
        return nullptr;
    }
    std::string label(std::size_t span) { return entry("step_1").labels.at(span).label; }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        QList<int> numbers(steps);
        std::iota(numbers.begin(), numbers.end(), 10);
        test::writeSeries(m_folder.path(), numbers);
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        Project project;
        const std::string folder = m_folder.path().toStdString();
        project.characters = {{.name = "pyramid", .mesh = folder + "/walk_10.obj"}};
        project.sequences = {{.name = "step_1", .character = "pyramid", .source = folder},
                             {.name = "far 2", .character = "pyramid", .source = folder},
                             {.name = "late", .character = "pyramid", .source = folder + "/late"}};
        context().document.reset(project);
        QVERIFY(test::waitForSequence(*m_window, "step_1"));
        QVERIFY(test::waitForSequence(*m_window, "far 2"));
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void aLabelIsNamedByReturnAndLeftByEscape()
    {
        show("step_1");
        QTest::keyClick(&viewport(), Qt::Key_M);
        QVERIFY(nameField() != nullptr);
        QCOMPARE(nameField()->text(), QString("step")); // proposed from the name of the take
        QTest::keyClicks(nameField(), "hop im");
        // Letters and Space are part of the name, not commands of the window.
        QVERIFY(!m_window->sequences().player().isPlaying());
        QCOMPARE(entry("step_1").labels.size(), 1U);
        QTest::keyClick(nameField(), Qt::Key_Return);
        QVERIFY(nameField() == nullptr);
        QCOMPARE(label(0), std::string("hop im"));
        QVERIFY(timeline().hasFocus());

        // To make and to name it is one edit.
        const int edits = context().document.undoStack()->index();
        QTest::keyClick(&viewport(), Qt::Key_M);
        QTest::keyClicks(nameField(), "second");
        QTest::keyClick(nameField(), Qt::Key_Return);
        QCOMPARE(label(1), std::string("second"));
        QCOMPARE(context().document.undoStack()->index(), edits + 1);
        context().document.undo();
        QCOMPARE(entry("step_1").labels.size(), 1U);
        // Left by Escape it was never made.
        QTest::keyClick(&viewport(), Qt::Key_M);
        QTest::keyClicks(nameField(), "third");
        QTest::keyClick(nameField(), Qt::Key_Escape);
        QVERIFY(nameField() == nullptr);
        QCOMPARE(entry("step_1").labels.size(), 1U);
        QCOMPARE(context().document.undoStack()->index(), edits);

        timeline().setSelectedSpan(widgets::SpanRef{"labels", 0});
        QTest::keyClick(&timeline(), Qt::Key_Return); // names the selected one
        QVERIFY(nameField() != nullptr);
        QTest::keyClicks(nameField(), "other");
        QTest::keyClick(nameField(), Qt::Key_Escape);
        QVERIFY(nameField() == nullptr);
        QCOMPARE(label(0), std::string("hop im"));
        QCOMPARE(entry("step_1").labels.size(), 1U);
    }

    void aLabelIsNamedByGoingElsewhere()
    {
        show("step_1");
        // Nothing is typed: the field goes all the same.
        QTest::keyClick(&viewport(), Qt::Key_M);
        QVERIFY(nameField() != nullptr);
        QTest::mouseClick(viewport().view(), Qt::LeftButton, {}, {20, 20});
        QVERIFY(nameField() == nullptr);
        // A button that takes no focus is elsewhere, too.
        QTest::keyClick(&viewport(), Qt::Key_M);
        QTest::keyClicks(nameField(), "hop");
        QTest::mouseClick(m_window->sequences().findChild<QToolButton*>("step"), Qt::LeftButton);
        QVERIFY(nameField() == nullptr);
        QCOMPARE(label(1), std::string("hop"));
        // So is the timeline below, which is turned.
        QTest::keyClick(&viewport(), Qt::Key_M);
        QTest::mouseClick(&timeline(), Qt::LeftButton, {}, timeline().rulerRect().center());
        QVERIFY(nameField() == nullptr);
        QCOMPARE(entry("step_1").labels.size(), 3U);
    }

    void takesAreLabelledAllAtOnceByTheirNames()
    {
        QCOMPARE(proposedLabel("walk_1"), QString("walk"));
        QCOMPARE(proposedLabel("left turn 12"), QString("left turn"));
        QCOMPARE(proposedLabel("03_high-jump.2"), QString("high-jump"));
        QCOMPARE(proposedLabel("12"), QString("12"));
        const Project before = context().document.project();
        context().selection.selectSequences({"far 2", "late", "step_1"});
        QTRY_VERIFY(scene().isComparing());
        QVERIFY(test::activate(*m_window));
        bool wasOpen = false;
        QTimer::singleShot(0, [&] {
            auto* dialog = qobject_cast<LabelTakes*>(QApplication::activeModalWidget());
            wasOpen = dialog != nullptr;
            if (!wasOpen)
                return;
            auto* table = dialog->findChild<QTableWidget*>("labelTable");
            // What is typed counts, also when Return closes the field and then the dialog.
            table->setFocus();
            table->setCurrentCell(2, 1);
            auto* field = table->findChild<QLineEdit*>("takeLabel");
            field->selectAll();
            QTest::keyClicks(field, "stride");
            QTest::keyClick(field, Qt::Key_Return);
            QVERIFY(dialog->isVisible());
            QTest::keyClick(table, Qt::Key_Return);
        });
        QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier);
        QVERIFY(wasOpen);
        QCOMPARE(entry("far 2").labels, (std::vector<LabelSpan>{{"far", FrameRange::all(steps)}}));
        QCOMPARE(entry("step_1").labels, (std::vector<LabelSpan>{{"stride", FrameRange::all(steps)}}));
        QVERIFY(entry("late").labels.empty()); // could not be opened
        context().document.undo();
        QCOMPARE(context().document.project(), before);
    }

    void aLoopIsMarkedOnTheRulerAndPlaysBackAndForth()
    {
        show("far 2");
        const Project before = context().document.project();
        const QRect ruler = timeline().rulerRect();
        const auto at = [&](int frame) { return QPoint(timeline().xOfFrame(frame), ruler.center().y()); };
        QTest::mousePress(&timeline(), Qt::LeftButton, Qt::ShiftModifier, at(5));
        QTest::mouseMove(&timeline(), at(8));
        QTest::mouseMove(&timeline(), at(9));
        QTest::mouseRelease(&timeline(), Qt::LeftButton, Qt::ShiftModifier, at(9));
        QCOMPARE(timeline().loop(), std::optional(std::pair(5, 9)));
        QCOMPARE(context().document.project(), before); // a loop trims nothing
        Player& player = m_window->sequences().player();
        const auto seen = [&player](auto&& run) {
            QSignalSpy frames(&player, &Player::frameChanged);
            run();
            std::vector<qint64> all;
            const bool hasPlayed = QTest::qWaitFor([&] { return frames.size() > 12; }, 10000);
            player.pause();
            if (!hasPlayed)
                return all;
            for (const QList<QVariant>& each : frames)
                all.push_back(each.front().toLongLong());
            return all;
        };
        player.goTo(5);
        const auto round = seen([&] { QTest::keyClick(m_window.get(), Qt::Key_Space); });
        QVERIFY(round.size() > 12);
        QVERIFY(std::ranges::all_of(round, [](qint64 frame) { return frame >= 5 && frame <= 9; }));
        context().actions.action("play.backAndForth")->setChecked(true);
        player.goTo(5);
        constexpr double slowly = 0.2; // so that a busy machine shows most frames
        const auto forth = seen([&] { player.play(slowly); });
        QVERIFY(forth.size() > 12);
        // It goes back frame by frame; a loop would go from one end to the other.
        int stepsBack = 0;
        for (std::size_t i = 1; i < forth.size(); ++i)
            stepsBack += forth[i] == forth[i - 1] - 1 ? 1 : 0;
        QVERIFY2(stepsBack >= 2, qPrintable(QString::number(stepsBack)));
        context().actions.action("play.backAndForth")->setChecked(false);
        context().actions.action("play.loopAll")->trigger();
        QVERIFY(!timeline().loop());
    }

    void whatPlaysFromHereComesBack()
    {
        show("far 2");
        Player& player = m_window->sequences().player();
        player.goTo(7);
        QTest::keyClick(m_window.get(), Qt::Key_R);
        QVERIFY(player.isPlaying());
        QTRY_VERIFY(player.frame().value != 7);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QVERIFY(!player.isPlaying());
        QCOMPARE(player.frame(), FrameIndex(7));
        QCOMPARE(timeline().currentFrame(), 7);
        // Playing as usual stays where it stops.
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(player.frame().value > 12);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QVERIFY(player.frame().value != 7);
    }

    void rowsAndRulerStayAsTheyWereMade()
    {
        show("step_1");
        QTest::mouseClick(&timeline(), Qt::LeftButton, {}, timeline().titleRect("labels").center());
        QVERIFY(timeline().isFolded("labels"));
        context().actions.action("play.seconds")->trigger();
        QCOMPARE(timeline().unit(), widgets::Timeline::Unit::Seconds);
        MainWindow other;
        const widgets::Timeline& again = other.sequences().view().timeline();
        QVERIFY(again.isFolded("labels"));
        QCOMPARE(again.unit(), widgets::Timeline::Unit::Seconds);
        QTest::mouseClick(&timeline(), Qt::LeftButton, {}, timeline().titleRect("labels").center());
        context().actions.action("play.seconds")->trigger();
        QVERIFY(!timeline().isFolded("labels"));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::SequenceTimelineTest);
#include "tst_sequencetimeline.moc"
