// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/elidedpair.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/framekind.h"
#include "widgets/timeline/timelineprivate.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

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
    paintLoop(painter);
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
        const bool isTime = seconds && frame > 0; // the first one is whole, too, and leaves room for the next
        const QString label = isTime ? timeText(frame / fps) : QString::number(std::llround(frame));
        const double width = painter.fontMetrics().horizontalAdvance(label);
        const double left = std::max(place - width / 2.0, headerWidth + 2.0);
        if (left + width > size.width())
            continue;
        painter.drawText(QRectF(left, 1.0, labelPixels, rulerHeight - 11.0), Qt::AlignVCenter | Qt::AlignLeft,
                         label);
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
    if (!isRangeEditable)
        return;
    paintHandle(x(in), 1.0);
    paintHandle(x(out + 1), -1.0);
}

void Timeline::Private::paintTrack(QPainter& painter, std::size_t index, const QPalette& palette) const
{
    const TimelineTrack& owner = tracks[index];
    const QRect place = row(index);
    painter.fillRect(place, Theme::color(ColorRole::Base));
    paintTitle(painter, owner, place);
    painter.save();
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.setClipRect(place);
    if (owner.spans.empty() && owner.keys.empty() && !owner.hint.isEmpty() && place.height() > foldedHeight)
        painter.drawText(place.adjusted(6, 0, -6, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         painter.fontMetrics().elidedText(owner.hint, Qt::ElideRight, place.width() - 12));
    for (const TimelineSpan& span : owner.spans)
        if (owner.kind == TimelineTrack::Kind::Notes)
            paintNote(painter, owner, place, span);
        else
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
    const FrameKind kind = span.hatched  ? FrameKind::Transition
                           : span.dotted ? FrameKind::Varied
                                         : FrameKind::Captured;
    paintFramePattern(painter, box.adjusted(1.0, 1.0, -1.0, -1.0), kind, color);
    constexpr double smallestText = 24.0;
    if (owner.kind == TimelineTrack::Kind::Contacts || span.text.isEmpty() || place.height() <= foldedHeight)
        return;
    // The part that shows carries the name, also when the span starts left of the view.
    QRectF seen = box.intersected(place).adjusted(6.0, 0.0, -4.0, 0.0);
    // What lies above the span hides neither end of its name.
    bool isAbove = false;
    for (const TimelineSpan& other : owner.spans) {
        const QRectF cover = rect(place, other.first, other.last);
        if (isAbove && cover.left() > seen.left() && cover.left() < seen.right())
            seen.setRight(cover.left() - 4.0);
        else if (isAbove && cover.left() <= seen.left() && cover.right() > seen.left())
            seen.setLeft(cover.right() + 4.0);
        isAbove = isAbove || other.id == span.id;
    }
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

} // namespace quadrille::widgets
