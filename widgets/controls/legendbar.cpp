// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/legendbar.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double barWidth = 12.0;
constexpr double barHeight = 140.0;
constexpr double legendGap = 8.0;
constexpr int ticks = 5;

QString heading(const ScalarRange& range)
{
    if (range.unit.isEmpty())
        return range.title;
    //: title of a legend, then its unit
    return QCoreApplication::translate("LegendBar", "%1 (%2)").arg(range.title, range.unit);
}

QString tickText(const ScalarRange& range, int tick)
{
    const double value = range.minimum + (range.maximum - range.minimum) * tick / (ticks - 1);
    const double largest = std::max(std::abs(range.minimum), std::abs(range.maximum));
    const int decimals =
        largest > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 6) : 0;
    return QLocale().toString(value, 'f', decimals);
}

} // namespace

QSizeF legendSize(const QFont& font, const ScalarRange& range)
{
    const QFontMetricsF metrics(font);
    double widest = 0.0;
    for (int tick = 0; tick < ticks; ++tick)
        widest = std::max(widest, metrics.horizontalAdvance(tickText(range, tick)));
    const bool titled = !heading(range).isEmpty();
    return {std::max(barWidth + legendGap + widest, metrics.horizontalAdvance(heading(range))),
            (titled ? metrics.height() + legendGap : 0.0) + barHeight + metrics.height()};
}

void paintLegend(QPainter& painter, const QRectF& place, const ScalarRange& range, const QColor& text)
{
    const QFontMetricsF metrics(painter.font());
    QRectF bar(place.left(), place.top() + metrics.height() / 2.0, barWidth, 0.0);
    painter.setPen(text);
    if (!heading(range).isEmpty()) {
        painter.drawText(QPointF(place.left(), place.top() + metrics.ascent()), heading(range));
        bar.translate(0.0, metrics.height() + legendGap);
    }
    bar.setBottom(place.bottom() - metrics.height() / 2.0);
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    constexpr int stops = 32;
    for (int i = 0; i <= stops; ++i)
        gradient.setColorAt(static_cast<double>(i) / stops,
                            mapColor(range.map, static_cast<double>(i) / stops));
    painter.fillRect(bar, gradient);
    for (int tick = 0; tick < ticks; ++tick) {
        const double y = bar.bottom() - bar.height() * tick / (ticks - 1);
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 3.0, y));
        painter.drawText(
            QPointF(bar.right() + legendGap, y + metrics.ascent() / 2.0 - metrics.descent() / 2.0),
            tickText(range, tick));
    }
}

LegendBar::LegendBar(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("legendBar"));
}

void LegendBar::setRange(const ScalarRange& range)
{
    m_range = range;
    setAccessibleName(heading(range));
    updateGeometry();
    update();
}

QSize LegendBar::sizeHint() const
{
    return legendSize(font(), m_range).toSize() + QSize(2, 2);
}

void LegendBar::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLegend(painter, QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), m_range,
                palette().color(QPalette::WindowText));
}

} // namespace quadrille::widgets

#include "moc_legendbar.cpp"
