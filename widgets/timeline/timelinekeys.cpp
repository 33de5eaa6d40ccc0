// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/theme.h"
#include "widgets/timeline/timelineprivate.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double markReach = 6.0;

void paintDiamond(QPainter& painter, const QPointF& centre, double reach)
{
    const QPolygonF corners{{centre.x(), centre.y() - reach},
                            {centre.x() + reach, centre.y()},
                            {centre.x(), centre.y() + reach},
                            {centre.x() - reach, centre.y()}};
    painter.drawPolygon(corners);
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

/// A colour in which lines show on the ground of a track.
QColor lineColor(const QColor& mark)
{
    return Theme::instance().isDark() ? mark : mark.darker(160);
}

} // namespace

const TimelineKey* Timeline::Private::key(const SpanRef& ref) const
{
    const TimelineTrack* owner = track(ref.track);
    if (owner == nullptr)
        return nullptr;
    const auto found = std::ranges::find(owner->keys, ref.span, &TimelineKey::id);
    return found == owner->keys.end() ? nullptr : &*found;
}

int Timeline::Private::startOf(const SpanRef& ref) const
{
    if (const TimelineKey* found = key(ref))
        return static_cast<int>(std::lround(found->frame));
    const TimelineSpan* found = span(ref);
    return found == nullptr ? 0 : found->first;
}

QRect Timeline::Private::keyMarkRect(const QRect& row, double frame) const
{
    const int reach = static_cast<int>(markReach) + 1;
    return {x(frame + 0.5) - reach, row.top(), 2 * reach, std::min(keyMarkHeight, row.height())};
}

QRect Timeline::Private::keyPictureRect(const QRect& row, double frame) const
{
    // Pictures are as high as their row lets them be; a folded one has none.
    const int side = std::max(0, row.height() - keyMarkHeight - 2);
    const int centred = x(frame + 0.5) - side / 2;
    // A picture stays whole while its mark shows.
    const bool shows = x(frame + 0.5) >= row.left() && x(frame + 0.5) <= row.right();
    const int left =
        shows ? std::clamp(centred, row.left() + 1, std::max(row.left() + 1, row.right() - side)) : centred;
    return {left, row.top() + keyMarkHeight, side, side};
}

double Timeline::Private::shownFrame(const QString& owner, const TimelineKey& key) const
{
    const bool dragged =
        drag.moved && drag.kind == TimelineDrag::Kind::MoveKey && drag.span == SpanRef{owner, key.id};
    return dragged ? drag.first : key.frame;
}

std::optional<SpanRef> Timeline::Private::keyAt(const TimelineTrack& owner, const QPointF& position) const
{
    const QRect place = row(static_cast<std::size_t>(&owner - tracks.data()));
    const QPoint point = position.toPoint();
    if (point.x() < place.left())
        return std::nullopt;
    // The selected key lies above all, marks above pictures, later keys above earlier ones.
    if (selected && selected->track == owner.id)
        if (const TimelineKey* top = key(*selected);
            top != nullptr && (keyMarkRect(place, top->frame).contains(point) ||
                               keyPictureRect(place, top->frame).contains(point)))
            return selected;
    for (auto each = owner.keys.rbegin(); each != owner.keys.rend(); ++each)
        if (keyMarkRect(place, each->frame).contains(point))
            return SpanRef{owner.id, each->id};
    for (auto each = owner.keys.rbegin(); each != owner.keys.rend(); ++each)
        if (keyPictureRect(place, each->frame).contains(point))
            return SpanRef{owner.id, each->id};
    return std::nullopt;
}

int Timeline::Private::snappedFrame(int frame, const std::optional<SpanRef>& except) const
{
    constexpr double reach = 6.0;
    int best = frame;
    double nearest = reach / scale.pixelsPerFrame() + 1e-9;
    const auto consider = [&](int candidate) {
        const double distance = std::abs(candidate - frame);
        if (distance < nearest) {
            nearest = distance;
            best = candidate;
        }
    };
    for (const TimelineTrack& owner : tracks) {
        for (const TimelineSpan& span : owner.spans) {
            consider(span.first);
            consider(span.last);
        }
        for (const TimelineKey& each : owner.keys) {
            if (except && *except == SpanRef{owner.id, each.id})
                continue;
            consider(static_cast<int>(std::lround(each.frame)));
            if (each.obtained)
                consider(static_cast<int>(std::lround(*each.obtained)));
        }
    }
    consider(current);
    return best;
}

int Timeline::Private::frameForKey(const QPointF& position, bool snap,
                                   const std::optional<SpanRef>& except) const
{
    const int frame = scale.nearestFrame(position.x() - headerWidth);
    return std::clamp(snap ? snappedFrame(frame, except) : frame, 0, scale.frameCount() - 1);
}

void Timeline::Private::paintKeys(QPainter& painter, const TimelineTrack& owner, const QRect& place) const
{
    std::vector<const TimelineKey*> order;
    for (const TimelineKey& each : owner.keys)
        order.push_back(&each);
    std::ranges::stable_sort(order, {}, [&](const TimelineKey* each) { return shownFrame(owner.id, *each); });
    const TimelineKey* top = nullptr;
    double roomOfTop = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        // What stands beside a picture ends at the next one.
        const int right = keyPictureRect(place, shownFrame(owner.id, *order[i])).right();
        const int end = i + 1 < order.size()
                            ? keyPictureRect(place, shownFrame(owner.id, *order[i + 1])).left()
                            : place.right();
        const double room = end - right - 8;
        if (selected == SpanRef{owner.id, order[i]->id}) {
            top = order[i];
            roomOfTop = room;
        } else {
            paintKey(painter, owner, place, *order[i], room);
        }
    }
    if (top != nullptr)
        paintKey(painter, owner, place, *top, roomOfTop);
}

void Timeline::Private::paintKey(QPainter& painter, const TimelineTrack& owner, const QRect& place,
                                 const TimelineKey& key, double room) const
{
    const bool isSelected = selected == SpanRef{owner.id, key.id};
    const double frame = shownFrame(owner.id, key);
    const double markHeight = std::min(keyMarkHeight, place.height());
    const QPointF mark(x(frame + 0.5), place.top() + markHeight / 2.0);
    const QColor color = Theme::color(ColorRole::Key);
    if (key.tolerance)
        paintBracket(painter, x(frame + 0.5 - *key.tolerance), x(frame + 0.5 + *key.tolerance), mark.y(),
                     lineColor(color));
    if (key.obtained) {
        const QPointF obtained(x(*key.obtained + 0.5), mark.y());
        const bool isMissed = key.tolerance && std::abs(*key.obtained - frame) > *key.tolerance + 1e-6;
        const QColor line = Theme::color(isMissed ? ColorRole::ErrorText : ColorRole::Text);
        painter.setPen(QPen(line, 1.5, isMissed ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(mark, obtained);
        painter.setPen(QPen(line, 1.5));
        painter.setBrush(Theme::color(ColorRole::Base));
        painter.drawEllipse(obtained, 3.5, 3.5);
    }
    painter.setPen(
        QPen(isSelected ? Theme::color(ColorRole::Text) : lineColor(color), isSelected ? 2.0 : 1.0));
    painter.setBrush(color);
    paintDiamond(painter, mark, std::min(markReach, markHeight / 2.0));

    const QRect box = keyPictureRect(place, frame);
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
    const QFontMetrics metrics = painter.fontMetrics();
    const QString time = frameText(frame);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(text.adjusted(0, 0, 0, -text.height() / 2), Qt::AlignLeft | Qt::AlignBottom,
                     metrics.elidedText(key.text, Qt::ElideMiddle, static_cast<int>(text.width())));
    painter.setPen(Theme::color(ColorRole::TextMuted));
    painter.drawText(text.adjusted(0, text.height() / 2, 0, 0), Qt::AlignLeft | Qt::AlignTop, time);
}

void Timeline::Private::paintKeyStems(QPainter& painter) const
{
    const QColor color = lineColor(Theme::color(ColorRole::Key));
    for (const TimelineTrack& owner : tracks)
        for (const TimelineKey& each : owner.keys) {
            const double place = x(shownFrame(owner.id, each) + 0.5);
            painter.setPen(QPen(color, 1.5));
            painter.drawLine(QPointF(place, rulerHeight - 9.0), QPointF(place, rulerHeight + gap));
        }
}

void Timeline::Private::paintDrop(QPainter& painter) const
{
    const TimelineTrack* owner = track(dropTrack);
    if (!dropFrame || owner == nullptr)
        return;
    const QRect place = row(static_cast<std::size_t>(owner - tracks.data()));
    const QColor color = lineColor(Theme::color(ColorRole::Key));
    const double middle = x(*dropFrame + 0.5);
    painter.setPen(QPen(color, 1.5, Qt::DashLine));
    painter.drawLine(QPointF(middle, 2.0), QPointF(middle, size.height()));
    painter.setBrush(Qt::NoBrush);
    if (!keyPictureRect(place, *dropFrame).isEmpty() && !owner->keys.empty())
        painter.drawRoundedRect(QRectF(keyPictureRect(place, *dropFrame)).adjusted(1, 1, -1, -1), 3, 3);
    painter.setPen(QPen(color, 1.0));
    painter.setBrush(Theme::color(ColorRole::Key));
    paintDiamond(painter, {middle, place.top() + keyMarkHeight / 2.0}, markReach);
    const QString text = frameText(*dropFrame);
    QRectF flag(middle + 6.0, 2.0, painter.fontMetrics().horizontalAdvance(text) + 12.0, rulerHeight - 10.0);
    if (flag.right() > size.width())
        flag.moveRight(middle - 6.0);
    painter.setPen(Qt::NoPen);
    painter.drawRoundedRect(flag, 3.0, 3.0);
    painter.setPen(Theme::color(ColorRole::OnMark));
    painter.drawText(flag, Qt::AlignCenter, text);
}

} // namespace quadrille::widgets
