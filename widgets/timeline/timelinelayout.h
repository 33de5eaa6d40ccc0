// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinecontent.h"
#include "widgets/timeline/timelinerows.h"
#include "widgets/timeline/timelinescale.h"

#include <QFontMetrics>
#include <QRect>

namespace quadrille::widgets {

/// What a press takes hold of.
struct TimelineGrip
{
    enum class Kind
    {
        None,
        Title,   ///< of `span.track`
        RowEdge, ///< the lower edge of a title
        Playhead,
        RangeStart,
        RangeEnd,
        LoopStart,
        LoopEnd,
        NewLoop,
        NewSpan,
        Span, ///< the whole of it; also a note
        SpanStart,
        SpanEnd,
        Key,
        View ///< all that shows, to scroll it
    };
    Kind kind = Kind::None;
    SpanRef span;  ///< or only its track
    int first = 0; ///< its frames, both included; of a row's edge the row's height
    int last = 0;

    bool isRange() const { return kind == Kind::RangeStart || kind == Kind::RangeEnd; }
    bool isLoopEnd() const { return kind == Kind::LoopStart || kind == Kind::LoopEnd; }
    bool isSpan() const { return kind == Kind::Span || kind == Kind::SpanStart || kind == Kind::SpanEnd; }
    bool operator==(const TimelineGrip&) const = default;
};

/// Where the content of a timeline lies, in pixels of the widget, and what lies at a place. Frame f covers
/// [x(f), x(f + 1)). Titles stand left of headerWidth(); from top to bottom there are ruler, zoom bar,
/// tracks.
class TimelineLayout
{
public:
    static constexpr int rulerHeight = 28;
    static constexpr int loopHeight = 8; ///< of the band at the ruler's top
    static constexpr int tracksTop = rulerHeight + 14 + 4;
    static constexpr int gap = 4;       ///< between rows
    static constexpr int edgeReach = 5; ///< pixels about an edge that take hold of it
    static constexpr int noteReach = 6; ///< of a note's mark to both sides of its frame
    static constexpr double keyReach = 6.0;

    /// \param content  outlives the layout.
    explicit TimelineLayout(const TimelineContent& content);
    const TimelineContent& content() const { return m_content; }
    void setSize(const QSize& size);
    QSize size() const { return m_size; }
    void setMetrics(const QFontMetrics& metrics) { m_metrics = metrics; }
    /// To be called when the tracks are others: makes room for their titles.
    void fitHeader();
    int headerWidth() const { return m_headerWidth; }
    /// As wide as what is right of the titles.
    TimelineScale& scale() { return m_scale; }
    const TimelineScale& scale() const { return m_scale; }
    TimelineRows& rows() { return m_rows; }
    const TimelineRows& rows() const { return m_rows; }

    std::pair<int, int> range() const;
    /// The loop as far as it lies in the range, else the range.
    std::pair<int, int> playedRange() const;
    int lastFrame() const { return m_scale.frameCount() - 1; }
    /// The frame that covers a place, kept inside the frames there are.
    int frameAt(double x) const { return m_scale.nearestFrame(x - m_headerWidth); }
    int x(double frame) const;
    int contentHeight() const;
    QRect rulerRect() const { return {m_headerWidth, 0, m_size.width() - m_headerWidth, rulerHeight}; }
    QRect row(std::size_t track) const;
    QRect row(const TimelineTrack& track) const; ///< one of the content's
    /// Null where there is no such track.
    QRect trackRect(const QString& track) const;
    /// Left of it.
    QRect titleRect(const QString& track) const;
    /// Frames of a row.
    QRect framesRect(const QRect& row, int first, int last) const;
    QRect keyMarkRect(const QRect& row, double frame) const;
    /// Empty in a folded row.
    QRect keyPictureRect(const QRect& row, double frame) const;
    /// Mark and words of a note, up to the next one.
    QRect noteRect(const TimelineTrack& owner, const QRect& row, const TimelineSpan& note) const;
    /// A span, a note, or a key with its picture; null where there is no such.
    QRect spanRect(const SpanRef& ref) const;
    QRectF playheadFlag(int frame) const;
    /// All that the playhead paints at a frame.
    QRect playheadRect(int frame) const;

    /// Null for none.
    const TimelineTrack* trackAt(const QPointF& position) const;
    std::optional<SpanRef> spanAt(const QPointF& position) const;
    TimelineGrip gripAt(const QPointF& position) const;

private:
    std::optional<SpanRef> keyAt(const TimelineTrack& owner, const QPoint& point) const;
    std::optional<SpanRef> noteAt(const TimelineTrack& owner, const QPoint& point) const;
    TimelineGrip titleGripAt(const QPointF& position) const;
    TimelineGrip rulerGripAt(const QPointF& position) const;
    TimelineGrip spanGripAt(const TimelineTrack& owner, const QPointF& position) const;

    const TimelineContent& m_content;
    TimelineScale m_scale;
    TimelineRows m_rows;
    QSize m_size;
    QFontMetrics m_metrics;
    int m_headerWidth = 0;
};

} // namespace quadrille::widgets
