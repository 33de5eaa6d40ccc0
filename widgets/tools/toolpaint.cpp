// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/toolpaint.h"

#include "widgets/theme/plate.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr double halo = 2.0; // pixels

} // namespace

void paintToolLine(QPainter& painter, const QPolygonF& line, const QColor& color, double width,
                   Qt::PenStyle style)
{
    painter.setBrush(Qt::NoBrush);
    QColor under = Theme::color(ColorRole::Base);
    under.setAlphaF(0.7F);
    painter.setPen(QPen(under, width + halo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(color, width, style, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

void paintHandle(QPainter& painter, const QPointF& at, const HandleLook& look)
{
    const double radius = look.radius + (look.isHovered || look.isSelected ? 1.5 : 0.0);
    QPainterPath form;
    switch (look.form) {
    case HandleLook::Form::Circle:
        form.addEllipse(at, radius, radius);
        break;
    case HandleLook::Form::Square:
        form.addRect(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius);
        break;
    case HandleLook::Form::Diamond:
        form.addPolygon(QPolygonF{at + QPointF(0, -radius * 1.4), at + QPointF(radius * 1.1, 0),
                                  at + QPointF(0, radius * 1.4), at + QPointF(-radius * 1.1, 0)});
        form.closeSubpath();
        break;
    case HandleLook::Form::Cross:
        form.addRect(at.x() - radius, at.y() - 1.5, 2.0 * radius, 3.0);
        form.addRect(at.x() - 1.5, at.y() - radius, 3.0, 2.0 * radius);
        form = form.simplified();
        break;
    }
    const QColor base = Theme::color(ColorRole::Base);
    painter.strokePath(form, QPen(base, 2.0 + halo));
    painter.fillPath(form, look.isSelected  ? Theme::color(ColorRole::Accent)
                           : look.isHovered ? Theme::color(ColorRole::Hover)
                                            : base);
    painter.strokePath(form, QPen(look.isSelected ? Theme::color(ColorRole::Text) : look.color, 2.0));
}

QRectF paintToolWords(QPainter& painter, const QPointF& at, const QString& text, double widest)
{
    constexpr int wrapped = Qt::AlignCenter | Qt::TextWordWrap;
    constexpr double tallest = 1024.0;
    QRectF plate =
        painter.boundingRect(QRectF(0.0, 0.0, widest, tallest), wrapped, text).adjusted(-6, -3, 6, 3);
    plate.moveCenter(at);
    paintPlate(painter, plate);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(plate.adjusted(2, 0, -2, 0), wrapped, text);
    return plate;
}

QRectF paintToolHint(QPainter& painter, const QSizeF& view, const QString& text)
{
    constexpr double margin = 32.0; // pixels
    return paintToolWords(painter, {view.width() / 2.0, view.height() - margin}, text,
                          std::max(view.width() - 4.0 * margin, margin));
}

} // namespace quadrille::widgets
