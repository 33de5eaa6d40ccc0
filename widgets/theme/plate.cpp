// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/plate.h"

#include "widgets/theme/theme.h"

#include <QFontMetricsF>
#include <QPainter>

namespace quadrille::widgets {

namespace {

constexpr double labelMargin = 8; // pixels

double markWidthOf(const QColor& mark)
{
    return mark.isValid() ? 14.0 : 0.0;
}

} // namespace

QColor plateColor()
{
    QColor color = Theme::color(ColorRole::Base);
    color.setAlphaF(0.86F);
    return color;
}

void paintPlate(QPainter& painter, const QRectF& place, double radius)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(plateColor());
    painter.drawRoundedRect(place, radius, radius);
}

QSizeF labelSize(const QPainter& painter, const QString& text, const QColor& mark)
{
    const QFontMetricsF metrics(painter.font());
    return {metrics.horizontalAdvance(text) + 2 * labelMargin + markWidthOf(mark), metrics.height() + 6.0};
}

void paintLabel(QPainter& painter, const QRectF& place, const QString& text, const QColor& mark)
{
    paintPlate(painter, place);
    if (mark.isValid()) {
        painter.setBrush(mark);
        painter.drawEllipse(QPointF(place.left() + 12.0, place.center().y()), 4.0, 4.0);
    }
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(place.adjusted(labelMargin + markWidthOf(mark), 0.0, -labelMargin, 0.0), Qt::AlignCenter,
                     text);
}

} // namespace quadrille::widgets
