// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/controls/elidedpair.h"
#include "widgets/timeline/momentlane.h"
#include "widgets/timeline/timeline.h"
#include "widgets/timeline/timelinezoombar.h"

#include <QApplication>
#include <QPaintEvent>
#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

namespace {

/// What is painted of that it watches.
struct Painted : public QObject
{
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::Paint)
            region += static_cast<QPaintEvent*>(event)->region();
        return false;
    }
    QRegion region;
};

} // namespace

class TestTimeline : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void clickingTheRulerMovesThePlayhead();
    void keysStepAndJump();
    void draggingASpansEdgeReportsTheEditAndChangesNothing();
    void draggingInAnEmptyTrackMakesASpan();
    void escapeTakesADragBack();
    void deleteAsksForTheSelectedSpan();
    void zoomKeepsWhatIsUnderThePointer();
    void thePlayheadLeavesNothingBehind();
    void lanesFollowAtOnce();
    void theEndsOfTheBarZoomAndADoubleClickShowsAll();
    void aDragOverTheRulerWithShiftMarksALoop();
    void aTitleFoldsItsRowAndItsEdgeSizesIt();
    void notesAreMadeMovedAndNamed();
    void namesOfTransitionsShowBothEnds();

private:
    std::unique_ptr<Timeline> m_timeline;
    QPoint atFrame(int frame, const QRect& row) const
    {
        return {m_timeline->xOfFrame(frame) + 1, row.center().y()};
    }
    void drag(const QPoint& from, const QPoint& to, bool escape = false);
};

void TestTimeline::init()
{
    m_timeline = std::make_unique<Timeline>();
    m_timeline->setFrameCount(100);
    m_timeline->setFps(25);
    m_timeline->setTracks(
        {{"labels", "Labels", TimelineTrack::Kind::Labels, true, {{1, 10, 39, "walk", Qt::blue, false}}}});
    m_timeline->resize(900, 160);
    m_timeline->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_timeline.get()));
}

void TestTimeline::drag(const QPoint& from, const QPoint& to, bool escape)
{
    QTest::mousePress(m_timeline.get(), Qt::LeftButton, {}, from);
    for (int step = 1; step <= 4; ++step)
        QTest::mouseMove(m_timeline.get(), from + (to - from) * step / 4);
    if (escape)
        QTest::keyClick(m_timeline.get(), Qt::Key_Escape);
    QTest::mouseRelease(m_timeline.get(), Qt::LeftButton, {}, to);
}

void TestTimeline::clickingTheRulerMovesThePlayhead()
{
    QSignalSpy scrubbed(m_timeline.get(), &Timeline::frameScrubbed);
    QTest::mouseClick(m_timeline.get(), Qt::LeftButton, {}, atFrame(60, m_timeline->rulerRect()));
    QVERIFY(!scrubbed.isEmpty());
    QCOMPARE(scrubbed.last().at(0).toInt(), 60);
    QCOMPARE(m_timeline->currentFrame(), 60);
}

void TestTimeline::keysStepAndJump()
{
    m_timeline->setFocus();
    m_timeline->setCurrentFrame(5);
    QTest::keyClick(m_timeline.get(), Qt::Key_Right);
    QCOMPARE(m_timeline->currentFrame(), 6);
    QTest::keyClick(m_timeline.get(), Qt::Key_End);
    QCOMPARE(m_timeline->currentFrame(), 99);
    QTest::keyClick(m_timeline.get(), Qt::Key_Right);
    QCOMPARE(m_timeline->currentFrame(), 99);
    QTest::keyClick(m_timeline.get(), Qt::Key_Home);
    QCOMPARE(m_timeline->currentFrame(), 0);
}

void TestTimeline::draggingASpansEdgeReportsTheEditAndChangesNothing()
{
    QSignalSpy edited(m_timeline.get(), &Timeline::spanEdited);
    const QRect span = m_timeline->spanRect({"labels", 1});
    drag({span.right() - 1, span.center().y()}, atFrame(55, span));
    QVERIFY(!edited.isEmpty());
    QCOMPARE(edited.last().at(1).toInt(), 10);
    QVERIFY(std::abs(edited.last().at(2).toInt() - 55) <= 1); // the edge lies between two frames
    QVERIFY(edited.last().at(3).toBool());
    QCOMPARE(m_timeline->tracks().at(0).spans.at(0).last, 39);
}

void TestTimeline::draggingInAnEmptyTrackMakesASpan()
{
    QSignalSpy created(m_timeline.get(), &Timeline::spanCreated);
    const QRect row = m_timeline->trackRect("labels");
    drag(atFrame(60, row), atFrame(80, row));
    QCOMPARE(created.size(), 1);
    QCOMPARE(created.at(0).at(1).toInt(), 60);
    QVERIFY(std::abs(created.at(0).at(2).toInt() - 80) <= 1);
}

void TestTimeline::escapeTakesADragBack()
{
    QSignalSpy edited(m_timeline.get(), &Timeline::spanEdited);
    const QRect span = m_timeline->spanRect({"labels", 1});
    drag({span.right() - 1, span.center().y()}, atFrame(55, span), true);
    QVERIFY(!edited.isEmpty());
    QCOMPARE(edited.last().at(2).toInt(), 39);
}

void TestTimeline::deleteAsksForTheSelectedSpan()
{
    QSignalSpy deletion(m_timeline.get(), &Timeline::spanDeletionRequested);
    m_timeline->setFocus();
    QTest::keyClick(m_timeline.get(), Qt::Key_Delete);
    QVERIFY(deletion.isEmpty());
    m_timeline->setSelectedSpan(SpanRef{"labels", 1});
    QTest::keyClick(m_timeline.get(), Qt::Key_Delete);
    QCOMPARE(deletion.size(), 1);
}

void TestTimeline::zoomKeepsWhatIsUnderThePointer()
{
    TimelineScale scale;
    scale.setFrameCount(1000);
    scale.setWidth(500);
    scale.fit();
    const double frame = scale.frameAt(200);
    scale.zoom(4, 200);
    QVERIFY(std::abs(scale.frameAt(200) - frame) < 1e-6);
    QVERIFY(!scale.isFitted());
}

void TestTimeline::thePlayheadLeavesNothingBehind()
{
    for (const auto unit : {Timeline::Unit::Frames, Timeline::Unit::Seconds}) {
        m_timeline->setUnit(unit);
        for (const auto& [from, to] : {std::pair{99, 40}, {0, 60}, {50, 51}, {98, 3}}) {
            m_timeline->setCurrentFrame(from);
            QCoreApplication::processEvents();
            const QImage before = m_timeline->grab().toImage();
            Painted painted;
            m_timeline->installEventFilter(&painted);
            m_timeline->setCurrentFrame(to);
            QTRY_VERIFY(!painted.region.isEmpty());
            m_timeline->removeEventFilter(&painted);
            const QImage after = m_timeline->grab().toImage();
            // All that is another picture now was painted.
            const double scale = m_timeline->devicePixelRatioF();
            for (int y = 0; y < after.height(); ++y)
                for (int x = 0; x < after.width(); ++x)
                    if (before.pixel(x, y) != after.pixel(x, y) &&
                        !painted.region.contains(QPointF(x / scale, y / scale).toPoint()))
                        QFAIL(
                            qPrintable(QStringLiteral("%1 to %2: (%3, %4)").arg(from).arg(to).arg(x).arg(y)));
        }
    }
}

void TestTimeline::lanesFollowAtOnce()
{
    // Not only once the timeline was painted, as then the lane's playhead is a picture late.
    MomentLane lane(*m_timeline);
    lane.show();
    QVERIFY(QTest::qWaitForWindowExposed(&lane));
    QTest::qWait(50);
    Painted painted;
    lane.installEventFilter(&painted);
    m_timeline->hide();
    m_timeline->setCurrentFrame(30);
    QTRY_VERIFY(!painted.region.isEmpty());
    painted.region = {};
    m_timeline->zoomBy(2.0);
    QTRY_VERIFY(!painted.region.isEmpty());
}

void TestTimeline::theEndsOfTheBarZoomAndADoubleClickShowsAll()
{
    auto* bar = m_timeline->findChild<TimelineZoomBar*>();
    QVERIFY(bar->isVisible());
    QVERIFY(TimelineZoomBar::handleWidth >= 12);
    QVERIFY(m_timeline->scale().isFitted());
    const auto dragBar = [bar](const QPoint& from, const QPoint& to) {
        QTest::mousePress(bar, Qt::LeftButton, {}, from);
        QTest::mouseMove(bar, (from + to) / 2);
        QTest::mouseMove(bar, to);
        QTest::mouseRelease(bar, Qt::LeftButton, {}, to);
    };
    const int middle = bar->height() / 2;
    // Eleven pixels from the end still take hold of it.
    dragBar({bar->width() - 12, middle}, {bar->width() / 2, middle});
    QVERIFY(std::abs(m_timeline->scale().visibleFrames() - 50) < 3);
    QCOMPARE(m_timeline->scale().firstVisible(), 0.0);
    dragBar({bar->partRect().left() + 11, middle}, {bar->partRect().left() + 11 + bar->width() / 4, middle});
    QVERIFY(std::abs(m_timeline->scale().firstVisible() - 25) < 3);
    QVERIFY(std::abs(m_timeline->scale().visibleFrames() - 25) < 4);
    // Its middle scrolls.
    dragBar(bar->partRect().center(), {bar->width(), middle});
    QVERIFY(std::abs(m_timeline->scale().firstVisible() + m_timeline->scale().visibleFrames() - 100) < 0.5);
    QVERIFY(std::abs(m_timeline->scale().visibleFrames() - 25) < 4);
    QTest::mouseDClick(bar, Qt::LeftButton, {}, bar->partRect().center());
    QVERIFY(m_timeline->scale().isFitted());
}

void TestTimeline::aDragOverTheRulerWithShiftMarksALoop()
{
    QSignalSpy edited(m_timeline.get(), &Timeline::loopEdited);
    QSignalSpy removed(m_timeline.get(), &Timeline::loopRemovalRequested);
    QSignalSpy scrubbed(m_timeline.get(), &Timeline::frameScrubbed);
    const QRect ruler = m_timeline->rulerRect();
    QTest::mousePress(m_timeline.get(), Qt::LeftButton, Qt::ShiftModifier, atFrame(20, ruler));
    QTest::mouseMove(m_timeline.get(), atFrame(40, ruler));
    QTest::mouseMove(m_timeline.get(), atFrame(50, ruler));
    QTest::mouseRelease(m_timeline.get(), Qt::LeftButton, Qt::ShiftModifier, atFrame(50, ruler));
    QCOMPARE(edited.last(), (QList<QVariant>{20, 50, true}));
    QVERIFY(scrubbed.isEmpty());
    m_timeline->setLoop(std::pair(20, 50));
    QCOMPARE(m_timeline->playedRange(), (std::pair{20, 50}));
    QCOMPARE(m_timeline->range(), (std::pair{0, 99}));
    // Its ends are dragged at the top of the ruler.
    const int top = ruler.top() + 3;
    drag({(m_timeline->xOfFrame(50) + m_timeline->xOfFrame(51)) / 2, top}, {m_timeline->xOfFrame(70), top});
    QCOMPARE(edited.last().at(0).toInt(), 20);
    QVERIFY(std::abs(edited.last().at(1).toInt() - 70) <= 1);
    m_timeline->setFocus();
    m_timeline->setCurrentFrame(30);
    m_timeline->setRangeEditable(false);
    QTest::keyClick(m_timeline.get(), Qt::Key_I);
    QCOMPARE(edited.last(), (QList<QVariant>{30, 50, true}));
    QVERIFY(removed.isEmpty());
    QTest::mouseClick(m_timeline.get(), Qt::LeftButton, Qt::ShiftModifier, atFrame(80, ruler));
    QCOMPARE(removed.size(), 1);
}

void TestTimeline::aTitleFoldsItsRowAndItsEdgeSizesIt()
{
    QSignalSpy edited(m_timeline.get(), &Timeline::rowsEdited);
    const QRect usual = m_timeline->trackRect("labels");
    const QPoint title = m_timeline->titleRect("labels").center();
    QTest::mouseClick(m_timeline.get(), Qt::LeftButton, {}, title);
    QVERIFY(m_timeline->isFolded("labels"));
    QVERIFY(m_timeline->trackRect("labels").height() < usual.height());
    QTest::mouseClick(m_timeline.get(), Qt::LeftButton, {}, m_timeline->titleRect("labels").center());
    QCOMPARE(m_timeline->trackRect("labels"), usual);
    const QPoint edge(title.x(), usual.bottom() + 2);
    drag(edge, edge + QPoint(0, 40));
    QCOMPARE(m_timeline->trackRect("labels").height(), usual.height() + 40);
    QCOMPARE(m_timeline->rows(), (std::vector<TimelineRow>{{"labels", usual.height() + 40, false}}));
    QCOMPARE(edited.size(), 3);
    QTest::mouseDClick(m_timeline.get(), Qt::LeftButton, {}, edge + QPoint(0, 40));
    QCOMPARE(m_timeline->trackRect("labels"), usual);
    QVERIFY(m_timeline->rows().empty());
}

void TestTimeline::notesAreMadeMovedAndNamed()
{
    QSignalSpy created(m_timeline.get(), &Timeline::spanCreated);
    QSignalSpy edited(m_timeline.get(), &Timeline::spanEdited);
    QSignalSpy activated(m_timeline.get(), &Timeline::spanActivated);
    m_timeline->setTracks(
        {{"notes",
          "Notes",
          TimelineTrack::Kind::Notes,
          true,
          {{0, 20, 20, "the left hand slips", {}, false}, {1, 30, 30, "good", {}, false}}}});
    const QRect row = m_timeline->trackRect("notes");
    const QRect first = m_timeline->spanRect({"notes", 0});
    const QRect second = m_timeline->spanRect({"notes", 1});
    QVERIFY(first.right() < second.left() + 1); // words end where the next note begins
    QVERIFY(first.contains(QPoint(m_timeline->xOfFrame(20), row.center().y())));
    QTest::mouseDClick(m_timeline.get(), Qt::LeftButton, {}, first.center());
    QCOMPARE(activated.size(), 1);
    QTest::mouseDClick(m_timeline.get(), Qt::LeftButton, {}, atFrame(70, row));
    QCOMPARE(created.last(), (QList<QVariant>{QString("notes"), 70, 70}));
    drag(second.center(), second.center() + QPoint(m_timeline->xOfFrame(60) - m_timeline->xOfFrame(30), 0));
    QVERIFY(std::abs(edited.last().at(1).toInt() - 60) <= 1);
    QCOMPARE(edited.last().at(1), edited.last().at(2));
}

void TestTimeline::namesOfTransitionsShowBothEnds()
{
    const QFontMetrics metrics(m_timeline->font());
    const QString whole = pairText("a very long walk 12", "another very long run 34");
    QCOMPARE(elidedPair(whole, metrics, 10000), whole);
    const QString shown = elidedPair(whole, metrics, metrics.horizontalAdvance(whole) / 2);
    QVERIFY(metrics.horizontalAdvance(shown) <= metrics.horizontalAdvance(whole) / 2);
    QVERIFY2(shown.startsWith("a") && shown.contains(" › a") && shown.endsWith("4"), qPrintable(shown));
    // What a short name leaves is the other one's.
    const QString uneven = pairText("a", "another very long run 34");
    QVERIFY(elidedPair(uneven, metrics, metrics.horizontalAdvance(uneven) - 8).startsWith("a › "));
}

namespace {

/// Lines that lie between pixels are where painting goes wrong.
class ScaledApplication : public QApplication
{
public:
    ScaledApplication(int& argc, char** argv) : QApplication((qputenv("QT_SCALE_FACTOR", "1.25"), argc), argv)
    {
    }
};

} // namespace

QUADRILLE_QT_TEST_IN(ScaledApplication, TestTimeline);

#include "tst_timeline.moc"
