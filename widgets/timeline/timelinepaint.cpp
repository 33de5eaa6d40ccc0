// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinepaint.h"

#include "widgets/theme/theme.h"
#include "widgets/timeline/timeline.h"
#include "widgets/timeline/timelinegestures.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr int rulerHeight = TimelineLayout::rulerHeight;

/// Shades what does not play.
void paintRange(QPainter& painter, const TimelineLayout& layout, const TimelineDrag& drag)
{
    const auto [in, out] = drag.grip.isRange() ? std::pair(drag.first, drag.last) : layout.range();
    const int left = layout.x(in);
    const int right = layout.x(out + 1);
    const QSize size = layout.size();
    QColor shade = Theme::color(ColorRole::Base);
    shade.setAlphaF(0.62F);
    painter.fillRect(QRect(QPoint(layout.headerWidth(), 0), QPoint(left - 1, size.height())), shade);
    painter.fillRect(QRect(QPoint(right, 0), QPoint(size.width(), size.height())), shade);
    const QColor handle = Theme::color(ColorRole::AccentText);
    painter.fillRect(QRectF(left, rulerHeight - 2.0, right - left, 2.0), handle);
    if (!layout.content().isRangeEditable)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(handle);
    for (const auto& [edge, inwards] : {std::pair(left, 6.0), std::pair(right, -6.0)})
        painter.drawPolygon(QPolygonF{{edge + 0.0, rulerHeight - 12.0},
                                      {edge + inwards, rulerHeight - 2.0},
                                      {edge + 0.0, rulerHeight - 2.0}});
}

/// The part that plays again and again: a band along the top of the ruler.
void paintLoop(QPainter& painter, const TimelineLayout& layout, const TimelineDrag& drag)
{
    const bool isDragged =
        drag.moved && (drag.grip.isLoopEnd() || drag.grip.kind == TimelineGrip::Kind::NewLoop);
    if (!layout.content().loop && !isDragged)
        return;
    const auto [first, last] = isDragged ? std::pair(drag.first, drag.last) : *layout.content().loop;
    const int loopHeight = TimelineLayout::loopHeight;
    const QRectF band(layout.x(first), 0, layout.x(last + 1) - layout.x(first), loopHeight);
    QColor ground = Theme::color(ColorRole::Key);
    ground.setAlphaF(0.10F);
    painter.fillRect(QRectF(band.left(), loopHeight, band.width(), rulerHeight - loopHeight), ground);
    ground.setAlphaF(0.75F);
    painter.fillRect(band.adjusted(0, 1, 0, -2), ground);
    painter.setPen(QPen(Theme::color(ColorRole::Text), 1.5));
    for (const double end : {band.left() + 1, band.right() - 1})
        painter.drawLine(QPointF(end, 0), QPointF(end, rulerHeight - 2.0));
}

void paintRuler(QPainter& painter, const TimelineLayout& layout)
{
    constexpr double labelPixels = 64.0;
    const TimelineScale& scale = layout.scale();
    const double fps = layout.content().fps;
    const bool seconds = layout.content().inSeconds;
    const double step = seconds ? scale.secondStep(labelPixels, fps) * fps
                                : static_cast<double>(scale.frameStep(labelPixels));
    int divisions = 5;
    while (divisions > 1 &&
           (step / divisions * scale.pixelsPerFrame() < 5.0 || (!seconds && step < divisions)))
        --divisions;
    const double small = step / divisions;
    const auto from = static_cast<long long>(std::floor(scale.firstVisible() / small));
    const auto to = static_cast<long long>(std::ceil((scale.firstVisible() + scale.visibleFrames()) / small));
    for (long long i = from; i <= to; ++i) {
        const double frame = static_cast<double>(i) * small;
        if (frame < 0 || frame > scale.frameCount())
            continue;
        const bool numbered = i % divisions == 0;
        // A mark of frames stands in the middle of its frame, one of seconds at its moment.
        const double place =
            std::floor(layout.headerWidth() + scale.xOf(seconds ? frame : frame + 0.5)) + 0.5;
        painter.setPen(
            QPen(numbered ? Theme::color(ColorRole::Line) : Theme::color(ColorRole::Divider), 1.0));
        painter.drawLine(QPointF(place, rulerHeight - (numbered ? 9.0 : 5.0)),
                         QPointF(place, rulerHeight - 1.0));
        if (!numbered || (!seconds && frame >= scale.frameCount()))
            continue;
        const bool isTime = seconds && frame > 0; // the first one is whole, too, and leaves room for the next
        const QString label = isTime ? timeText(frame / fps) : QString::number(std::llround(frame));
        const double width = painter.fontMetrics().horizontalAdvance(label);
        const double left = std::max(place - width / 2.0, layout.headerWidth() + 2.0);
        if (left + width > layout.size().width())
            continue;
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRectF(left, 1.0, labelPixels, rulerHeight - 11.0), Qt::AlignVCenter | Qt::AlignLeft,
                         label);
    }
}

void paintPlayhead(QPainter& painter, const TimelineLayout& layout)
{
    const int current = layout.content().current;
    const int height = layout.size().height();
    const QColor color = Theme::color(ColorRole::Accent);
    const double place = std::floor(layout.headerWidth() + layout.scale().xOf(current + 0.5)) + 0.5;
    constexpr double smallestCell = 10.0;
    if (layout.scale().pixelsPerFrame() >= smallestCell) {
        QColor cell = color;
        cell.setAlphaF(0.16F);
        const int left = layout.x(current);
        painter.fillRect(QRectF(left, rulerHeight, layout.x(current + 1) - left, height), cell);
    }
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(place, rulerHeight - 4.0), QPointF(place, height));
    const QRectF flag = layout.playheadFlag(current);
    QPainterPath path;
    path.addRoundedRect(flag, 3.0, 3.0);
    QPainterPath tip;
    tip.addPolygon(QPolygonF{{place - 5.0, flag.bottom() - 0.5},
                             {place, flag.bottom() + 5.0},
                             {place + 5.0, flag.bottom() - 0.5}});
    tip.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPath(path.united(tip));
    painter.setPen(Theme::color(ColorRole::OnAccent));
    painter.drawText(flag, Qt::AlignCenter, layout.content().frameText(current));
}

} // namespace

void paintTimeline(QPainter& painter, const QRect& exposed, const TimelineLayout& layout,
                   const TimelineDrag& drag, const QPalette& palette, bool hasFocus)
{
    const TimelineContent& content = layout.content();
    const QSize size = layout.size();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(exposed, Theme::color(ColorRole::Window));
    if (content.isEmpty) {
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRect(QPoint(), size), Qt::AlignCenter, Timeline::tr("Nothing to play yet"));
        return;
    }
    const int right = size.width() - layout.headerWidth();
    painter.fillRect(QRect(layout.headerWidth(), 0, right, rulerHeight), Theme::color(ColorRole::Raised));
    for (const TimelineTrack& track : content.tracks)
        paintTimelineRow(painter, layout, drag, track, palette);
    painter.save();
    painter.setClipRect(QRect(layout.headerWidth(), 0, right, size.height()));
    paintRange(painter, layout, drag);
    paintLoop(painter, layout, drag);
    paintRuler(painter, layout);
    // Poses may be wanted beyond what plays.
    paintTimelineKeys(painter, layout, drag);
    paintPlayhead(painter, layout);
    paintTimelineDrop(painter, layout);
    painter.restore();
    if (hasFocus) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(QPointF(), size).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace quadrille::widgets
