// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// How a curve editor draws.
#include "widgets/charts/curveeditor.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <array>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double gap = 4;
constexpr double margin = 8;
constexpr double pointRadius = 4.5;
constexpr double labelDistance = 44; // least pixels from one number of an axis to the next

/// Seconds from one line of the grid to the next.
double gridStep(double seconds, double pixels)
{
    constexpr std::array steps = {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 300.0};
    for (const double step : steps) {
        if (step / seconds * pixels >= labelDistance)
            return step;
    }
    return seconds;
}

QString numberText(double seconds, double step)
{
    const int decimals = step < 0.1 ? 2 : step < 1 ? 1 : 0;
    return QLocale().toString(seconds, 'f', decimals);
}

} // namespace

QRectF CurveEditor::area() const
{
    const QFontMetricsF metrics(font());
    const double left = metrics.horizontalAdvance(QStringLiteral("00.0")) + 3 * gap;
    return QRectF(rect()).adjusted(left, metrics.height() + margin, -margin - pointRadius,
                                   -2 * metrics.height() - 2 * gap);
}

void CurveEditor::resizeEvent(QResizeEvent* /*event*/)
{
    update();
}

void CurveEditor::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(area(), Theme::color(ColorRole::Base));
    paintGrid(painter);
    paintCurve(painter);
    paintPoints(painter);
    paintReading(painter);
    if (hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void CurveEditor::paintGrid(QPainter& painter) const
{
    const QRectF place = area();
    const QFontMetricsF metrics(font());
    const QPen line(Theme::color(ColorRole::Divider), 1.0);
    const QColor text = Theme::color(ColorRole::TextMuted);
    const double across = gridStep(m_shown.width(), place.width());
    for (int i = 0; i * across <= m_shown.width(); ++i) {
        const double x = std::floor(positionOf({i * across, 0}).x()) + 0.5;
        painter.setPen(line);
        painter.drawLine(QPointF(x, place.top()), QPointF(x, place.bottom()));
        painter.setPen(text);
        painter.drawText(QRectF(x - labelDistance / 2, place.bottom() + gap, labelDistance, metrics.height()),
                         Qt::AlignHCenter | Qt::AlignTop, numberText(i * across, across));
    }
    const double upwards = gridStep(m_shown.height(), place.height());
    for (int i = 0; i * upwards <= m_shown.height() * (1 + 1e-9); ++i) {
        const double y = std::floor(positionOf({0, i * upwards}).y()) + 0.5;
        painter.setPen(line);
        painter.drawLine(QPointF(place.left(), y), QPointF(place.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(0, y - metrics.height() / 2, place.left() - 2 * gap, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, numberText(i * upwards, upwards));
    }
    painter.setPen(text);
    painter.drawText(QRectF(gap, 0, width() - 2 * gap, metrics.height() + gap),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(m_momentTitle, Qt::ElideRight, width() - 2 * gap));
    painter.drawText(QRectF(place.left(), height() - metrics.height() - gap, place.width(), metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter,
                     metrics.elidedText(m_timeTitle, Qt::ElideRight, place.width()));
}

void CurveEditor::paintCurve(QPainter& painter) const
{
    const QRectF place = area();
    painter.save();
    painter.setClipRect(place.adjusted(0, -2, 0, 2));
    QPen own(Theme::color(ColorRole::Line), 1.0, Qt::DashLine);
    painter.setPen(own);
    painter.drawLine(positionOf({0, 0}), positionOf({m_length, m_length}));
    QPainterPath path(positionOf(m_points.front()));
    const double first = positionOf(m_points.front()).x();
    const double last = positionOf(m_points.back()).x();
    for (double x = first; x < last; x += 1)
        path.lineTo(x, positionOf({0, m_curve(pointAt({x, 0}).x())}).y());
    path.lineTo(positionOf(m_points.back()));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Theme::color(ColorRole::AccentText), 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
    painter.restore();
}

void CurveEditor::paintPoints(QPainter& painter) const
{
    for (int i = 0; i < m_points.size(); ++i) {
        const bool isMarked = i == m_selected;
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), i == m_hovered ? 2.5 : 1.5));
        painter.setBrush(Theme::color(isMarked ? ColorRole::AccentText : ColorRole::Base));
        painter.drawEllipse(positionOf(m_points[i]), pointRadius, pointRadius);
    }
}

/// What the selected point says, at the upper right.
void CurveEditor::paintReading(QPainter& painter) const
{
    if (m_selected < 0)
        return;
    const QPointF& point = m_points[m_selected];
    const QString reading =
        tr("%1 s shows %2 s", "time in the result, moment of the clip")
            .arg(QLocale().toString(point.x(), 'f', 2), QLocale().toString(point.y(), 'f', 2));
    const QFontMetricsF metrics(font());
    const QRectF place = area();
    const QRectF box(place.right() - metrics.horizontalAdvance(reading) - 3 * gap,
                     place.bottom() - metrics.height() - 3 * gap,
                     metrics.horizontalAdvance(reading) + 2 * gap, metrics.height() + gap);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::color(ColorRole::Raised));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(box, Qt::AlignCenter, reading);
}

} // namespace quadrille::widgets
