// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/qt/registry.h"
#include "widgets/timeline/timelinelayout.h"
#include "widgets/timeline/timelinesnapping.h"

#include <QGuiApplication>
#include <QTest>

using namespace quadrille::widgets;

/// A hundred frames of five pixels each, right of titles that take 76: frame f begins at 76 + 5 f.
class TestTimelineLayout : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void rowsStandBelowEachOther();
    void rowsAreFoldedAndSizedWithinLimits();
    void framesAndPixelsMatch();
    void spansHaveEndsAndAMiddle();
    void slimSpansAreTakenHoldOfBesideThem();
    void laterSpansLieAboveEarlierOnes();
    void marksOfKeysLieAbovePicturesAndTheSelectedOneAboveAll();
    void picturesStayWholeWhileTheirMarksShow();
    void notesEndAtTheNextOne();
    void theRulerHasEndsOfRangeAndLoop();
    void titlesFoldAndTheirEdgesSize();
    void onlyWhatIsEditableIsTakenHoldOf();
    void theLoopPlaysWhereItLiesInTheRange();
    void boundariesSnapToTheNearestEdge();
    void keysSnapToFramesThatAreMarked();

private:
    using Kind = TimelineGrip::Kind;
    std::unique_ptr<TimelineContent> m_content;
    std::unique_ptr<TimelineLayout> m_layout;
    void setTracks(std::vector<TimelineTrack> tracks);
    TimelineGrip gripAt(double x, double y) const { return m_layout->gripAt({x, y}); }
};

namespace {

TimelineTrack labelsOf(std::vector<TimelineSpan> spans)
{
    return {.id = QStringLiteral("labels"), .editable = true, .spans = std::move(spans)};
}

TimelineTrack keysOf(std::vector<TimelineKey> keys)
{
    return {.id = QStringLiteral("keys"),
            .kind = TimelineTrack::Kind::Keys,
            .editable = true,
            .keys = std::move(keys)};
}

constexpr int top = TimelineLayout::tracksTop;

} // namespace

void TestTimelineLayout::init()
{
    m_content = std::make_unique<TimelineContent>();
    m_layout = std::make_unique<TimelineLayout>(*m_content);
    m_layout->scale().setFrameCount(100);
    m_layout->setSize({576, 200});
    setTracks({labelsOf({{.id = 1, .first = 10, .last = 29}})});
}

void TestTimelineLayout::setTracks(std::vector<TimelineTrack> tracks)
{
    m_content->tracks = std::move(tracks);
    m_layout->fitHeader();
}

void TestTimelineLayout::rowsStandBelowEachOther()
{
    QCOMPARE(m_layout->headerWidth(), 76);
    setTracks({labelsOf({}), {.id = "feet", .kind = TimelineTrack::Kind::Contacts}, keysOf({{.id = 1}})});
    QCOMPARE(m_layout->row(0), QRect(76, 46, 500, 24));
    QCOMPARE(m_layout->trackRect("feet"), QRect(76, 74, 500, 14));
    QCOMPARE(m_layout->titleRect("keys"), QRect(0, 92, 76, 58));
    QCOMPARE(m_layout->contentHeight(), 154);
    QVERIFY(m_layout->trackRect("none").isNull() && m_layout->titleRect("none").isNull());
}

void TestTimelineLayout::rowsAreFoldedAndSizedWithinLimits()
{
    const TimelineTrack keys = keysOf({{.id = 1}});
    TimelineRows rows;
    rows.edit({.track = "keys", .height = 1});
    QCOMPARE(rows.heightOf(keys), 34); // a mark and a picture that can be made out
    rows.edit({.track = "keys", .height = 1000});
    QCOMPARE(rows.heightOf(keys), 200);
    rows.edit({.track = "keys", .height = 90, .isFolded = true});
    QCOMPARE(rows.heightOf(keys), 10);
    QCOMPARE(rows.of("keys").height, 90);
    QCOMPARE(rows.all().size(), std::size_t(1));
    rows.edit({.track = "keys"});
    QVERIFY(rows.all().empty());
    QCOMPARE(rows.heightOf(keys), 58);
    QCOMPARE(rows.heightOf(keysOf({})), 24);
}

void TestTimelineLayout::framesAndPixelsMatch()
{
    QCOMPARE(m_layout->x(0), 76);
    QCOMPARE(m_layout->x(10.5), 129); // 128.5
    QCOMPARE(m_layout->frameAt(130.9), 10);
    QCOMPARE(m_layout->frameAt(131), 11);
    QCOMPARE(m_layout->frameAt(0), 0);
    QCOMPARE(m_layout->frameAt(5000), 99);
    QCOMPARE(m_layout->spanRect({"labels", 1}), QRect(126, 46, 100, 24));
    QCOMPARE(m_layout->spanRect({"labels", 2}), QRect());
}

void TestTimelineLayout::spansHaveEndsAndAMiddle()
{
    const double y = top + 12;
    const SpanRef span{"labels", 1};
    // The first frame's left edge is at 126, the last one's right edge at 226.
    QCOMPARE(gripAt(120, y), (TimelineGrip{Kind::NewSpan, {"labels", 0}, 8, 8}));
    for (const double x : {121, 126, 131})
        QCOMPARE(gripAt(x, y), (TimelineGrip{Kind::SpanStart, span, 10, 29}));
    for (const double x : {132, 176, 220})
        QCOMPARE(gripAt(x, y), (TimelineGrip{Kind::Span, span, 10, 29}));
    for (const double x : {221, 226, 230})
        QCOMPARE(gripAt(x, y), (TimelineGrip{Kind::SpanEnd, span, 10, 29}));
    QCOMPARE(gripAt(231, y).kind, Kind::NewSpan);
    QCOMPARE(m_layout->spanAt({126, y}), std::optional(span));
    QCOMPARE(m_layout->spanAt({125, y}), std::optional<SpanRef>());
}

void TestTimelineLayout::slimSpansAreTakenHoldOfBesideThem()
{
    m_layout->setSize({176, 200}); // a pixel a frame
    setTracks({labelsOf({{.id = 1, .first = 50, .last = 51}})});
    const double y = top + 12;
    QCOMPARE(m_layout->spanRect({"labels", 1}), QRect(126, 46, 2, 24));
    QVERIFY(m_layout->spanAt({124, y}) && m_layout->spanAt({129, y}));
    QVERIFY(!m_layout->spanAt({123, y}) && !m_layout->spanAt({130, y}));
    QCOMPARE(gripAt(126, y).kind, Kind::Span);
    QCOMPARE(gripAt(123, y).kind, Kind::SpanEnd); // which both ends reach
    QCOMPARE(gripAt(122, y).kind, Kind::SpanStart);
}

void TestTimelineLayout::laterSpansLieAboveEarlierOnes()
{
    setTracks({labelsOf({{.id = 1, .first = 0, .last = 50}, {.id = 2, .first = 20, .last = 30}})});
    QCOMPARE(m_layout->spanAt({76 + 25 * 5, top + 12}), std::optional(SpanRef{"labels", 2}));
    QCOMPARE(m_layout->spanAt({76 + 40 * 5, top + 12}), std::optional(SpanRef{"labels", 1}));
}

void TestTimelineLayout::marksOfKeysLieAbovePicturesAndTheSelectedOneAboveAll()
{
    setTracks({keysOf({{.id = 1, .frame = 40}, {.id = 2, .frame = 43}})});
    // Marks at 279 and 294, pictures of 40 pixels below about them.
    QCOMPARE(m_layout->keyMarkRect(m_layout->row(0), 40), QRect(272, 46, 14, 16));
    QCOMPARE(m_layout->keyPictureRect(m_layout->row(0), 40), QRect(259, 62, 40, 40));
    const auto keyAt = [&](int x, int y) { return m_layout->spanAt(QPointF(x, y)).value_or(SpanRef{}).span; };
    QCOMPARE(keyAt(279, top + 4), 1);
    QCOMPARE(keyAt(290, top + 30), 2);
    m_content->selected = SpanRef{"keys", 1};
    QCOMPARE(keyAt(290, top + 30), 1);
    QCOMPARE(keyAt(310, top + 30), 2);
    QCOMPARE(keyAt(250, top + 30), 0);
    QCOMPARE(gripAt(290, top + 30), (TimelineGrip{Kind::Key, {"keys", 1}, 40, 40}));
    QCOMPARE(gripAt(400, top + 30).kind, Kind::Playhead);
}

void TestTimelineLayout::picturesStayWholeWhileTheirMarksShow()
{
    const QRect row(76, 46, 500, 58);
    QCOMPARE(m_layout->keyPictureRect(row, 0).left(), 77);
    QCOMPARE(m_layout->keyPictureRect(row, 99).right(), 574);
    m_layout->scale().show(50, 50);
    QVERIFY(m_layout->keyPictureRect(row, 40).right() < row.left());
    QVERIFY(m_layout->keyPictureRect(QRect(76, 46, 500, 10), 60).isEmpty());
}

void TestTimelineLayout::notesEndAtTheNextOne()
{
    TimelineTrack notes = labelsOf({{.id = 1, .first = 20, .last = 20, .text = "the left hand slips again"},
                                    {.id = 2, .first = 30, .last = 30, .text = {}}});
    notes.kind = TimelineTrack::Kind::Notes;
    setTracks({notes});
    // Their poles stand at 179 and 229; marks begin six pixels before.
    QCOMPARE(m_layout->spanRect({"labels", 1}), QRect(173, 46, 50, 24));
    QCOMPARE(m_layout->spanRect({"labels", 2}).left(), 223);
    QCOMPARE(gripAt(222, top + 4), (TimelineGrip{Kind::Span, {"labels", 1}, 20, 20}));
    QCOMPARE(gripAt(223, top + 4), (TimelineGrip{Kind::Span, {"labels", 2}, 30, 30}));
    QCOMPARE(gripAt(172, top + 4).kind, Kind::Playhead);
}

void TestTimelineLayout::theRulerHasEndsOfRangeAndLoop()
{
    m_content->range = {20, 59}; // from 176 to 376
    m_content->loop = {30, 39};  // from 226 to 276
    QCOMPARE(gripAt(180, 20), (TimelineGrip{Kind::RangeStart, {}, 20, 59}));
    QCOMPARE(gripAt(372, 20), (TimelineGrip{Kind::RangeEnd, {}, 20, 59}));
    QCOMPARE(gripAt(382, 20).kind, Kind::Playhead);
    QCOMPARE(gripAt(180, 14).kind, Kind::Playhead); // in the upper half
    QCOMPARE(gripAt(230, 10), (TimelineGrip{Kind::LoopStart, {}, 30, 39}));
    QCOMPARE(gripAt(272, 3), (TimelineGrip{Kind::LoopEnd, {}, 30, 39}));
    QCOMPARE(gripAt(230, 11).kind, Kind::Playhead);
    m_content->isRangeEditable = false;
    QCOMPARE(gripAt(180, 20).kind, Kind::Playhead);
}

void TestTimelineLayout::titlesFoldAndTheirEdgesSize()
{
    QCOMPARE(gripAt(10, 58), (TimelineGrip{Kind::Title, {"labels", 0}, 0, 0}));
    // The row ends at 70, half of the gap below counts as its edge.
    for (const double y : {69, 72, 75})
        QCOMPARE(gripAt(10, y), (TimelineGrip{Kind::RowEdge, {"labels", 0}, 24, 0}));
    QCOMPARE(gripAt(10, 76).kind, Kind::None);
    QCOMPARE(gripAt(10, 20).kind, Kind::None);
}

void TestTimelineLayout::onlyWhatIsEditableIsTakenHoldOf()
{
    m_content->tracks[0].editable = false;
    QCOMPARE(gripAt(176, top + 12).kind, Kind::Playhead);
    QVERIFY(m_layout->spanAt({176, top + 12})); // but can be selected
    QCOMPARE(gripAt(176, 150).kind, Kind::Playhead);
}

void TestTimelineLayout::theLoopPlaysWhereItLiesInTheRange()
{
    QCOMPARE(m_layout->playedRange(), std::pair(0, 99));
    m_content->range = {20, 59};
    QCOMPARE(m_layout->playedRange(), std::pair(20, 59));
    m_content->loop = {50, 70};
    QCOMPARE(m_layout->playedRange(), std::pair(50, 59));
    m_content->loop = {60, 70};
    QCOMPARE(m_layout->playedRange(), std::pair(20, 59));
}

void TestTimelineLayout::boundariesSnapToTheNearestEdge()
{
    m_layout->setSize({276, 200}); // two pixels a frame, so three frames are within reach
    const auto snapped = [&](int boundary) {
        return snappedBoundary(*m_layout, boundary, std::nullopt, true);
    };
    m_content->current = 60;
    QCOMPARE(snapped(13), 10);
    QCOMPARE(snapped(14), 14);
    QCOMPARE(snapped(28), 30); // behind the last frame
    QCOMPARE(snapped(58), 60);
    QCOMPARE(snapped(63), 61); // behind the playhead
    QCOMPARE(snapped(98), 100);
    QCOMPARE(snappedBoundary(*m_layout, 13, SpanRef{"labels", 1}, true), 13);
    m_content->loop = {40, 49};
    QCOMPARE(snapped(41), 40);
    QCOMPARE(snapped(51), 50);
    QCOMPARE(snappedBoundary(*m_layout, 41, std::nullopt, false), 41);
}

void TestTimelineLayout::keysSnapToFramesThatAreMarked()
{
    m_layout->setSize({276, 200});
    setTracks({labelsOf({{.id = 1, .first = 10, .last = 29}}),
               keysOf({{.id = 5, .frame = 40.4, .obtained = 46.0}})});
    m_content->current = 70;
    const auto frameAt = [&](int frame, const std::optional<SpanRef>& except = {}) {
        return keyFrameAt(*m_layout, m_layout->x(frame) + 1, true, except);
    };
    QCOMPARE(frameAt(12), 10);
    QCOMPARE(frameAt(31), 29); // the last frame, not the edge behind it
    QCOMPARE(frameAt(39), 40);
    QCOMPARE(frameAt(48), 46);
    QCOMPARE(frameAt(48, SpanRef{"keys", 5}), 48);
    QCOMPARE(frameAt(72), 70);
    QCOMPARE(keyFrameAt(*m_layout, m_layout->x(12) + 1, false, {}), 12);
}

QUADRILLE_QT_TEST_IN(QGuiApplication, TestTimelineLayout);
#include "tst_timelinelayout.moc"
