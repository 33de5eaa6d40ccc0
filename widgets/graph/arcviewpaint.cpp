// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/arcview.h"
#include "widgets/graph/chartscale.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr float opacityOfOne = 0.35F;
constexpr double widthPerDoubling = 0.35; // of a bundle's line

void drawCurve(QPainter& painter, const ArcCurve& curve)
{
    // Degrees in sixteenths, counterclockwise from three o'clock.
    painter.drawArc(curve.ellipse(), curve.height >= 0 ? 0 : 180 * 16, 180 * 16);
}

} // namespace

void ArcView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (isEmpty()) {
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    } else {
        const double ratio = devicePixelRatioF();
        if (m_picture.isNull() || m_picture.devicePixelRatio() != ratio) {
            m_picture = QPixmap((QSizeF(size()) * ratio).toSize());
            m_picture.setDevicePixelRatio(ratio);
            m_picture.fill(Theme::color(ColorRole::Window));
            QPainter arcs(&m_picture);
            arcs.setRenderHint(QPainter::Antialiasing);
            paintArcs(arcs);
        }
        painter.drawPixmap(0, 0, m_picture);
        paintBars(painter);
        paintTitles(painter);
        paintCurrent(painter);
    }
    if (hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void ArcView::paintArcs(QPainter& painter) const
{
    for (const Side side : {Side::Above, Side::Below}) {
        for (const ArcBundle& bundle : shown(side)) {
            const ArcCurve place = curve(side, bundle.lightest);
            if (std::max(place.from, place.to) < 0 || std::min(place.from, place.to) > width())
                continue;
            QColor color = m_sequences[static_cast<std::size_t>(sequenceOf(bundle.lightest.from))].color;
            color.setAlphaF(opacityOfOne);
            painter.setPen(QPen(color, 1 + widthPerDoubling * std::log2(bundle.count)));
            drawCurve(painter, place);
        }
    }
}

void ArcView::paintBars(QPainter& painter) const
{
    const QFontMetricsF metrics(font());
    for (std::size_t i = 0; i < m_sequences.size(); ++i) {
        const QRectF bar = sequenceRect(static_cast<int>(i)).adjusted(0.5, 0, -0.5, 0);
        painter.fillRect(bar, m_sequences[i].color);
        const QRectF room = bar.intersected(QRectF(rect())).adjusted(4, 0, -4, 0);
        if (room.width() < metrics.averageCharWidth() * 2)
            continue;
        painter.setPen(Theme::textOn(m_sequences[i].color));
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(m_sequences[i].name, Qt::ElideRight, room.width()));
    }
}

void ArcView::paintTitles(QPainter& painter) const
{
    const QFontMetricsF metrics(font());
    for (const Side side : {Side::Above, Side::Below}) {
        const Half& own = half(side);
        if (!own.arcs)
            continue;
        int edges = 0;
        for (const ArcBundle& bundle : own.shown)
            edges += bundle.count;
        const QLocale locale;
        const auto all = static_cast<int>(own.arcs->size());
        const QString text = edges == all
                                 //: name of a graph; how many edges
                                 ? tr("%1: %2 transitions").arg(own.title, locale.toString(all))
                                 //: name of a graph; how many edges show; how many there are
                                 : tr("%1: %2 of %3 transitions, the cheapest")
                                       .arg(own.title, locale.toString(edges), locale.toString(all));
        const double y = side == Side::Above ? chartGap / 2 : height() - metrics.height() - chartGap / 2;
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRectF(chartGap, y, width() - 2 * chartGap, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(text, Qt::ElideRight, width() - 2 * chartGap));
    }
}

void ArcView::paintCurrent(QPainter& painter) const
{
    if (!m_current)
        return;
    const ArcCurve place = curve(m_current->side, m_current->arc);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Theme::color(ColorRole::Window), 5));
    drawCurve(painter, place);
    const QColor color = Theme::color(ColorRole::Text);
    painter.setPen(QPen(color, 2.5));
    drawCurve(painter, place);
    // An arrow's head where it arrives.
    const double direction = place.height >= 0 ? -1 : 1;
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(
        QPolygonF({QPointF(place.to, place.base), QPointF(place.to - 5, place.base + 9 * direction),
                   QPointF(place.to + 5, place.base + 9 * direction)}));
    const QFontMetricsF metrics(font());
    const QString text = arcText(m_current->arc);
    QRectF box(0, 0, metrics.horizontalAdvance(text) + 2 * chartGap, metrics.height() + chartGap);
    box.moveCenter({(place.from + place.to) / 2, place.base - place.height});
    box.moveLeft(std::clamp(box.left(), 2.0, std::max(width() - box.width() - 2, 2.0)));
    box.moveTop(std::clamp(box.top(), 2.0, std::max(height() - box.height() - 2, 2.0)));
    painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
    painter.setBrush(Theme::color(ColorRole::Window));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace quadrille::widgets
