// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/chartscale.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double tickWidth = 44;  // room for a number along x
constexpr double tickHeight = 28; // along y
constexpr double signRadius = 3;  //
constexpr double swatch = 20;     // of the legend

QString heading(const ChartAxis& axis)
{
    if (axis.unit.isEmpty())
        return axis.title;
    //: title of an axis, then its unit
    return LineChart::tr("%1 (%2)").arg(axis.title, axis.unit);
}

void paintSign(QPainter& painter, ChartSeries::Sign sign, const QPointF& middle, const QColor& color)
{
    painter.setPen(QPen(Theme::color(ColorRole::Base), 1.0));
    painter.setBrush(color);
    if (sign == ChartSeries::Sign::Circle) {
        painter.drawEllipse(middle, signRadius, signRadius);
        return;
    }
    const double reach = signRadius * 1.3;
    painter.drawPolygon(QPolygonF({middle + QPointF(0, -reach), middle + QPointF(reach, 0),
                                   middle + QPointF(0, reach), middle + QPointF(-reach, 0)}));
}

QPen linePen(const ChartSeries& series)
{
    return {series.color, 2.0, series.isDashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

int ticksIn(double pixels, double each)
{
    return std::max(static_cast<int>(std::abs(pixels) / each), 2);
}

} // namespace

/// Where each entry of the legend begins: one after the other, in as many rows as that takes.
std::vector<QPointF> LineChart::legendPlaces() const
{
    const QFontMetricsF metrics(Theme::tabularFont(font()));
    std::vector<QPointF> places;
    QPointF place(chartGap, chartGap / 2 + metrics.height() * 1.5 + 2);
    for (const ChartSeries& series : m_series) {
        const double width = swatch + chartGap / 2 + metrics.horizontalAdvance(series.name);
        if (place.x() > chartGap && place.x() + width > this->width() - chartGap)
            place = {chartGap, place.y() + metrics.height()};
        places.push_back(place);
        place.rx() += width + 2 * chartGap;
    }
    return places;
}

/// Title and legend above, numbers and title of x below.
QRectF LineChart::plotArea() const
{
    const QFontMetricsF metrics(Theme::tabularFont(font()));
    const double line = metrics.height();
    const auto places = legendPlaces();
    const double legend = places.empty() ? 0.0 : places.back().y() - places.front().y();
    QRectF plot = QRectF(rect()).adjusted(0, 2 * line + chartGap + chartGap / 2 + legend, -2 * chartGap,
                                          -(2 * line + chartGap));
    const ChartScale y = yScale(plot.bottom(), plot.top());
    double widest = std::max(metrics.horizontalAdvance(QStringLiteral("0.0000")), 40.0);
    for (const double tick : chartTicks(y, ticksIn(plot.height(), tickHeight)))
        widest = std::max(widest, metrics.horizontalAdvance(chartNumber(tick)));
    plot.setLeft(widest + chartGap + chartGap / 2);
    return plot;
}

void LineChart::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(Theme::tabularFont(font()));
    if (isEmpty()) {
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    } else {
        painter.fillRect(plotArea(), Theme::color(ColorRole::Base));
        paintAxes(painter);
        painter.save();
        painter.setClipRect(plotArea().adjusted(-4, -4, 4, 4));
        paintSeries(painter);
        painter.restore();
        paintMarker(painter);
        paintLegend(painter);
        paintReadOut(painter);
    }
    if (hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void LineChart::paintAxes(QPainter& painter) const
{
    const QFontMetricsF metrics(painter.font());
    const QRectF plot = plotArea();
    const ChartScale x = xScale();
    const ChartScale y = yScale();
    for (const double tick : chartTicks(x, ticksIn(plot.width(), tickWidth))) {
        const double at = std::floor(x.position(tick)) + 0.5;
        painter.setPen(Theme::color(ColorRole::Divider));
        painter.drawLine(QPointF(at, plot.top()), QPointF(at, plot.bottom()));
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRectF(at - tickWidth / 2, plot.bottom() + 2, tickWidth, metrics.height()),
                         Qt::AlignCenter, chartNumber(tick));
    }
    for (const double tick : chartTicks(y, ticksIn(plot.height(), tickHeight))) {
        const double at = std::floor(y.position(tick)) + 0.5;
        painter.setPen(Theme::color(ColorRole::Divider));
        painter.drawLine(QPointF(plot.left(), at), QPointF(plot.right(), at));
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRectF(0, at - metrics.height() / 2, plot.left() - chartGap / 2, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, chartNumber(tick));
    }
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    painter.drawLine(plot.bottomLeft(), plot.topLeft());
    painter.setPen(Theme::color(ColorRole::TextMuted));
    painter.drawText(
        QRectF(plot.left(), height() - metrics.height() - chartGap / 2, plot.width(), metrics.height()),
        Qt::AlignCenter, heading(m_x));
    QFont bold = painter.font();
    bold.setWeight(QFont::DemiBold);
    painter.save();
    painter.setFont(bold);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(QRectF(chartGap, chartGap / 2, width() - 2 * chartGap, metrics.height()),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(bold).elidedText(heading(m_y), Qt::ElideRight, width() - 2 * chartGap));
    painter.restore();
}

void LineChart::paintSeries(QPainter& painter) const
{
    const ChartScale x = xScale();
    const ChartScale y = yScale();
    for (const ChartSeries& series : m_series) {
        QPolygonF line;
        for (const QPointF& point : series.points)
            if ((!m_x.isLogarithmic || point.x() > 0) && (!m_y.isLogarithmic || point.y() > 0))
                line << QPointF(x.position(point.x()), y.position(point.y()));
        painter.setPen(linePen(series));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(line);
        // Signs that touch each other would be a band.
        if (static_cast<double>(line.size()) * 3 * signRadius > plotArea().width())
            continue;
        for (const QPointF& point : line)
            paintSign(painter, series.sign, point, series.color);
    }
}

void LineChart::paintMarker(QPainter& painter) const
{
    if (!m_marker || (m_x.isLogarithmic && *m_marker <= 0))
        return;
    const QRectF plot = plotArea();
    const double at = xScale().position(*m_marker);
    if (at < plot.left() - 1 || at > plot.right() + 1)
        return;
    const QColor color = Theme::color(ColorRole::AccentText);
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(at, plot.top() - 2), QPointF(at, plot.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF(
        {QPointF(at - 5, plot.top() - 8), QPointF(at + 5, plot.top() - 8), QPointF(at, plot.top())}));
}

void LineChart::paintLegend(QPainter& painter) const
{
    const QFontMetricsF metrics(painter.font());
    const auto places = legendPlaces();
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        const ChartSeries& series = m_series[i];
        double left = places[i].x();
        const double middle = places[i].y();
        painter.setPen(linePen(series));
        painter.drawLine(QPointF(left, middle), QPointF(left + swatch, middle));
        paintSign(painter, series.sign, {left + swatch / 2, middle}, series.color);
        left += swatch + chartGap / 2;
        painter.setPen(Theme::color(ColorRole::Text));
        const double room = std::max(width() - left - chartGap, 0.0);
        painter.drawText(QPointF(left, middle + metrics.ascent() / 2 - metrics.descent() / 2),
                         metrics.elidedText(series.name, Qt::ElideRight, room));
    }
}

void LineChart::paintReadOut(QPainter& painter) const
{
    if (!m_readX)
        return;
    const QFontMetricsF metrics(painter.font());
    const QRectF plot = plotArea();
    const double at = xScale().position(*m_readX);
    painter.setPen(QPen(Theme::color(ColorRole::TextMuted), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(at, plot.top()), QPointF(at, plot.bottom()));
    const QStringList lines = readOut().split(QStringLiteral("; "));
    double widest = 0;
    for (const QString& line : lines)
        widest = std::max(widest, metrics.horizontalAdvance(line));
    const QSizeF size(widest + 2 * chartGap, metrics.height() * static_cast<double>(lines.size()) + chartGap);
    const bool isLeft = at + chartGap + size.width() > plot.right();
    QRectF box({isLeft ? at - chartGap - size.width() : at + chartGap, plot.top() + chartGap / 2}, size);
    box.moveLeft(std::max(box.left(), 0.0));
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
    painter.setBrush(Theme::color(ColorRole::Window));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(box.adjusted(chartGap, chartGap / 2, -chartGap, -chartGap / 2),
                     Qt::AlignLeft | Qt::AlignVCenter, lines.join(u'\n'));
}

} // namespace quadrille::widgets
