// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/timeline/timeline.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

namespace {

const SpanRef early{QStringLiteral("keys"), 1};
const SpanRef late{QStringLiteral("keys"), 2};

TimelineTrack keysTrack()
{
    TimelineTrack track;
    track.id = QStringLiteral("keys");
    track.title = QStringLiteral("Keys");
    track.kind = TimelineTrack::Kind::Keys;
    track.editable = true;
    track.keys = {{1, 20, 24.0, 3.0, QStringLiteral("dance 40"), {}},
                  {2, 60, std::nullopt, std::nullopt, QStringLiteral("walk 3"), {}}};
    return track;
}

TimelineTrack clipTrack()
{
    TimelineTrack track;
    track.id = QStringLiteral("clip");
    track.title = QStringLiteral("Clip");
    track.kind = TimelineTrack::Kind::Clips;
    track.spans = {{10, 0, 47, QStringLiteral("dance"), Qt::darkGreen, false},
                   {11, 53, 99, QStringLiteral("walk"), Qt::darkGreen, false},
                   {12, 48, 52, {}, Qt::red, true}};
    return track;
}

} // namespace

class TestTimelineKeys : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void draggingAKeyMovesItAlongTheFrames();
    void aDraggedKeySnapsToOtherMarksUnlessAltIsHeld();
    void escapePutsADraggedKeyBack();
    void keysAreMovedDeletedAndEditedByKeyboard();
    void insertAndDoubleClickAskForAKey();
    void aPictureOfAnotherKeyIsSelectedByItsPicture();
    void framesAreDroppedWhereTheMarkIs();
    void otherDataIsNotTaken();
    void wantedAndObtainedTimesAreBothDrawn();
    void junctionsAreFoundByPointerAndByKeyboard();

private:
    std::unique_ptr<Timeline> m_timeline;

    QPoint markOf(const SpanRef& key) const
    {
        const QRect rect = m_timeline->spanRect(key);
        return {rect.left() + rect.width() / 2, rect.top() + 8};
    }
    QPoint atFrame(int frame) const
    {
        return {m_timeline->xOfFrame(frame), m_timeline->trackRect(QStringLiteral("keys")).top() + 8};
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {},
              bool escape = false);
    void drop(const QMimeData& data, const QPoint& place);
};

void TestTimelineKeys::init()
{
    m_timeline = std::make_unique<Timeline>();
    m_timeline->setFrameCount(100);
    m_timeline->setFps(25);
    m_timeline->setTracks({keysTrack(), clipTrack()});
    m_timeline->setDropTrack(QStringLiteral("keys"));
    m_timeline->resize(1100, 180);
    m_timeline->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_timeline.get()));
    m_timeline->setFocus();
}

void TestTimelineKeys::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers,
                            bool escape)
{
    QTest::mousePress(m_timeline.get(), Qt::LeftButton, modifiers, from);
    for (int step = 1; step <= 4; ++step) {
        const QPointF place = from + (to - from) * step / 4;
        QMouseEvent move(QEvent::MouseMove, place, m_timeline->mapToGlobal(place), Qt::NoButton,
                         Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(m_timeline.get(), &move);
    }
    if (escape)
        QTest::keyClick(m_timeline.get(), Qt::Key_Escape);
    QTest::mouseRelease(m_timeline.get(), Qt::LeftButton, modifiers, to);
}

void TestTimelineKeys::drop(const QMimeData& data, const QPoint& place)
{
    QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_timeline.get(), &enter);
    if (!enter.isAccepted())
        return;
    QDragMoveEvent move(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_timeline.get(), &move);
    QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_timeline.get(), &event);
}

void TestTimelineKeys::draggingAKeyMovesItAlongTheFrames()
{
    QSignalSpy moved(m_timeline.get(), &Timeline::keyMoved);
    drag(markOf(early), atFrame(35));
    QVERIFY(moved.size() >= 2);
    QVERIFY(!moved.first().at(2).toBool());
    QCOMPARE(moved.last().at(0).value<SpanRef>(), early);
    QCOMPARE(moved.last().at(1).toInt(), 35);
    QVERIFY(moved.last().at(2).toBool());
    QCOMPARE(m_timeline->tracks().at(0).keys.at(0).frame, 20.0);
    QCOMPARE(m_timeline->selectedSpan(), std::optional(early));
    QCOMPARE(m_timeline->currentFrame(), 0);
}

void TestTimelineKeys::aDraggedKeySnapsToOtherMarksUnlessAltIsHeld()
{
    // With 2 pixels a frame, the junction's first frame is within reach.
    m_timeline->resize(300, 180);
    QSignalSpy moved(m_timeline.get(), &Timeline::keyMoved);
    drag(markOf(early), atFrame(46));
    QCOMPARE(moved.last().at(1).toInt(), 47);
    drag(markOf(early), atFrame(45), Qt::AltModifier);
    QCOMPARE(moved.last().at(1).toInt(), 45);
}

void TestTimelineKeys::escapePutsADraggedKeyBack()
{
    QSignalSpy moved(m_timeline.get(), &Timeline::keyMoved);
    drag(markOf(early), atFrame(35), {}, true);
    QCOMPARE(moved.last().at(1).toInt(), 20);
    QVERIFY(moved.last().at(2).toBool());
}

void TestTimelineKeys::keysAreMovedDeletedAndEditedByKeyboard()
{
    QSignalSpy moved(m_timeline.get(), &Timeline::keyMoved);
    QSignalSpy deleted(m_timeline.get(), &Timeline::spanDeletionRequested);
    QSignalSpy activated(m_timeline.get(), &Timeline::spanActivated);
    QTest::keyClick(m_timeline.get(), Qt::Key_Down);
    QTest::keyClick(m_timeline.get(), Qt::Key_Down);
    QCOMPARE(m_timeline->selectedSpan(), std::optional(late));
    QTest::keyClick(m_timeline.get(), Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(moved.last().at(1).toInt(), 59);
    QTest::keyClick(m_timeline.get(), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(moved.last().at(1).toInt(), 70);
    QTest::keyClick(m_timeline.get(), Qt::Key_Return);
    QCOMPARE(activated.last().at(0).value<SpanRef>(), late);
    QTest::keyClick(m_timeline.get(), Qt::Key_Delete);
    QCOMPARE(deleted.last().at(0).value<SpanRef>(), late);
}

void TestTimelineKeys::insertAndDoubleClickAskForAKey()
{
    QSignalSpy created(m_timeline.get(), &Timeline::spanCreated);
    m_timeline->setCurrentFrame(33);
    QTest::keyClick(m_timeline.get(), Qt::Key_Insert);
    QCOMPARE(created.last().at(1).toInt(), 33);
    QTest::mouseDClick(m_timeline.get(), Qt::LeftButton, {}, atFrame(80));
    QCOMPARE(created.last().at(1).toInt(), 80);
    QCOMPARE(created.last().at(2).toInt(), 80);
}

void TestTimelineKeys::aPictureOfAnotherKeyIsSelectedByItsPicture()
{
    const QRect rect = m_timeline->spanRect(late);
    QTest::mouseClick(m_timeline.get(), Qt::LeftButton, {}, {rect.center().x(), rect.bottom() - 4});
    QCOMPARE(m_timeline->selectedSpan(), std::optional(late));
    QTest::mouseClick(m_timeline.get(), Qt::LeftButton, {}, atFrame(90));
    QCOMPARE(m_timeline->selectedSpan(), std::optional<SpanRef>());
    QCOMPARE(m_timeline->currentFrame(), 90);
}

void TestTimelineKeys::framesAreDroppedWhereTheMarkIs()
{
    QSignalSpy dropped(m_timeline.get(), &Timeline::framesDropped);
    const DraggedFrames frames{QStringLiteral("dance"), 40, {}};
    const auto data = toMimeData({frames});
    const QPoint onRuler(m_timeline->xOfFrame(75), m_timeline->rulerRect().center().y());
    const QImage before = m_timeline->grab().toImage();
    QDragEnterEvent enter(onRuler, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_timeline.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDragMoveEvent move(onRuler, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_timeline.get(), &move);
    QVERIFY(m_timeline->grab().toImage() != before); // the mark
    drop(*data, onRuler);
    QCOMPARE(dropped.size(), 1);
    QCOMPARE(dropped.at(0).at(0).toString(), QStringLiteral("keys"));
    QCOMPARE(dropped.at(0).at(1).toInt(), 75);
    QCOMPARE(dropped.at(0).at(2).value<DraggedFrames>(), frames);
    QCOMPARE(m_timeline->grab().toImage(), before);
}

void TestTimelineKeys::otherDataIsNotTaken()
{
    QSignalSpy dropped(m_timeline.get(), &Timeline::framesDropped);
    QMimeData text;
    text.setText(QStringLiteral("dance"));
    drop(text, atFrame(75));
    drop(*toMimeData({{{}, 0, QStringLiteral("kick")}}), atFrame(75));
    m_timeline->setDropTrack({});
    drop(*toMimeData({{QStringLiteral("dance"), 40, {}}}), atFrame(75));
    QVERIFY(dropped.isEmpty());
}

void TestTimelineKeys::wantedAndObtainedTimesAreBothDrawn()
{
    const auto colourAt = [this](const QPoint& place) {
        return m_timeline->grab().toImage().pixelColor(place);
    };
    TimelineTrack track = keysTrack();
    track.keys.resize(1);
    track.keys[0].obtained.reset();
    track.keys[0].tolerance.reset();
    m_timeline->setTracks({track, clipTrack()});
    const QPoint wanted = atFrame(20);
    const QPoint between((atFrame(20).x() + atFrame(26).x()) / 2, wanted.y());
    const QColor ground = colourAt(between);
    QVERIFY(colourAt(wanted) != ground);
    track.keys[0].obtained = 26;
    m_timeline->setTracks({track, clipTrack()});
    QVERIFY(colourAt(wanted) != ground);
    QVERIFY(colourAt(between) != ground);
    track.keys[0].obtained.reset();
    track.keys[0].tolerance = 5;
    m_timeline->setTracks({track, clipTrack()});
    QVERIFY(colourAt(between) != ground);
}

void TestTimelineKeys::junctionsAreFoundByPointerAndByKeyboard()
{
    QSignalSpy hovered(m_timeline.get(), &Timeline::spanHovered);
    const SpanRef junction{QStringLiteral("clip"), 12};
    const QPoint centre = m_timeline->spanRect(junction).center();
    QTest::mouseMove(m_timeline.get(), centre);
    QTRY_COMPARE(hovered.size(), 1);
    QCOMPARE(hovered.at(0).at(0).value<std::optional<SpanRef>>(), std::optional(junction));
    QTest::mouseClick(m_timeline.get(), Qt::LeftButton, {}, centre);
    QCOMPARE(m_timeline->selectedSpan(), std::optional(junction));
    QTest::keyClick(m_timeline.get(), Qt::Key_Up);
    QCOMPARE(m_timeline->selectedSpan(), std::optional(SpanRef{QStringLiteral("clip"), 10}));
    QTest::keyClick(m_timeline.get(), Qt::Key_Down);
    QTest::keyClick(m_timeline.get(), Qt::Key_Down);
    QCOMPARE(m_timeline->selectedSpan(), std::optional(SpanRef{QStringLiteral("clip"), 11}));
    QSignalSpy deleted(m_timeline.get(), &Timeline::spanDeletionRequested);
    QTest::keyClick(m_timeline.get(), Qt::Key_Delete);
    QVERIFY(deleted.isEmpty());
}

QUADRILLE_QT_TEST(TestTimelineKeys);
#include "tst_timelinekeys.moc"
