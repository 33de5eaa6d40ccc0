// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/chartscale.h"
#include "widgets/graph/takegraphview.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr float faint = 0.12F;         // what is not chosen
constexpr float plain = 0.6F;          // links
constexpr std::size_t mostCounts = 40; // with more links only those that are pointed at have their number

} // namespace

void TakeGraphView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.fillRect(rect(), Theme::color(ColorRole::Window));
    if (m_nodes.empty()) {
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    } else {
        for (const TakeLink& link : m_links)
            paintLink(painter, link);
        for (int node = 0; node < static_cast<int>(m_nodes.size()); ++node)
            paintNode(painter, node);
        for (const TakeLink& link : m_links)
            paintCount(painter, link);
        const QFontMetricsF metrics(font());
        painter.setPen(Theme::color(ColorRole::TextMuted));
        painter.drawText(QRectF(chartGap, chartGap / 2, width() - 2 * chartGap, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(m_title, Qt::ElideRight, width() - 2 * chartGap));
    }
    if (hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void TakeGraphView::paintLink(QPainter& painter, const TakeLink& link) const
{
    if (link.from == link.to)
        return;
    const bool isPointedAt = link == m_hoveredLink || link.from == m_hoveredNode;
    QColor color =
        isPointedAt ? Theme::color(ColorRole::Text) : m_nodes[static_cast<std::size_t>(link.from)].color;
    color.setAlphaF(isPointedAt ? 1.0F : stands(link) ? plain : faint);
    const double breadth = linkWidth(link);
    const QPainterPath path = pathOf(link);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, breadth, Qt::SolidLine, Qt::FlatCap));
    painter.drawPath(path);
    const QPointF tip = path.pointAtPercent(1);
    const QPointF before = path.pointAtPercent(0.9);
    const QPointF along =
        (tip - before) / std::max(std::hypot(tip.x() - before.x(), tip.y() - before.y()), 1.0);
    const QPointF across(-along.y(), along.x());
    const double head = 4 + breadth * 0.8;
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF({tip + along * (head * 0.6), tip - along * head + across * head,
                                   tip - along * head - across * head}));
}

void TakeGraphView::paintCount(QPainter& painter, const TakeLink& link) const
{
    const bool isPointedAt = link == m_hoveredLink || link.from == m_hoveredNode || link.to == m_hoveredNode;
    if (!isPointedAt && (!stands(link) || m_links.size() > mostCounts))
        return;
    const QFontMetricsF metrics(font());
    const QString count = QLocale().toString(link.count);
    //: how many transitions lead from frames of a take to others of the same take
    const QString text = link.from == link.to ? tr("↻ %1").arg(count) : count;
    QRectF box(0, 0, metrics.horizontalAdvance(text) + chartGap, metrics.height());
    box.moveCenter(linkMiddle(link));
    painter.setPen(QPen(Theme::color(isPointedAt ? ColorRole::Text : ColorRole::Line), 1.0));
    painter.setBrush(Theme::color(ColorRole::Window));
    painter.drawRoundedRect(box, box.height() / 2, box.height() / 2);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(box, Qt::AlignCenter, text);
}

void TakeGraphView::paintNode(QPainter& painter, int node) const
{
    const TakeNode& own = m_nodes[static_cast<std::size_t>(node)];
    const QRectF box = nodeRect(node);
    const bool isChosen = std::ranges::count(m_chosen, node) > 0;
    painter.setOpacity(stands(node) || node == m_hoveredNode ? 1.0 : 0.45);
    painter.setPen(QPen(own.color, isChosen ? 4 : 2));
    painter.setBrush(Theme::color(ColorRole::Raised));
    painter.drawRoundedRect(box, 6, 6);
    if (!own.picture.isNull())
        painter.drawImage(box.adjusted(3, 3, -3, -3), own.picture);
    if (node == m_current && hasFocus()) {
        painter.setPen(QPen(Theme::color(ColorRole::AccentText), 1.0, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box.adjusted(-4, -4, 4, 4), 8, 8);
    }
    const QFontMetricsF metrics(font());
    const double room = std::max(box.width() * 2, 80.0);
    QRectF place(0, box.bottom() + 2, room, metrics.height());
    place.moveLeft(std::clamp(box.center().x() - room / 2, 2.0, std::max(width() - room - 2, 2.0)));
    QFont font = painter.font();
    font.setBold(isChosen);
    painter.setFont(font);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(place, Qt::AlignCenter, metrics.elidedText(own.name, Qt::ElideMiddle, room));
    font.setBold(false);
    painter.setFont(font);
    painter.setOpacity(1.0);
}

} // namespace quadrille::widgets
