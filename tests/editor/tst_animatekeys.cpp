// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Poses at times: placed, moved and removed with real mouse and keys, and when they are met.
#include "animatedproject.h"
#include "dropping.h"
#include "editor/docks/sequencecards.h"
#include "editor/playback/player.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/animationtracks.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "editor/workspaces/animate/keysandstoryboard.h"
#include "editor/workspaces/animate/keysmodel.h"
#include "editor/workspaces/animate/keyspanel.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "tests/qt/registry.h"
#include "widgets/timeline/framekind.h"
#include "widgets/timeline/timeline.h"

#include <QAbstractItemModelTester>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListView>
#include <QMimeData>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>

namespace quadrille {

class AnimateKeysTest : public QObject
{
    Q_OBJECT

private:
    using Timeline = widgets::Timeline;

    EditorContext& context() { return m_window->context(); }
    Timeline& timeline() { return m_window->animate().view().timeline(); }
    std::vector<KeyEntry> keys()
    {
        const AnimationEntry* entry = context().document.animation("pose");
        return entry == nullptr ? std::vector<KeyEntry>() : keysOf(*entry);
    }
    QPoint at(int frame)
    {
        return {timeline().xOfFrame(frame), timeline().trackRect(QStringLiteral("keys")).top() + 8};
    }
    QPoint markOf(int key)
    {
        const QRect rect = timeline().spanRect({QStringLiteral("keys"), timeline().tracks()[0].keys[key].id});
        return {rect.left() + rect.width() / 2, rect.top() + 8};
    }
    QString cell(int row, int column)
    {
        const auto* table = test::find<QTableView>("keysTable");
        return table->model()->index(row, column).data().toString();
    }
    void drag(const QPoint& from, const QPoint& to)
    {
        QTest::mousePress(&timeline(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 4; ++step)
            QTest::mouseMove(&timeline(), from + (to - from) * step / 4);
        QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, to);
    }
    /// Drops the frame that a card shows onto the timeline.
    void drop(const QString& sequence, int frame) { test::dropCard(sequence, timeline(), at(frame)); }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        test::writeSwayingTakes(m_folder.path());
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1000, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        Project project = test::swayingProject(m_folder.path());
        project.animations[0].name = "pose";
        project.animations[0].constraints.clear();
        context().document.reset(project);
        for (const char* take : {"first", "second", "third"})
            QVERIFY(test::waitForSequence(*m_window, take));
        context().actions.action("workspace.animate")->trigger();
        context().selection.selectAnimations({"pose"});
        test::find<QDockWidget>("keysDock")->show(); // low windows begin without it
        test::find<QDockWidget>("keysDock")->raise();
        QTRY_VERIFY(!timeline().tracks().empty());
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void fourKeysArePlacedMovedAndRemovedAndAllIsUndone()
    {
        const Project before = context().document.project();
        drop("first", 10);
        drop("second", 60);
        drop("third", 120);
        drop("first", 180);
        QCOMPARE(keys().size(), 4U);
        QCOMPARE(keys()[1].sequence, "second");
        const double fps = context().document.project().settings.fps;
        QCOMPARE(keys()[1].time, 60 / fps);

        const int steps = context().document.undoStack()->index();
        drag(markOf(1), at(80));
        QCOMPARE(keys()[1].time, 80 / fps);
        QCOMPARE(context().document.undoStack()->index(), steps + 1); // one step for the whole drag

        // Past another key: the order follows the times.
        drag(markOf(1), at(140));
        QCOMPARE(keys()[1].sequence, "third");
        QCOMPARE(keys()[2].sequence, "second");
        QCOMPARE(keys()[2].time, 140 / fps);

        timeline().setFocus();
        QTest::mouseClick(&timeline(), Qt::LeftButton, {}, markOf(3));
        QTest::keyClick(&timeline(), Qt::Key_Delete);
        QCOMPARE(keys().size(), 3U);
        const Project after = context().document.project();

        while (context().document.canUndo())
            context().document.undo();
        QCOMPARE(context().document.project(), before);
        QVERIFY(timeline().tracks()[0].keys.empty());
        while (context().document.undoStack()->canRedo())
            context().document.redo();
        QCOMPARE(context().document.project(), after);
        QCOMPARE(timeline().tracks()[0].keys.size(), 3U);
    }

    void theTableShowsWantedAndObtainedTimes()
    {
        drop("first", 10);
        drop("second", 60);
        QVERIFY(test::waitForResult(context(), "pose"));
        auto* table = test::find<QTableView>("keysTable");
        const QAbstractItemModelTester tester(table->model());
        QCOMPARE(table->model()->rowCount(), 2);
        const auto result = context().animations.result("pose");
        const double fps = context().document.project().settings.fps;
        const QLocale locale;
        for (int row = 0; row < 2; ++row) {
            const double obtained =
                static_cast<double>(result->walk.solution.keys[static_cast<std::size_t>(row)].obtained) / fps;
            QCOMPARE(cell(row, KeysModel::Wanted),
                     locale.toString(keys()[static_cast<std::size_t>(row)].time, 'f', 2));
            QCOMPARE(cell(row, KeysModel::Obtained), locale.toString(obtained, 'f', 2));
        }
        // The clip strip has captured and made parts, and the keys say where they are met.
        const auto& tracks = timeline().tracks();
        QCOMPARE(tracks[1].id, QStringLiteral("clip"));
        QVERIFY(std::ranges::any_of(tracks[1].spans, &widgets::TimelineSpan::hatched));
        QVERIFY(!std::ranges::all_of(tracks[1].spans, &widgets::TimelineSpan::hatched));
        const auto shown = static_cast<double>(result->walk.solution.keys[1].obtained);
        QCOMPARE(tracks[0].keys[1].obtained, std::optional(shown));
    }

    void theClipStripTellsVariedFramesFromCapturedOnesAndTransitions()
    {
        drop("first", 10);
        drop("second", 60);
        QVERIFY(test::waitForResult(context(), "pose"));
        AnimationResult result = *context().animations.result("pose");
        result.variations = std::make_shared<const std::vector<TakeVariation>>(
            1, TakeVariation{.name = "variations/strolls/3"});
        const auto planned = plannedFrames(result);
        const std::vector<ClipPart> parts = clipParts(result, planned);
        const auto varied = std::ranges::find(parts, false, &ClipPart::isJunction);
        QVERIFY(varied != parts.end());
        QVERIFY(std::ranges::count(parts, false, &ClipPart::isJunction) > 1);
        for (FrameIndex f = varied->frames.first; f <= varied->frames.last; ++f.value) {
            FrameProvenance& origin = result.origins[static_cast<std::size_t>(f.value)];
            origin.sourceVariation = origin.destinationVariation = 1;
        }
        const double fps = context().document.project().settings.fps;
        const widgets::TimelineTrack clip =
            AnimationTracks{result.entry, &result, planned, parts, fps}.clip();
        QCOMPARE(clip.spans.size(), parts.size());
        for (const widgets::TimelineSpan& span : clip.spans) {
            const ClipPart& part = parts[static_cast<std::size_t>(span.id)];
            const bool isVaried = part == *varied;
            QCOMPARE(span.hatched, part.isJunction);
            QCOMPARE(span.dotted, isVaried);
            QCOMPARE(span.text.contains("strolls/3"), isVaried);
            const auto kind = part.isJunction ? widgets::FrameKind::Transition
                              : isVaried      ? widgets::FrameKind::Varied
                                              : widgets::FrameKind::Captured;
            QCOMPARE(span.color, widgets::frameKindColor(kind));
        }
    }

    void timesAndTolerancesAreEditedInTheTable()
    {
        drop("first", 10);
        drop("second", 60);
        context().actions.action("animate.nextKey")->trigger();
        auto* table = test::find<QTableView>("keysTable");
        QTRY_VERIFY(table->isVisible());
        table->setFocus();
        table->setCurrentIndex(table->model()->index(1, KeysModel::Wanted));
        QTest::keyClick(table, Qt::Key_F2);
        auto* field = test::find<QDoubleSpinBox>("keyTime");
        field->selectAll();
        QTest::keyClicks(field, QLocale().toString(1.5));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(keys()[1].time, 1.5);
        table->setCurrentIndex(table->model()->index(0, KeysModel::Tolerance));
        table->model()->setData(table->currentIndex(), 0.2, Qt::EditRole);
        QCOMPARE(keys()[0].tolerance, std::optional(0.2));
        table->model()->setData(table->currentIndex(), -1, Qt::EditRole);
        QCOMPARE(keys()[0].tolerance, std::optional<double>());
        QTest::keyClick(table, Qt::Key_Delete);
        QCOMPARE(keys().size(), 1U);
    }

    void keysOfTheTableStayInTheTable()
    {
        drop("first", 10);
        drop("second", 60);
        auto* table = test::find<QTableView>("keysTable");
        QTRY_VERIFY(table->isVisible());
        QVERIFY(test::activate(*m_window));
        context().selection.selectSequences({"third"});
        context().selection.selectAnimations({"pose"});
        table->setFocus();
        // F2 edits the key, wherever in its row it is pressed, and never what the tree has selected.
        for (const int column : {KeysModel::Pose, KeysModel::Tolerance}) {
            table->setCurrentIndex(table->model()->index(1, column));
            QTest::keyClick(table, Qt::Key_F2);
            auto* field = table->findChild<QDoubleSpinBox*>("keyTime");
            QVERIFY(field != nullptr);
            QVERIFY(test::find<QTreeView>("projectTree")->findChild<QLineEdit*>() == nullptr);
            QTest::keyClick(field, Qt::Key_Escape);
            QTRY_VERIFY(table->findChild<QDoubleSpinBox*>("keyTime") == nullptr);
        }
        // Return takes what was typed, and is not a wish to go to the key.
        QSignalSpy gone(test::find<KeysPanel>("keysPanel"), &KeysPanel::keyChosen);
        table->setCurrentIndex(table->model()->index(1, KeysModel::Wanted));
        QTest::keyClick(table, Qt::Key_F2);
        auto* field = table->findChild<QDoubleSpinBox*>("keyTime");
        field->selectAll();
        // A result that arrives now takes neither the selection nor what is typed.
        const auto arrive = [model = table->model()] {
            emit model->dataChanged(model->index(0, 0), model->index(1, model->columnCount() - 1));
        };
        arrive();
        QTest::keyClicks(field, QLocale().toString(3.5));
        arrive();
        QTest::keyClick(field, Qt::Key_Return);
        arrive(); // the field is about to be taken over
        QTRY_COMPARE(keys()[1].time, 3.5);
        QCOMPARE(gone.size(), 0);
    }

    void thereIsAlwaysRoomBehindTheLastKey()
    {
        drop("first", 10);
        QVERIFY(test::waitForResult(context(), "pose"));
        QTRY_VERIFY(m_window->animate().view().scene().frameCount() > 0);
        const double fps = context().document.project().settings.fps;
        QVERIFY(timeline().frameCount() >= 10 * fps);
        drop("second", 150);
        QCOMPARE(keys().size(), 2U);
        QCOMPARE(keys()[1].time, 150 / fps);
        QVERIFY(timeline().frameCount() >= 150 + 2 * fps);
        // What is held at the end makes more.
        const int before = timeline().frameCount();
        QTest::mousePress(&timeline(), Qt::LeftButton, {}, markOf(1));
        const QPoint end(timeline().width() - 3, markOf(1).y());
        QTest::mouseMove(&timeline(), end - QPoint(20, 0));
        QTest::mouseMove(&timeline(), end);
        QTRY_VERIFY(timeline().frameCount() > before + 20);
        QTest::mouseRelease(&timeline(), Qt::LeftButton, {}, end);
        QVERIFY(keys()[1].time * fps > before);
    }

    void thePlayheadAndItsNumberAgreeInEachAnimation()
    {
        drop("first", 10);
        drop("second", 60);
        QVERIFY(test::waitForResult(context(), "pose"));
        QTRY_VERIFY(m_window->animate().view().scene().frameCount() > 30);
        auto* number = m_window->animate().findChild<QSpinBox*>("frameField");
        const auto agree = [&] { return number->value() == timeline().currentFrame(); };
        // Behind the end of the clip, where keys can be put.
        const int behind = timeline().frameCount() - 5;
        QTest::mouseClick(&timeline(), Qt::LeftButton, {},
                          {timeline().xOfFrame(behind), timeline().rulerRect().center().y()});
        QCOMPARE(timeline().currentFrame(), behind);
        QVERIFY(agree());
        context().actions.action("animate.new")->trigger();
        QTRY_VERIFY(context().selection.shownAnimation() != "pose");
        QVERIFY2(agree(),
                 qPrintable(QStringLiteral("%1 %2").arg(number->value()).arg(timeline().currentFrame())));
        context().selection.selectAnimations({"pose"});
        QTRY_VERIFY(m_window->animate().view().scene().frameCount() > 30);
        QVERIFY2(agree(),
                 qPrintable(QStringLiteral("%1 %2").arg(number->value()).arg(timeline().currentFrame())));
    }

    void aDoubleClickInTheTableGoesToTheKey()
    {
        drop("first", 10);
        drop("second", 60);
        QVERIFY(test::waitForResult(context(), "pose"));
        auto* table = test::find<QTableView>("keysTable");
        QTRY_VERIFY(table->isVisible());
        const QRect place = table->visualRect(table->model()->index(1, KeysModel::Pose));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, place.center());
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, place.center());
        const auto obtained = context().animations.result("pose")->walk.solution.keys[1].obtained;
        QCOMPARE(timeline().currentFrame(), static_cast<int>(obtained));
        QTRY_COMPARE(m_window->animate().player().frame(), FrameIndex(obtained));
    }

    void thePoseThatIsShownIsAddedAsKeyFromTheSequencesToo()
    {
        context().actions.action("workspace.sequences")->trigger();
        context().selection.selectSequences({"second"});
        QTRY_COMPARE(m_window->sequences().scene().frameCount(), 60);
        m_window->sequences().player().goTo(17);
        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ShiftModifier);
        QCOMPARE(keys().size(), 1U);
        QCOMPARE(keys()[0].sequence, "second");
        QCOMPARE(keys()[0].frame, FrameIndex(17));
        // A second one does not come onto the first.
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ShiftModifier);
        QCOMPARE(keys().size(), 2U);
        QVERIFY(keys()[1].time > keys()[0].time);
    }

    void theRangeThatPlaysIsSetWithoutTrimmingATakeThatIsNotSeen()
    {
        drop("first", 10);
        drop("second", 60);
        QVERIFY(test::waitForResult(context(), "pose"));
        QTRY_VERIFY(m_window->animate().view().scene().frameCount() > 30);
        const Project before = context().document.project();
        QVERIFY(test::activate(*m_window));
        timeline().setFocus();
        timeline().setCurrentFrame(12);
        QTest::keyClick(&timeline(), Qt::Key_I);
        QCOMPARE(timeline().playedRange().first, 12);
        QCOMPARE(context().document.project(), before);
    }

    void keysBesideAPathAndActionsStayInTheirList()
    {
        AnimationEntry entry;
        entry.constraints = {PathEntry(), KeyEntry{.sequence = "a", .time = 2}, ActionEntry(),
                             KeyEntry{.sequence = "b", .time = 4}};
        std::vector<KeyEntry> changed = keysOf(entry);
        changed[0].time = 9;
        changed.push_back({.sequence = "c", .time = 1});
        setKeys(entry, changed);
        QCOMPARE(entry.constraints.size(), 5U);
        QVERIFY(std::holds_alternative<PathEntry>(entry.constraints[0]));
        QVERIFY(std::holds_alternative<ActionEntry>(entry.constraints[2]));
        QCOMPARE(keysOf(entry)[0].sequence, "c");
        QCOMPARE(keysOf(entry)[1].sequence, "b");
        QCOMPARE(keysOf(entry)[2].sequence, "a");
        QCOMPARE(freeKeyTime(keysOf(entry), 4, 25), 4.04);
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::AnimateKeysTest);
#include "tst_animatekeys.moc"
