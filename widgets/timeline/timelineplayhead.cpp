// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/theme.h"
#include "widgets/timeline/timelineprivate.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

QString Timeline::Private::frameText(double frame) const
{
    return unit == Unit::Seconds ? timeText(frame / fps) : QString::number(std::lround(frame));
}

QRectF Timeline::Private::playheadFlag(int frame, const QFontMetrics& metrics) const
{
    const double place = std::floor(headerWidth + scale.xOf(frame + 0.5)) + 0.5;
    const double width = std::max(24.0, metrics.horizontalAdvance(frameText(frame)) + 12.0);
    QRectF flag(place - width / 2.0, 2.0, width, rulerHeight - 10.0);
    // The flag stays whole at both ends.
    flag.moveLeft(
        std::clamp(flag.left(), headerWidth + 1.0, std::max(headerWidth + 1.0, size.width() - width - 1.0)));
    return flag;
}

QRect Timeline::Private::playheadRect(int frame, const QFontMetrics& metrics) const
{
    const double place = headerWidth + scale.xOf(frame + 0.5);
    const QRectF cell(x(frame), 0, x(frame + 1) - x(frame), size.height());
    const QRectF line(place - 6, 0, 12, size.height());
    // Two more pixels take what is smoothed into the pixels beside it where a point is no whole number of
    // them.
    return playheadFlag(frame, metrics).united(cell).united(line).toAlignedRect().adjusted(-2, -2, 2, 2);
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
    const QRectF flag = playheadFlag(current, painter.fontMetrics());
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
    painter.drawText(flag, Qt::AlignCenter, frameText(current));
}

} // namespace quadrille::widgets
