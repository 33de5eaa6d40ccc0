// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/framekind.h"

#include "widgets/theme/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <cmath>

namespace quadrille::widgets {

namespace {

/// Diagonal lines.
void paintHatching(QPainter& painter, const QRectF& box, const QColor& color)
{
    painter.save();
    painter.setClipRect(box, Qt::IntersectClip);
    painter.setPen(QPen(color, 1.5));
    constexpr double step = 7.0;
    const double start = std::floor((box.left() - box.height()) / step) * step;
    for (double x = start; x < box.right(); x += step)
        painter.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
    painter.restore();
}

/// Dots in rows.
void paintDots(QPainter& painter, const QRectF& box, const QColor& color)
{
    painter.save();
    painter.setClipRect(box, Qt::IntersectClip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    constexpr double step = 6.0;
    constexpr double radius = 1.2;
    const double top = box.top() + std::fmod(box.height(), step) / 2 + step / 2;
    bool isOdd = false;
    for (double y = top; y < box.bottom(); y += step) {
        const double start = std::floor(box.left() / step) * step + (isOdd ? step / 2 : 0);
        for (double x = start; x < box.right(); x += step)
            painter.drawEllipse(QPointF(x, y), radius, radius);
        isOdd = !isOdd;
    }
    painter.restore();
}

} // namespace

QColor frameKindColor(FrameKind kind)
{
    constexpr int purple = 6; // of the colours that nobody mistakes
    switch (kind) {
    case FrameKind::Captured:
        return Theme::color(ColorRole::Original);
    case FrameKind::Varied:
        return Theme::categorical(purple);
    case FrameKind::Transition:
        return Theme::color(ColorRole::Synthetic);
    }
    return {};
}

QString frameKindName(FrameKind kind)
{
    switch (kind) {
    case FrameKind::Captured:
        return QCoreApplication::translate("FrameKind", "captured");
    case FrameKind::Varied:
        return QCoreApplication::translate("FrameKind", "varied");
    case FrameKind::Transition:
        return QCoreApplication::translate("FrameKind", "transition");
    }
    return {};
}

void paintFramePattern(QPainter& painter, const QRectF& box, FrameKind kind, const QColor& color)
{
    constexpr float strength = 0.35F;
    QColor marks = Theme::textOn(color);
    marks.setAlphaF(strength);
    if (kind == FrameKind::Transition)
        paintHatching(painter, box, marks);
    else if (kind == FrameKind::Varied)
        paintDots(painter, box, marks);
}

} // namespace quadrille::widgets
