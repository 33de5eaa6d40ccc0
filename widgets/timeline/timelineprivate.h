// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timeline.h"

#include <QFont>
#include <QTimer>

class QFontMetrics;
class QPainter;

namespace quadrille::widgets {

class TimelineZoomBar;

/// What the mouse is moving.
struct TimelineDrag
{
    enum class Kind
    {
        None,
        Playhead,
        RangeStart,
        RangeEnd,
        LoopStart,
        LoopEnd,
        LoopNew,
        RowSize,
        Create,
        Move,
        MoveKey,
        SpanStart,
        SpanEnd,
        Scroll
    };
    Kind kind = Kind::None;
    SpanRef span;    ///< for Create only its track
    int grabbed = 0; ///< the frame under the pointer at the press
    int first = 0;   ///< as it would be now
    int last = 0;
    int oldFirst = 0;
    int oldLast = 0;
    QPointF pressedAt;
    double scrollFirst = 0.0;
    bool moved = false;
};

struct Timeline::Private
{
    TimelineScale scale;
    bool isEmpty = false; ///< there is no clip; the scale keeps one frame for it
    double fps = 25.0;
    Unit unit = Unit::Frames;
    int current = 0;
    std::optional<std::pair<int, int>> range;
    bool isRangeEditable = true;
    std::optional<std::pair<int, int>> loop;
    std::vector<TimelineTrack> tracks;
    std::vector<TimelineRow> rows;
    std::optional<SpanRef> selected;
    TimelineDrag drag;
    std::optional<SpanRef> hovered;
    QString dropTrack;
    std::optional<int> dropFrame; ///< while something is held over the timeline
    bool grows = false;
    QTimer growing;
    int framesBeforeGrowing = 0; ///< 0 while it does not grow
    QPointF held;                ///< where something is held while it grows
    TimelineZoomBar* zoomBar = nullptr;
    QSize size;

    static constexpr int rulerHeight = 28;
    static constexpr int loopHeight = 8; ///< of the band at the ruler's top
    static constexpr int tracksTop = rulerHeight + 14 + 4;
    static constexpr int gap = 4;
    static constexpr int foldedHeight = 10;
    static constexpr int tallestRow = 200;
    static constexpr int edgeReach = 5; ///< pixels about an edge that take hold of it
    static constexpr int slimmest = 6;  ///< pixels that take hold of a span
    static constexpr int keyMarkHeight = 16;
    static constexpr int keyPicture = 40;
    static constexpr int keyRowHeight = keyMarkHeight + keyPicture + 2;

    int headerWidth = 0;
    QFont font; ///< in which it is painted
    static int usualHeight(const TimelineTrack& track);
    static int leastHeight(const TimelineTrack& track);
    int rowHeight(const TimelineTrack& track) const;
    const TimelineRow* ownRow(const QString& track) const;
    /// Changes what the user wants of a row, and forgets it where that is as usual.
    void editRow(const TimelineRow& row);
    /// The track whose title, or the lower edge of it, is at a place; null for none.
    const TimelineTrack* titleAt(const QPointF& position, bool* isEdge) const;
    int contentHeight() const;
    QRect row(std::size_t track) const;
    int x(double frame) const;
    QRect rect(const QRect& row, int first, int last) const;
    const TimelineTrack* track(const QString& id) const;
    const TimelineSpan* span(const SpanRef& ref) const;
    const TimelineKey* key(const SpanRef& ref) const;
    bool exists(const SpanRef& ref) const { return span(ref) != nullptr || key(ref) != nullptr; }
    /// The first frame of a span, the frame of a key.
    int startOf(const SpanRef& ref) const;
    const TimelineTrack* trackAt(const QPointF& position) const;
    std::optional<SpanRef> spanAt(const QPointF& position) const;
    /// What a press at a place would move.
    TimelineDrag dragAt(const QPointF& position) const;
    std::optional<SpanRef> keyAt(const TimelineTrack& owner, const QPointF& position) const;
    /// Where a key is, and how it would be after the drag.
    double shownFrame(const QString& track, const TimelineKey& key) const;
    QRect keyMarkRect(const QRect& row, double frame) const;
    QRect keyPictureRect(const QRect& row, double frame) const;
    /// Mark and words of a note, up to the next one.
    QRect noteRect(const TimelineTrack& owner, const QRect& row, const TimelineSpan& note) const;
    std::optional<SpanRef> noteAt(const TimelineTrack& owner, const QPointF& position) const;
    std::pair<int, int> effectiveRange() const;
    /// The span's frames as they would be after the drag.
    TimelineSpan shown(const QString& track, const TimelineSpan& span) const;
    /// The nearest edge, playhead or range end within reach of a frame boundary, or the boundary itself.
    int snapped(int boundary, const std::optional<SpanRef>& except) const;
    /// The nearest frame within reach that something else marks, or the frame itself.
    int snappedFrame(int frame, const std::optional<SpanRef>& except) const;
    int frameForKey(const QPointF& position, bool snap, const std::optional<SpanRef>& except) const;
    /// Moves what is dragged to a place. \return whether something changed.
    bool dragTo(const QPointF& position, bool snap);

    void paint(QPainter& painter, const QRect& exposed, const Timeline& timeline) const;
    void paintRuler(QPainter& painter) const;
    void paintRange(QPainter& painter) const;
    void paintTrack(QPainter& painter, std::size_t index, const QPalette& palette) const;
    void paintSpan(QPainter& painter, const TimelineTrack& owner, const QRect& row,
                   const TimelineSpan& span) const;
    void paintKeys(QPainter& painter, const TimelineTrack& owner, const QRect& row) const;
    void paintKey(QPainter& painter, const TimelineTrack& owner, const QRect& row, const TimelineKey& key,
                  double room) const;
    void paintKeyStems(QPainter& painter) const;
    void paintDrop(QPainter& painter) const;
    void paintLoop(QPainter& painter) const;
    void paintNote(QPainter& painter, const TimelineTrack& owner, const QRect& row,
                   const TimelineSpan& note) const;
    void paintTitle(QPainter& painter, const TimelineTrack& owner, const QRect& row) const;
    void paintPlayhead(QPainter& painter) const;
    QString frameText(double frame) const;
    QRectF playheadFlag(int frame, const QFontMetrics& metrics) const;
    /// All that the playhead paints at a frame.
    QRect playheadRect(int frame, const QFontMetrics& metrics) const;
};

} // namespace quadrille::widgets
