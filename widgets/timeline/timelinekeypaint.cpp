// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/theme.h"
#include "widgets/timeline/timelinegestures.h"
#include "widgets/timeline/timelinepaint.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

void paintDiamond(QPainter& painter, const QPointF& centre, double reach)
{
    painter.drawPolygon(QPolygonF{{centre.x(), centre.y() - reach},
                                  {centre.x() + reach, centre.y()},
                                  {centre.x(), centre.y() + reach},
                                  {centre.x() - reach, centre.y()}});
}

/// A band from one end to the other with a bar at each, about the line of the marks.
void paintBracket(QPainter& painter, double left, double right, double middle, const QColor& color)
{
    constexpr double halfHeight = 5.0;
    constexpr double foot = 3.0;
    QColor band = color;
    band.setAlphaF(0.22F);
    painter.fillRect(QRectF(left, middle - halfHeight, right - left, 2 * halfHeight), band);
    painter.setPen(QPen(color, 1.5));
    for (const auto& [end, inwards] : {std::pair{left, foot}, std::pair{right, -foot}})
        for (const double edge : {middle - halfHeight, middle + halfHeight})
            painter.drawPolyline(QPolygonF{{end + inwards, edge}, {end, edge}, {end, middle}});
}

/// The colour of keys in which lines show on the ground of a track.
QColor lineColor()
{
    const QColor mark = Theme::color(ColorRole::Key);
    return Theme::instance().isDark() ? mark : mark.darker(160);
}

void paintMark(QPainter& painter, const TimelineLayout& layout, const QRect& place, const TimelineKey& key,
               bool isSelected)
{
    const double markHeight = std::min(TimelineRows::keyMarkHeight, place.height());
    const QPointF mark(layout.x(key.frame + 0.5), place.top() + markHeight / 2.0);
    if (key.tolerance)
        paintBracket(painter, layout.x(key.frame + 0.5 - *key.tolerance),
                     layout.x(key.frame + 0.5 + *key.tolerance), mark.y(), lineColor());
    if (key.obtained) {
        const QPointF obtained(layout.x(*key.obtained + 0.5), mark.y());
        const bool isMissed = key.tolerance && std::abs(*key.obtained - key.frame) > *key.tolerance + 1e-6;
        const QColor line = Theme::color(isMissed ? ColorRole::ErrorText : ColorRole::Text);
        painter.setPen(QPen(line, 1.5, isMissed ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(mark, obtained);
        painter.setPen(QPen(line, 1.5));
        painter.setBrush(Theme::color(ColorRole::Base));
        painter.drawEllipse(obtained, 3.5, 3.5);
    }
    painter.setPen(QPen(isSelected ? Theme::color(ColorRole::Text) : lineColor(), isSelected ? 2.0 : 1.0));
    painter.setBrush(Theme::color(ColorRole::Key));
    paintDiamond(painter, mark, std::min(TimelineLayout::keyReach, markHeight / 2.0));
}

/// \param room  pixels beside the picture.
void paintKey(QPainter& painter, const TimelineLayout& layout, const QRect& place, const TimelineKey& key,
              bool isSelected, double room)
{
    paintMark(painter, layout, place, key, isSelected);
    const QRect box = layout.keyPictureRect(place, key.frame);
    if (box.isEmpty())
        return;
    QPainterPath rounded;
    rounded.addRoundedRect(QRectF(box).adjusted(1, 1, -1, -1), 3, 3);
    painter.fillPath(rounded, Theme::color(ColorRole::Raised));
    if (!key.picture.isNull()) {
        painter.save();
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setClipPath(rounded, Qt::IntersectClip);
        painter.drawImage(box, key.picture);
        painter.restore();
    }
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(rounded);
    constexpr double smallestText = 28.0;
    if (room < smallestText)
        return;
    const QRectF text(box.right() + 5.0, box.top(), std::min(room, 160.0), box.height());
    const double half = text.height() / 2;
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(
        text.adjusted(0, 0, 0, -half), Qt::AlignLeft | Qt::AlignBottom,
        painter.fontMetrics().elidedText(key.text, Qt::ElideMiddle, static_cast<int>(text.width())));
    painter.setPen(Theme::color(ColorRole::TextMuted));
    painter.drawText(text.adjusted(0, half, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                     layout.content().frameText(key.frame));
}

void paintKeysOf(QPainter& painter, const TimelineLayout& layout, const TimelineTrack& track,
                 const QRect& place)
{
    std::vector<const TimelineKey*> order;
    for (const TimelineKey& key : track.keys)
        order.push_back(&key);
    std::ranges::stable_sort(order, {}, &TimelineKey::frame);
    // The selected one comes last, above all.
    for (const bool selected : {false, true})
        for (std::size_t i = 0; i < order.size(); ++i) {
            if ((layout.content().selected == SpanRef{track.id, order[i]->id}) != selected)
                continue;
            // What stands beside a picture ends at the next one.
            const int right = layout.keyPictureRect(place, order[i]->frame).right();
            const int end = i + 1 < order.size() ? layout.keyPictureRect(place, order[i + 1]->frame).left()
                                                 : place.right();
            paintKey(painter, layout, place, *order[i], selected, end - right - 8);
        }
}

} // namespace

void paintTimelineKeys(QPainter& painter, const TimelineLayout& layout, const TimelineDrag& drag)
{
    std::vector<double> stems;
    for (const TimelineTrack& track : layout.content().tracks) {
        const auto applied = drag.applied(track);
        const TimelineTrack& shown = applied ? *applied : track;
        paintKeysOf(painter, layout, shown, layout.row(track));
        for (const TimelineKey& key : shown.keys)
            stems.push_back(layout.x(key.frame + 0.5));
    }
    painter.setPen(QPen(lineColor(), 1.5));
    for (const double x : stems)
        painter.drawLine(QPointF(x, TimelineLayout::rulerHeight - 9.0),
                         QPointF(x, TimelineLayout::rulerHeight + TimelineLayout::gap));
}

void paintTimelineDrop(QPainter& painter, const TimelineLayout& layout)
{
    const TimelineContent& content = layout.content();
    const TimelineTrack* track = content.track(content.dropTrack);
    if (!content.dropFrame || track == nullptr)
        return;
    const int frame = *content.dropFrame;
    const QRect place = layout.row(*track);
    const QRect picture = layout.keyPictureRect(place, frame);
    const double middle = layout.x(frame + 0.5);
    painter.setPen(QPen(lineColor(), 1.5, Qt::DashLine));
    painter.drawLine(QPointF(middle, 2.0), QPointF(middle, layout.size().height()));
    painter.setBrush(Qt::NoBrush);
    if (!picture.isEmpty() && !track->keys.empty())
        painter.drawRoundedRect(QRectF(picture).adjusted(1, 1, -1, -1), 3, 3);
    painter.setPen(QPen(lineColor(), 1.0));
    painter.setBrush(Theme::color(ColorRole::Key));
    paintDiamond(painter, {middle, place.top() + TimelineRows::keyMarkHeight / 2.0},
                 TimelineLayout::keyReach);
    const QString text = content.frameText(frame);
    QRectF flag(middle + 6.0, 2.0, painter.fontMetrics().horizontalAdvance(text) + 12.0,
                TimelineLayout::rulerHeight - 10.0);
    if (flag.right() > layout.size().width())
        flag.moveRight(middle - 6.0);
    painter.setPen(Qt::NoPen);
    painter.drawRoundedRect(flag, 3.0, 3.0);
    painter.setPen(Theme::color(ColorRole::OnMark));
    painter.drawText(flag, Qt::AlignCenter, text);
}

} // namespace quadrille::widgets
