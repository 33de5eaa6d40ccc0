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

/// Diagonal lines, so that synthetic frames are told by more than colour.
void paintHatching(QPainter& painter, const QRectF& box, const QColor& color)
{
    painter.save();
    painter.setClipRect(box, Qt::IntersectClip);
    painter.setPen(QPen(color, 1.5));
    constexpr double step = 7.0;
    const double start = std::floor((box.left() - box.height()) / step) * step;
    for (double x = start; x < box.right(); x += step)
        painter.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
    painter.restore();
}

} // namespace

QRect Timeline::Private::playheadRect(int frame) const
{
    constexpr int reach = 48;
    return {x(frame + 0.5) - reach, 0, 2 * reach, size.height()};
}

void Timeline::Private::paint(QPainter& painter, const QRect& exposed, const Timeline& timeline) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(exposed, Theme::color(ColorRole::Window));
    if (isEmpty) {
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRect(QPoint(), size), Qt::AlignCenter, Timeline::tr("Nothing to play yet"));
        return;
    }
    painter.fillRect(QRect(headerWidth, 0, size.width() - headerWidth, rulerHeight),
                     Theme::color(ColorRole::Raised));
    for (std::size_t i = 0; i < tracks.size(); ++i)
        paintTrack(painter, i, timeline.palette());
    painter.save();
    painter.setClipRect(QRect(headerWidth, 0, size.width() - headerWidth, size.height()));
    paintRange(painter);
    paintRuler(painter);
    // Poses may be wanted beyond what plays.
    for (std::size_t i = 0; i < tracks.size(); ++i)
        paintKeys(painter, tracks[i], row(i));
    paintKeyStems(painter);
    paintPlayhead(painter);
    paintDrop(painter);
    painter.restore();
    if (timeline.hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(QPointF(), size).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void Timeline::Private::paintRuler(QPainter& painter) const
{
    constexpr double labelPixels = 64.0;
    const bool seconds = unit == Unit::Seconds;
    const double step = seconds ? scale.secondStep(labelPixels, fps) * fps
                                : static_cast<double>(scale.frameStep(labelPixels));
    int divisions = 5;
    while (divisions > 1 &&
           (step / divisions * scale.pixelsPerFrame() < 5.0 || (!seconds && step < divisions)))
        --divisions;
    const double small = step / divisions;
    const auto from = static_cast<long long>(std::floor(scale.firstVisible() / small));
    const auto to = static_cast<long long>(std::ceil((scale.firstVisible() + scale.visibleFrames()) / small));
    const QColor text = Theme::color(ColorRole::TextMuted);
    for (long long i = from; i <= to; ++i) {
        const double frame = static_cast<double>(i) * small;
        if (frame < 0 || frame > scale.frameCount())
            continue;
        const bool numbered = i % divisions == 0;
        // A mark of frames stands in the middle of its frame, one of seconds at its moment.
        const double place = std::floor(headerWidth + scale.xOf(seconds ? frame : frame + 0.5)) + 0.5;
        painter.setPen(
            QPen(numbered ? Theme::color(ColorRole::Line) : Theme::color(ColorRole::Divider), 1.0));
        painter.drawLine(QPointF(place, rulerHeight - (numbered ? 9.0 : 5.0)),
                         QPointF(place, rulerHeight - 1.0));
        if (!numbered || (!seconds && frame >= scale.frameCount()))
            continue;
        painter.setPen(text);
        const QString label = seconds ? timeText(frame / fps) : QString::number(std::llround(frame));
        painter.drawText(QRectF(place - labelPixels / 2.0, 1.0, labelPixels, rulerHeight - 11.0),
                         Qt::AlignCenter, label);
    }
}

void Timeline::Private::paintRange(QPainter& painter) const
{
    const auto [storedIn, storedOut] = effectiveRange();
    const bool dragging =
        drag.kind == TimelineDrag::Kind::RangeStart || drag.kind == TimelineDrag::Kind::RangeEnd;
    const int in = dragging ? drag.first : storedIn;
    const int out = dragging ? drag.last : storedOut;
    QColor shade = Theme::color(ColorRole::Base);
    shade.setAlphaF(0.62F);
    painter.fillRect(QRect(QPoint(headerWidth, 0), QPoint(x(in) - 1, size.height())), shade);
    painter.fillRect(QRect(QPoint(x(out + 1), 0), QPoint(size.width(), size.height())), shade);
    const QColor handle = Theme::color(ColorRole::AccentText);
    painter.fillRect(QRectF(x(in), rulerHeight - 2.0, x(out + 1) - x(in), 2.0), handle);
    painter.setPen(Qt::NoPen);
    painter.setBrush(handle);
    const auto paintHandle = [&](double edge, double direction) {
        QPainterPath path;
        path.moveTo(edge, rulerHeight - 12.0);
        path.lineTo(edge + 6.0 * direction, rulerHeight - 2.0);
        path.lineTo(edge, rulerHeight - 2.0);
        path.closeSubpath();
        painter.drawPath(path);
    };
    paintHandle(x(in), 1.0);
    paintHandle(x(out + 1), -1.0);
}

void Timeline::Private::paintTrack(QPainter& painter, std::size_t index, const QPalette& palette) const
{
    const TimelineTrack& owner = tracks[index];
    const QRect place = row(index);
    painter.fillRect(place, Theme::color(ColorRole::Base));
    painter.setPen(palette.color(QPalette::PlaceholderText));
    const QRect title(8, place.top(), headerWidth - 16, place.height());
    painter.drawText(title, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(owner.title, Qt::ElideRight, title.width()));
    painter.save();
    painter.setClipRect(place);
    if (owner.spans.empty() && owner.keys.empty() && !owner.hint.isEmpty())
        painter.drawText(place.adjusted(6, 0, -6, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         painter.fontMetrics().elidedText(owner.hint, Qt::ElideRight, place.width() - 12));
    for (const TimelineSpan& span : owner.spans)
        paintSpan(painter, owner, place, shown(owner.id, span));
    if (drag.kind == TimelineDrag::Kind::Create && drag.moved && drag.span.track == owner.id) {
        const QRectF box = QRectF(rect(place, drag.first, drag.last)).adjusted(0.5, 1.5, -0.5, -1.5);
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.5, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box, 3.0, 3.0);
    }
    painter.restore();
}

void Timeline::Private::paintSpan(QPainter& painter, const TimelineTrack& owner, const QRect& place,
                                  const TimelineSpan& span) const
{
    const QRectF box = QRectF(rect(place, span.first, span.last)).adjusted(0.5, 1.0, -0.5, -1.0);
    if (box.right() < place.left() || box.left() > place.right())
        return;
    const bool isSelected = selected == SpanRef{owner.id, span.id};
    const QColor color = span.color.isValid() ? span.color : Theme::color(ColorRole::Accent);
    const double radius = std::min(3.0, box.width() / 2.0);
    // Light marks on light ground keep an outline that can be seen.
    painter.setPen(isSelected ? QPen(Theme::color(ColorRole::Text), 2.0)
                              : QPen(color.darker(Theme::instance().isDark() ? 130 : 160), 1.0));
    painter.setBrush(color);
    painter.drawRoundedRect(box, radius, radius);
    if (span.hatched) {
        QColor lines = Theme::textOn(color);
        lines.setAlphaF(0.35F);
        paintHatching(painter, box.adjusted(1.0, 1.0, -1.0, -1.0), lines);
    }
    constexpr double smallestText = 24.0;
    if (owner.kind == TimelineTrack::Kind::Contacts || span.text.isEmpty())
        return;
    // The part that shows carries the name, also when the span starts left of the view.
    const QRectF seen = box.intersected(place).adjusted(6.0, 0.0, -4.0, 0.0);
    // Between the lines of hatching a part of a text could not be read.
    const bool isCut = painter.fontMetrics().horizontalAdvance(span.text) > seen.width();
    if (seen.width() < smallestText || (span.hatched && isCut))
        return;
    painter.setPen(Theme::textOn(color));
    painter.drawText(
        seen, Qt::AlignVCenter | Qt::AlignLeft,
        painter.fontMetrics().elidedText(span.text, Qt::ElideRight, static_cast<int>(seen.width())));
}

void Timeline::Private::paintPlayhead(QPainter& painter) const
{
    const QColor color = Theme::color(ColorRole::Accent);
    const double place = std::floor(headerWidth + scale.xOf(current + 0.5)) + 0.5;
    constexpr double smallestCell = 10.0;
    if (scale.pixelsPerFrame() >= smallestCell) {
        QColor cell = color;
        cell.setAlphaF(0.16F);
        painter.fillRect(QRectF(x(current), rulerHeight, x(current + 1) - x(current), size.height()), cell);
    }
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(place, rulerHeight - 4.0), QPointF(place, size.height()));
    const QString label = unit == Unit::Seconds ? timeText(current / fps) : QString::number(current);
    const double width = std::max(24.0, painter.fontMetrics().horizontalAdvance(label) + 12.0);
    QRectF flag(place - width / 2.0, 2.0, width, rulerHeight - 10.0);
    // The flag stays whole at both ends.
    flag.moveLeft(std::clamp(flag.left(), static_cast<double>(headerWidth) + 1.0,
                             std::max(headerWidth + 1.0, size.width() - width - 1.0)));
    QPainterPath path;
    path.addRoundedRect(flag, 3.0, 3.0);
    QPainterPath tip;
    tip.moveTo(place - 5.0, flag.bottom() - 0.5);
    tip.lineTo(place, flag.bottom() + 5.0);
    tip.lineTo(place + 5.0, flag.bottom() - 0.5);
    tip.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPath(path.united(tip));
    painter.setPen(Theme::color(ColorRole::OnAccent));
    painter.drawText(flag, Qt::AlignCenter, label);
}

} // namespace quadrille::widgets
