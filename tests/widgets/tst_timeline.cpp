// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timeline.h"

#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

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
    QSignalSpy deletion(m_timeline.get(), &Timeline::spanDeletionAsked);
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

QTEST_MAIN(TestTimeline)
#include "tst_timeline.moc"
