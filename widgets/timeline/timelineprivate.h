// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timeline.h"

class QPainter;
class QScrollBar;

namespace quadrille::widgets {

/// What the mouse is moving.
struct TimelineDrag
{
    enum class Kind
    {
        None,
        Playhead,
        RangeStart,
        RangeEnd,
        Create,
        Move,
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
    std::vector<TimelineTrack> tracks;
    std::optional<SpanRef> selected;
    TimelineDrag drag;
    QScrollBar* scrollBar = nullptr;
    QSize size;

    static constexpr int rulerHeight = 28;
    static constexpr int gap = 4;
    static constexpr int edgeReach = 5; ///< pixels about an edge that take hold of it

    int headerWidth = 0;
    int rowHeight(const TimelineTrack& track) const;
    int contentHeight() const;
    QRect row(std::size_t track) const;
    int x(double frame) const;
    QRect rect(const QRect& row, int first, int last) const;
    const TimelineTrack* track(const QString& id) const;
    const TimelineSpan* span(const SpanRef& ref) const;
    const TimelineTrack* trackAt(const QPointF& position) const;
    std::optional<SpanRef> spanAt(const QPointF& position) const;
    /// What a press at a place would move.
    TimelineDrag dragAt(const QPointF& position) const;
    std::pair<int, int> effectiveRange() const;
    /// The span's frames as they would be after the drag.
    TimelineSpan shown(const QString& track, const TimelineSpan& span) const;
    /// The nearest edge, playhead or range end within reach of a frame boundary, or the boundary itself.
    int snapped(int boundary, const std::optional<SpanRef>& except) const;
    /// Moves what is dragged to a place. \return whether something changed.
    bool dragTo(const QPointF& position, bool snap);

    void paint(QPainter& painter, const QRect& exposed, const Timeline& timeline) const;
    void paintRuler(QPainter& painter) const;
    void paintRange(QPainter& painter) const;
    void paintTrack(QPainter& painter, std::size_t index, const QPalette& palette) const;
    void paintSpan(QPainter& painter, const TimelineTrack& owner, const QRect& row,
                   const TimelineSpan& span) const;
    void paintPlayhead(QPainter& painter) const;
    QRect playheadRect(int frame) const;
};

} // namespace quadrille::widgets
