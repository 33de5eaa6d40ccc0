// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Notes: words at frames.
#include "widgets/theme/theme.h"
#include "widgets/timeline/timelineprivate.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr int markReach = 6; ///< of a note's mark to both sides of its frame, pixels
constexpr int mostWords = 220;

} // namespace

QRect Timeline::Private::noteRect(const TimelineTrack& owner, const QRect& place,
                                  const TimelineSpan& note) const
{
    const int left = x(shown(owner.id, note).first + 0.5) - markReach;
    int room = mostWords;
    for (const TimelineSpan& other : owner.spans)
        if (const int gapToOther = x(shown(owner.id, other).first + 0.5) - markReach - left;
            other.id != note.id && gapToOther > 0)
            room = std::min(room, gapToOther);
    const int words = QFontMetrics(font).horizontalAdvance(note.text) + 2 * markReach + 8;
    return {left, place.top(), std::max(2 * markReach, std::min(room, words)), place.height()};
}

std::optional<SpanRef> Timeline::Private::noteAt(const TimelineTrack& owner, const QPointF& position) const
{
    const QRect place = row(static_cast<std::size_t>(&owner - tracks.data()));
    if (position.x() < place.left())
        return std::nullopt;
    for (auto note = owner.spans.rbegin(); note != owner.spans.rend(); ++note)
        if (noteRect(owner, place, *note).contains(position.toPoint()))
            return SpanRef{owner.id, note->id};
    return std::nullopt;
}

void Timeline::Private::paintNote(QPainter& painter, const TimelineTrack& owner, const QRect& place,
                                  const TimelineSpan& note) const
{
    const bool isSelected = selected == SpanRef{owner.id, note.id};
    const QRectF box = noteRect(owner, place, note);
    const double middle = box.left() + markReach;
    const QColor color = Theme::color(isSelected ? ColorRole::AccentText : ColorRole::TextMuted);
    // A flag on a pole: the pole stands at the frame.
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(middle, box.top() + 2), QPointF(middle, box.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const double top = box.top() + 2;
    painter.drawPolygon(QPolygonF{{middle, top}, {middle + 8, top + 3}, {middle, top + 6}});
    const QRectF words = box.adjusted(2 * markReach + 4, 0, 0, 0);
    constexpr double fewestPixels = 14;
    constexpr double lowestRow = 14;
    if (words.width() < fewestPixels || box.height() < lowestRow)
        return;
    painter.setPen(Theme::color(isSelected ? ColorRole::AccentText : ColorRole::Text));
    painter.drawText(
        words, Qt::AlignVCenter | Qt::AlignLeft,
        painter.fontMetrics().elidedText(QString(note.text).replace(QLatin1Char('\n'), QLatin1Char(' ')),
                                         Qt::ElideRight, static_cast<int>(words.width())));
}

} // namespace quadrille::widgets
