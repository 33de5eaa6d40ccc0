// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/timeline/timelinegestures.h"
#include "widgets/timeline/timelinegrowth.h"
#include "widgets/timeline/timelinekeyboard.h"

#include <QGuiApplication>
#include <QSignalSpy>
#include <QTest>

using namespace quadrille::widgets;

namespace {

const SpanRef walk{QStringLiteral("labels"), 1};
const SpanRef pose{QStringLiteral("keys"), 2};
constexpr double ruler = 20;
constexpr double labels = TimelineLayout::tracksTop + 12;
constexpr double keys = labels + 28;

using Values = QList<QVariant>;
using Rows = QList<Values>;

const Rows& said(const QSignalSpy& spy)
{
    return spy;
}

} // namespace

/// A hundred frames of five pixels each, the first at 76; spans and keys have nothing within reach to snap to
/// but what is said. No window is shown.
class TestTimelineGestures : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void theRulerScrubs();
    void aPressHoldsTheSpanWhoseEdgeItIsBeside();
    void smallWaysAreNoDrags();
    void aSpanIsMovedWithItsLength();
    void edgesStopAtTheOtherEnd();
    void spansAreMadeToBothSidesAndAClickScrubs();
    void cancellingGivesTheOldValues();
    void aLoopIsDrawnAndAClickTakesItAway();
    void aKeyKeepsItsPlaceUnderThePointer();
    void theMiddleButtonScrolls();
    void titlesFoldAndEdgesSize();
    void doubleClicksNameMakeAndReset();
    void whatIsUnderThePointerIsToldOnce();
    void aDragShowsInItsTrackAlone();
    void keysOfTheKeyboardActOnWhatIsSelectedFirst();
    void endsAreSetAtThePlayhead();
    void neighboursComeInOrderOfTime();
    void theRulerGrowsWhileSomethingIsHeldAtItsEnd();

private:
    std::unique_ptr<TimelineContent> m_content;
    std::unique_ptr<TimelineLayout> m_layout;
    std::unique_ptr<TimelineGestures> m_gestures;
    std::unique_ptr<TimelineKeyboard> m_keyboard;
    static QPointF at(double frame, double y) { return {76 + 5 * frame, y}; }
    void press(const QPointF& place, Qt::KeyboardModifiers modifiers = {})
    {
        m_gestures->press(place, Qt::LeftButton, modifiers);
    }
    void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers = {})
    {
        press(from, modifiers);
        m_gestures->move(to, modifiers);
        m_gestures->release(Qt::LeftButton);
    }
};

void TestTimelineGestures::init()
{
    m_content = std::make_unique<TimelineContent>();
    m_layout = std::make_unique<TimelineLayout>(*m_content);
    m_gestures = std::make_unique<TimelineGestures>(*m_layout);
    m_keyboard = std::make_unique<TimelineKeyboard>(*m_layout);
    m_content->tracks = {{.id = walk.track, .editable = true, .spans = {{.id = 1, .first = 10, .last = 29}}},
                         {.id = pose.track,
                          .kind = TimelineTrack::Kind::Keys,
                          .editable = true,
                          .keys = {{.id = 2, .frame = 50}}}};
    m_layout->scale().setFrameCount(100);
    m_layout->setSize({576, 200});
    m_layout->fitHeader();
}

void TestTimelineGestures::theRulerScrubs()
{
    QSignalSpy scrubbed(m_gestures.get(), &TimelineIntents::scrubRequested);
    QSignalSpy scrubbing(m_gestures.get(), &TimelineIntents::scrubbingChanged);
    QSignalSpy selected(m_gestures.get(), &TimelineIntents::selectRequested);
    drag(at(40.5, 5), at(80.5, 500));
    QCOMPARE(said(scrubbed), (Rows{{40}, {80}}));
    QCOMPARE(said(scrubbing), (Rows{{true}, {false}}));
    QVERIFY(selected.isEmpty());
    QVERIFY(!m_gestures->isDragging());
}

void TestTimelineGestures::aPressHoldsTheSpanWhoseEdgeItIsBeside()
{
    QSignalSpy selected(m_gestures.get(), &TimelineIntents::selectRequested);
    press(at(9.5, labels));
    QCOMPARE(m_gestures->drag().grip.kind, TimelineGrip::Kind::SpanStart);
    QCOMPARE(selected.last().at(0).value<std::optional<SpanRef>>(), std::optional(walk));
    press(at(60, labels)); // another press takes hold of nothing else
    QCOMPARE(m_gestures->drag().grip.span, walk);
    m_gestures->release(Qt::MiddleButton);
    QVERIFY(m_gestures->isDragging());
    m_gestures->release(Qt::LeftButton);
    press(at(40, 190));
    QCOMPARE(selected.last().at(0).value<std::optional<SpanRef>>(), std::optional<SpanRef>());
}

void TestTimelineGestures::smallWaysAreNoDrags()
{
    QSignalSpy edited(m_gestures.get(), &TimelineIntents::spanEdited);
    drag(at(20, labels), at(20, labels) + QPointF(1, 1));
    QVERIFY(edited.isEmpty());
}

void TestTimelineGestures::aSpanIsMovedWithItsLength()
{
    QSignalSpy edited(m_gestures.get(), &TimelineIntents::spanEdited);
    const QVariant ref = QVariant::fromValue(walk);
    drag(at(20, labels), at(37, labels));
    QCOMPARE(said(edited), (Rows{{ref, 27, 46, false}, {ref, 27, 46, true}}));
    drag(at(20, labels), at(98, labels));
    QCOMPARE(edited.last(), (Values{ref, 80, 99, true}));
    // Its end is a frame before the playhead's edge, to which it snaps unless Alt is held.
    m_content->current = 57;
    drag(at(20, labels), at(46, labels));
    QCOMPARE(edited.last(), (Values{ref, 37, 56, true}));
    drag(at(20, labels), at(46, labels), Qt::AltModifier);
    QCOMPARE(edited.last(), (Values{ref, 36, 55, true}));
}

void TestTimelineGestures::edgesStopAtTheOtherEnd()
{
    QSignalSpy edited(m_gestures.get(), &TimelineIntents::spanEdited);
    const QVariant ref = QVariant::fromValue(walk);
    drag(at(10, labels), at(80, labels));
    QCOMPARE(edited.last(), (Values{ref, 29, 29, true}));
    drag(at(30, labels), at(60, labels));
    QCOMPARE(edited.last(), (Values{ref, 10, 59, true}));
    QSignalSpy range(m_gestures.get(), &TimelineIntents::rangeEdited);
    drag(at(100, ruler), at(70, ruler));
    QCOMPARE(range.last(), (Values{0, 69, true}));
}

void TestTimelineGestures::spansAreMadeToBothSidesAndAClickScrubs()
{
    QSignalSpy created(m_gestures.get(), &TimelineIntents::spanCreated);
    QSignalSpy scrubbed(m_gestures.get(), &TimelineIntents::scrubRequested);
    drag(at(60.5, labels), at(70.5, labels));
    drag(at(60.5, labels), at(50.5, labels));
    QCOMPARE(said(created), (Rows{{walk.track, 60, 70}, {walk.track, 50, 60}}));
    QVERIFY(scrubbed.isEmpty());
    drag(at(60.5, labels), at(60.5, labels));
    QCOMPARE(created.size(), 2);
    QCOMPARE(said(scrubbed), (Rows{{60}}));
}

void TestTimelineGestures::cancellingGivesTheOldValues()
{
    QSignalSpy edited(m_gestures.get(), &TimelineIntents::spanEdited);
    QSignalSpy created(m_gestures.get(), &TimelineIntents::spanCreated);
    QSignalSpy ended(m_gestures.get(), &TimelineIntents::dragEnded);
    press(at(20, labels));
    m_gestures->move(at(40, labels), {});
    m_gestures->cancel();
    QCOMPARE(edited.last(), (Values{QVariant::fromValue(walk), 10, 29, true}));
    press(at(60, labels));
    m_gestures->move(at(70, labels), {});
    m_gestures->cancel();
    QVERIFY(created.isEmpty());
    QCOMPARE(said(ended), (Rows{{false}, {false}}));
}

void TestTimelineGestures::aLoopIsDrawnAndAClickTakesItAway()
{
    QSignalSpy edited(m_gestures.get(), &TimelineIntents::loopEdited);
    QSignalSpy removed(m_gestures.get(), &TimelineIntents::loopRemovalRequested);
    drag(at(40.5, ruler), at(20.5, ruler), Qt::ShiftModifier);
    QCOMPARE(said(edited), (Rows{{20, 40, false}, {20, 40, true}}));
    drag(at(40.5, ruler), at(40.5, ruler), Qt::ShiftModifier);
    QCOMPARE(removed.size(), 1);
    m_content->loop = {20, 40};
    // An end does not snap to the loop that it makes.
    drag(at(41, 3), at(21.6, 3));
    QCOMPARE(edited.last(), (Values{20, 21, true}));
}

void TestTimelineGestures::aKeyKeepsItsPlaceUnderThePointer()
{
    QSignalSpy moved(m_gestures.get(), &TimelineIntents::keyMoved);
    QSignalSpy held(m_gestures.get(), &TimelineIntents::keyHeld);
    // Taken hold of by its picture, three frames right of its mark.
    const QVariant ref = QVariant::fromValue(pose);
    drag(at(53.5, keys + 30), at(73.5, keys + 30));
    QCOMPARE(said(moved), (Rows{{ref, 70, false}, {ref, 70, true}}));
    QCOMPARE(held.size(), 1);
    press(at(50.5, keys));
    m_gestures->move(at(80.5, keys), {});
    m_layout->scale().setFrameCount(200); // which fits twice as many into as many pixels
    m_gestures->holdKey(at(80.5, keys));
    QCOMPARE(moved.last(), (Values{ref, 110, false}));
}

void TestTimelineGestures::theMiddleButtonScrolls()
{
    QSignalSpy scrolled(m_gestures.get(), &TimelineIntents::scrollRequested);
    m_layout->scale().show(20, 50); // ten pixels a frame
    m_gestures->press({300, labels}, Qt::MiddleButton, {});
    m_gestures->move({250, labels}, {});
    QCOMPARE(said(scrolled), (Rows{{25.0}}));
    m_gestures->release(Qt::LeftButton);
    QVERIFY(m_gestures->isDragging());
    m_gestures->release(Qt::MiddleButton);
    QVERIFY(!m_gestures->isDragging());
}

void TestTimelineGestures::titlesFoldAndEdgesSize()
{
    QSignalSpy folded(m_gestures.get(), &TimelineIntents::foldRequested);
    QSignalSpy edited(m_gestures.get(), &TimelineIntents::rowEdited);
    press({10, labels});
    QCOMPARE(said(folded), (Rows{{walk.track}}));
    QVERIFY(!m_gestures->isDragging());
    drag({10, 72}, {10, 102});
    const QVariant sized = QVariant::fromValue(TimelineRow{.track = walk.track, .height = 54});
    QCOMPARE(said(edited), (Rows{{sized, false}, {sized, true}}));
    drag({10, 72}, {10, 1});
    QCOMPARE(edited.last().at(0).value<TimelineRow>().height, 1);
}

void TestTimelineGestures::doubleClicksNameMakeAndReset()
{
    QSignalSpy activated(m_gestures.get(), &TimelineIntents::spanActivated);
    QSignalSpy created(m_gestures.get(), &TimelineIntents::spanCreated);
    QSignalSpy edited(m_gestures.get(), &TimelineIntents::rowEdited);
    m_gestures->doubleClick(at(20, labels), Qt::LeftButton, {});
    QCOMPARE(said(activated), (Rows{{QVariant::fromValue(walk)}}));
    m_gestures->doubleClick(at(80.5, keys), Qt::LeftButton, {});
    QCOMPARE(said(created), (Rows{{pose.track, 80, 80}}));
    m_gestures->doubleClick({10, 72}, Qt::LeftButton, {});
    QCOMPARE(said(edited), (Rows{{QVariant::fromValue(TimelineRow{.track = walk.track}), true}}));
    QVERIFY(!m_gestures->isDragging());
    m_gestures->doubleClick(at(80, labels), Qt::LeftButton, {});
    QVERIFY(m_gestures->isDragging()); // as a press
}

void TestTimelineGestures::whatIsUnderThePointerIsToldOnce()
{
    QSignalSpy hovered(m_gestures.get(), &TimelineIntents::spanHovered);
    m_gestures->move(at(20, labels), {});
    m_gestures->move(at(21, labels), {});
    QCOMPARE(hovered.size(), 1);
    m_gestures->move(at(80, labels), {});
    QCOMPARE(hovered.last().at(0).value<std::optional<SpanRef>>(), std::optional<SpanRef>());
    QCOMPARE(m_gestures->cursorAt(at(10, labels)), Qt::SizeHorCursor);
    QCOMPARE(m_gestures->cursorAt(at(20, labels)), Qt::ArrowCursor);
    QCOMPARE(m_gestures->cursorAt({10, 72}), Qt::SizeVerCursor);
}

void TestTimelineGestures::aDragShowsInItsTrackAlone()
{
    const auto& tracks = m_content->tracks;
    press(at(20, labels));
    QVERIFY(!m_gestures->drag().applied(tracks[0]));
    m_gestures->move(at(37, labels), {});
    const auto applied = m_gestures->drag().applied(tracks[0]);
    QVERIFY(applied && applied->spans[0].first == 27 && applied->spans[0].last == 46);
    QVERIFY(!m_gestures->drag().applied(tracks[1]));
    m_gestures->cancel();
    press(at(50.5, keys));
    m_gestures->move(at(70.5, keys), {});
    QCOMPARE(m_gestures->drag().applied(tracks[1])->keys[0].frame, 70.0);
}

void TestTimelineGestures::keysOfTheKeyboardActOnWhatIsSelectedFirst()
{
    QSignalSpy scrubbed(m_keyboard.get(), &TimelineIntents::scrubRequested);
    QSignalSpy edited(m_keyboard.get(), &TimelineIntents::spanEdited);
    QSignalSpy moved(m_keyboard.get(), &TimelineIntents::keyMoved);
    QSignalSpy deleted(m_keyboard.get(), &TimelineIntents::spanDeletionRequested);
    QVERIFY(!m_keyboard->comesFirst(Qt::Key_Delete, {}));
    QVERIFY(!m_keyboard->press(Qt::Key_Delete, {}));
    QVERIFY(!m_keyboard->press(Qt::Key_Escape, {}));
    m_content->selected = walk;
    QVERIFY(m_keyboard->comesFirst(Qt::Key_Delete, {}) && !m_keyboard->comesFirst(Qt::Key_Left, {}));
    QVERIFY(m_keyboard->press(Qt::Key_Left, Qt::ControlModifier));
    QVERIFY(m_keyboard->press(Qt::Key_Right, Qt::ShiftModifier));
    const QVariant ref = QVariant::fromValue(walk);
    QCOMPARE(said(edited), (Rows{{ref, 9, 28, true}, {ref, 10, 30, true}}));
    QVERIFY(scrubbed.isEmpty());
    QVERIFY(m_keyboard->press(Qt::Key_Right, {}));
    QCOMPARE(said(scrubbed), (Rows{{1}}));
    m_content->selected = pose;
    QVERIFY(m_keyboard->press(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier));
    QCOMPARE(said(moved), (Rows{{QVariant::fromValue(pose), 60, true}}));
    m_content->tracks[1].editable = false;
    m_keyboard->press(Qt::Key_Delete, {});
    QVERIFY(deleted.isEmpty());
}

void TestTimelineGestures::endsAreSetAtThePlayhead()
{
    QSignalSpy range(m_keyboard.get(), &TimelineIntents::rangeEdited);
    QSignalSpy loop(m_keyboard.get(), &TimelineIntents::loopEdited);
    m_content->range = {20, 59};
    m_content->current = 70;
    m_keyboard->press(Qt::Key_I, {});
    m_keyboard->press(Qt::Key_O, {});
    QCOMPARE(said(range), (Rows{{70, 70, true}, {20, 70, true}}));
    m_content->isRangeEditable = false;
    m_content->current = 10;
    m_keyboard->press(Qt::Key_O, {});
    m_content->loop = {5, 15};
    m_keyboard->press(Qt::Key_I, {});
    QCOMPARE(said(loop), (Rows{{10, 10, true}, {10, 15, true}}));
}

void TestTimelineGestures::neighboursComeInOrderOfTime()
{
    QSignalSpy selected(m_keyboard.get(), &TimelineIntents::selectRequested);
    QSignalSpy revealed(m_keyboard.get(), &TimelineIntents::revealRequested);
    connect(m_keyboard.get(), &TimelineIntents::selectRequested, this,
            [this](const std::optional<SpanRef>& span) { m_content->selected = span; });
    m_content->tracks[0].spans.push_back({.id = 7, .first = 2, .last = 5});
    for (int press = 0; press < 4; ++press)
        m_keyboard->press(Qt::Key_Down, {});
    QCOMPARE(said(revealed), (Rows{{2}, {10}, {50}, {2}})); // and from the last to the first
    m_keyboard->press(Qt::Key_Up, {});
    QCOMPARE(selected.last().at(0).value<std::optional<SpanRef>>(), std::optional(pose));
}

void TestTimelineGestures::theRulerGrowsWhileSomethingIsHeldAtItsEnd()
{
    TimelineGrowth growth(*m_layout);
    QSignalSpy grown(&growth, &TimelineGrowth::grown);
    const auto hold = [&](double x) {
        growth.holdAt({x, labels});
        growth.holdAt({x, labels});
        return m_layout->scale().frameCount();
    };
    QCOMPARE(hold(570), 100);
    growth.setEnabled(true);
    QCOMPARE(hold(540), 100);
    QCOMPARE(hold(570), 101);
    QCOMPARE(grown.size(), 1);
    growth.stop();
    QCOMPARE(m_layout->scale().frameCount(), 101);
    growth.takeBack();
    QCOMPARE(m_layout->scale().frameCount(), 100);
}

QUADRILLE_QT_TEST_IN(QGuiApplication, TestTimelineGestures);
#include "tst_timelinegestures.moc"
