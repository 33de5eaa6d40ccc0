// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/elidedpair.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/framekind.h"
#include "widgets/timeline/timelinegestures.h"
#include "widgets/timeline/timelinepaint.h"

#include <QPainter>
#include <algorithm>

namespace quadrille::widgets {

namespace {

void paintTitle(QPainter& painter, const TimelineLayout& layout, const TimelineTrack& track,
                const QRect& place)
{
    constexpr int sign = 12;
    const bool isFolded = layout.rows().of(track.id).isFolded;
    const QString icon = isFolded ? QStringLiteral("chevronright") : QStringLiteral("chevrondown");
    // High rows carry their titles at the top, beside what they begin with.
    const int height = std::min(place.height(), TimelineRows::usualHeight(track));
    painter.drawPixmap(
        QRect(4, place.top() + (height - sign) / 2, sign, sign),
        icons::pixmap(icon, sign, Theme::color(ColorRole::TextMuted), painter.device()->devicePixelRatioF()));
    const QRect title(8 + sign, place.top(), layout.headerWidth() - sign - 12, height);
    painter.setPen(Theme::color(ColorRole::TextMuted));
    painter.save();
    if (isFolded) {
        QFont small = painter.font();
        small.setPointSizeF(small.pointSizeF() * 0.8);
        painter.setFont(small);
    }
    painter.drawText(title, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextDontClip,
                     painter.fontMetrics().elidedText(track.title, Qt::ElideRight, title.width()));
    painter.restore();
}

void paintNote(QPainter& painter, const QRectF& box, QString text, bool isSelected)
{
    const double middle = box.left() + TimelineLayout::noteReach;
    const QColor color = Theme::color(isSelected ? ColorRole::AccentText : ColorRole::TextMuted);
    // A flag on a pole: the pole stands at the frame.
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(middle, box.top() + 2), QPointF(middle, box.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const double top = box.top() + 2;
    painter.drawPolygon(QPolygonF{{middle, top}, {middle + 8, top + 3}, {middle, top + 6}});
    const QRectF words = box.adjusted(2 * TimelineLayout::noteReach + 4, 0, 0, 0);
    constexpr double fewestPixels = 14;
    constexpr double lowestRow = 14;
    if (words.width() < fewestPixels || box.height() < lowestRow)
        return;
    painter.setPen(Theme::color(isSelected ? ColorRole::AccentText : ColorRole::Text));
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(text.replace(QLatin1Char('\n'), QLatin1Char(' ')),
                                                      Qt::ElideRight, static_cast<int>(words.width())));
}

/// The part of a span that can carry its name.
QRectF nameRect(const TimelineLayout& layout, const TimelineTrack& track, const QRect& place,
                const TimelineSpan& span, const QRectF& box)
{
    // The part that shows carries the name, also when the span starts left of the view.
    QRectF seen = box.intersected(place).adjusted(6.0, 0.0, -4.0, 0.0);
    // What lies above the span hides neither end of its name.
    bool isAbove = false;
    for (const TimelineSpan& other : track.spans) {
        const QRectF cover = layout.framesRect(place, other.first, other.last);
        if (isAbove && cover.left() > seen.left() && cover.left() < seen.right())
            seen.setRight(cover.left() - 4.0);
        else if (isAbove && cover.left() <= seen.left() && cover.right() > seen.left())
            seen.setLeft(cover.right() + 4.0);
        isAbove = isAbove || other.id == span.id;
    }
    return seen;
}

void paintSpan(QPainter& painter, const TimelineLayout& layout, const TimelineTrack& track,
               const QRect& place, const TimelineSpan& span, bool isSelected)
{
    const QRectF box = QRectF(layout.framesRect(place, span.first, span.last)).adjusted(0.5, 1.0, -0.5, -1.0);
    if (box.right() < place.left() || box.left() > place.right())
        return;
    const QColor color = span.color.isValid() ? span.color : Theme::color(ColorRole::Accent);
    const double radius = std::min(3.0, box.width() / 2.0);
    // Light marks on light ground keep an outline that can be seen.
    painter.setPen(isSelected ? QPen(Theme::color(ColorRole::Text), 2.0)
                              : QPen(color.darker(Theme::instance().isDark() ? 130 : 160), 1.0));
    painter.setBrush(color);
    painter.drawRoundedRect(box, radius, radius);
    const FrameKind kind = span.hatched  ? FrameKind::Transition
                           : span.dotted ? FrameKind::Varied
                                         : FrameKind::Captured;
    paintFramePattern(painter, box.adjusted(1.0, 1.0, -1.0, -1.0), kind, color);
    if (track.kind == TimelineTrack::Kind::Contacts || span.text.isEmpty() ||
        place.height() <= TimelineRows::foldedHeight)
        return;
    const QRectF seen = nameRect(layout, track, place, span, box);
    constexpr double smallestText = 24.0;
    // Between the lines of a pattern little of a text could be read.
    constexpr double smallestHatchedText = 72.0;
    if (seen.width() < (kind == FrameKind::Captured ? smallestText : smallestHatchedText))
        return;
    const QString text = elidedPair(span.text, painter.fontMetrics(), static_cast<int>(seen.width()));
    if (kind != FrameKind::Captured) {
        const QRectF words(seen.left() - 3, seen.top() + 2, painter.fontMetrics().horizontalAdvance(text) + 6,
                           seen.height() - 4);
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawRoundedRect(words, 2.0, 2.0);
    }
    painter.setPen(Theme::textOn(color));
    painter.drawText(seen, Qt::AlignVCenter | Qt::AlignLeft, text);
}

} // namespace

void paintTimelineRow(QPainter& painter, const TimelineLayout& layout, const TimelineDrag& drag,
                      const TimelineTrack& track, const QPalette& palette)
{
    const QRect place = layout.row(track);
    painter.fillRect(place, Theme::color(ColorRole::Base));
    paintTitle(painter, layout, track, place);
    painter.save();
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.setClipRect(place);
    if (track.spans.empty() && track.keys.empty() && !track.hint.isEmpty() &&
        place.height() > TimelineRows::foldedHeight)
        painter.drawText(place.adjusted(6, 0, -6, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         painter.fontMetrics().elidedText(track.hint, Qt::ElideRight, place.width() - 12));
    const auto applied = drag.applied(track);
    const TimelineTrack& shown = applied ? *applied : track;
    for (const TimelineSpan& span : shown.spans) {
        const bool isSelected = layout.content().selected == SpanRef{track.id, span.id};
        if (track.kind == TimelineTrack::Kind::Notes)
            paintNote(painter, layout.noteRect(shown, place, span), span.text, isSelected);
        else
            paintSpan(painter, layout, shown, place, span, isSelected);
    }
    if (drag.grip.kind == TimelineGrip::Kind::NewSpan && drag.moved && drag.grip.span.track == track.id) {
        const QRectF box = QRectF(layout.framesRect(place, drag.first, drag.last));
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.5, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box.adjusted(0.5, 1.5, -0.5, -1.5), 3.0, 3.0);
    }
    painter.restore();
}

} // namespace quadrille::widgets
