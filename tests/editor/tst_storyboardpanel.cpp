// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A storyboard of takes and labels: made, put into another order and cut by hand, with real mouse and keys.
#include "animatedproject.h"
#include "dropping.h"
#include "editor/playback/player.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "editor/workspaces/animate/keysandstoryboard.h"
#include "tests/qt/registry.h"
#include "widgets/storyboard/rangestrip.h"
#include "widgets/storyboard/storyboard.h"
#include "widgets/timeline/timeline.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QListView>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>

namespace quadrille {

class StoryboardPanelTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    widgets::Storyboard& board() { return *test::find<widgets::Storyboard>("storyboard"); }
    std::vector<ActionEntry> actions()
    {
        const AnimationEntry* entry = context().document.animation("story");
        return entry == nullptr ? std::vector<ActionEntry>() : actionsOf(*entry);
    }
    std::vector<std::string> order()
    {
        std::vector<std::string> names;
        for (const ActionEntry& action : actions())
            names.push_back(action.frames.sequence + action.frames.label);
        return names;
    }
    void drop(const QMimeData& data, int before)
    {
        test::drop(data, *board().viewport(), {before * 128 + 6, 40});
    }
    void dropRow(const QString& list, int row, int before)
    {
        auto* view = test::find<QListView>(list);
        const std::unique_ptr<QMimeData> data(view->model()->mimeData({view->model()->index(row, 0)}));
        drop(*data, before);
    }
    void dropTakes()
    {
        for (int row = 0; row < 3; ++row)
            dropRow("cards", row, row);
    }

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
        project.sequences[0].labels = {{"sway", {FrameIndex(5), FrameIndex(25)}}};
        project.animations[0].name = "story";
        project.animations[0].constraints.clear();
        context().document.reset(project);
        for (const char* take : {"first", "second", "third"})
            QVERIFY(test::waitForSequence(*m_window, take));
        context().actions.action("workspace.animate")->trigger();
        context().selection.selectAnimations({"story"});
        test::find<QDockWidget>("storyboardDock")->show(); // low windows begin without it
        test::find<QDockWidget>("storyboardDock")->raise();
        QTRY_VERIFY(board().isVisible());
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void threeActionsAreDroppedReorderedAndUndone()
    {
        const Project before = context().document.project();
        dropTakes();
        QCOMPARE(order(), (std::vector<std::string>{"first", "second", "third"}));
        QCOMPARE(board().cards().size(), 3U);

        // The last card is dragged before the first, then brought back by one with the keyboard.
        const QPoint from = board().cardRect(2).center();
        const QPoint to = board().cardRect(0).center() - QPoint(58, 0);
        QTest::mousePress(board().viewport(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 4; ++step)
            QTest::mouseMove(board().viewport(), from + (to - from) * step / 4);
        QTest::mouseRelease(board().viewport(), Qt::LeftButton, {}, to);
        QCOMPARE(order(), (std::vector<std::string>{"third", "first", "second"}));
        QCOMPARE(board().current(), 0);
        board().setFocus();
        QTest::keyClick(&board(), Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(order(), (std::vector<std::string>{"first", "third", "second"}));
        QCOMPARE(board().current(), 1);
        QTest::keyClick(&board(), Qt::Key_D, Qt::ControlModifier);
        QTest::keyClick(&board(), Qt::Key_Delete);
        QCOMPARE(order(), (std::vector<std::string>{"first", "third", "second"}));
        const Project after = context().document.project();

        while (context().document.canUndo())
            context().document.undo();
        QCOMPARE(context().document.project(), before);
        QVERIFY(board().cards().empty());
        while (context().document.undoStack()->canRedo())
            context().document.redo();
        QCOMPARE(context().document.project(), after);
    }

    void aRangeIsChosenByHandInOneStep()
    {
        dropTakes();
        QTest::mouseClick(board().viewport(), Qt::LeftButton, {}, board().cardRect(1).center());
        auto* strip = test::find<widgets::RangeStrip>("actionRange");
        QTRY_COMPARE(strip->frameCount(), 60);
        const int steps = context().document.undoStack()->index();
        const QPoint handle = strip->startHandle();
        QTest::mousePress(strip, Qt::LeftButton, {}, handle);
        QTest::mouseMove(strip, handle + QPoint(20, 0));
        QTest::mouseMove(strip, handle + QPoint(60, 0));
        QTest::mouseRelease(strip, Qt::LeftButton, {}, handle + QPoint(60, 0));
        QVERIFY(actions()[1].frames.range.has_value());
        const FrameRange range = *actions()[1].frames.range;
        QVERIFY(range.first.value > 5);
        QCOMPARE(range.last, FrameIndex(59));
        QCOMPARE(context().document.undoStack()->index(), steps + 1);

        auto* last = test::find<QSpinBox>("actionLast");
        last->setFocus();
        last->selectAll();
        QTest::keyClicks(last, "40");
        QTest::keyClick(last, Qt::Key_Return);
        QCOMPARE(actions()[1].frames.range->last, FrameIndex(40));
        QVERIFY(board().cards()[1].subtitle.contains(QStringLiteral("40")));
        context().document.undo();
        context().document.undo();
        QVERIFY(!actions()[1].frames.range);
    }

    void labelsAreDroppedRepeatedAndGoOn()
    {
        dropRow("labelList", 0, 0);
        QCOMPARE(actions().size(), 1U);
        QCOMPARE(actions()[0].frames.label, "sway");
        auto* repeat = test::find<QDoubleSpinBox>("actionRepeat");
        repeat->setFocus();
        QTest::keyClick(repeat, Qt::Key_Up);
        QCOMPARE(actions()[0].repeat, 2);
        QVERIFY(board().cards()[0].badge.contains(QStringLiteral("2")));
        test::find<QCheckBox>("actionHasDuration")->click();
        QCOMPARE(actions()[0].duration, std::optional(3.0));
        auto* share = test::find<QDoubleSpinBox>("actionShare");
        QVERIFY(!share->isEnabled());
        test::find<QCheckBox>("actionHasDuration")->click();
        QCOMPARE(actions()[0].duration, std::optional<double>());
        QTest::keyClick(share, Qt::Key_Up);
        QCOMPARE(actions()[0].leastShare, std::optional(0.51));
    }

    void anEmptyStoryboardOffersTheSelectedTake()
    {
        context().selection.selectSequences({"third"});
        auto* button = test::find<QPushButton>("addFirstAction");
        QTRY_VERIFY(button->isVisible() && button->isEnabled());
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(order(), std::vector<std::string>{"third"});
        QTRY_VERIFY(!board().cards()[0].picture.isNull());
    }

    void anEmptyStoryboardIsALineWithoutWhatWouldBeCut()
    {
        auto* labels = test::find<QListView>("labelList");
        auto* values = test::find<QWidget>("actionRepeat");
        QTRY_VERIFY(board().height() < 60);
        QVERIFY(!labels->isVisible() && !values->isVisible());
        auto* button = test::find<QPushButton>("addFirstLabel");
        QVERIFY(button->isVisible() && button->isEnabled());
        QTimer::singleShot(0, button->menu(), [menu = button->menu()] {
            QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Return);
        });
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(order(), std::vector<std::string>{"sway"});
        QTRY_VERIFY(labels->isVisible() && values->isVisible());
        context().document.undo();
        QTRY_VERIFY(!labels->isVisible() && !values->isVisible());
    }

    void theClipPerformsTheActionsInTheirOrder()
    {
        dropTakes();
        QVERIFY(test::waitForResult(context(), "story"));
        const auto& tracks = m_window->animate().view().timeline().tracks();
        const auto row = std::ranges::find(tracks, QStringLiteral("actions"), &widgets::TimelineTrack::id);
        QVERIFY(row != tracks.end());
        QCOMPARE(row->spans.size(), 3U);
        QVERIFY(row->spans[0].last < row->spans[1].first);
        QVERIFY(row->spans[1].last < row->spans[2].first);
        QVERIFY(board().cards()[1].tip.contains(QLatin1Char('\n')));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::StoryboardPanelTest);
#include "tst_storyboardpanel.moc"
