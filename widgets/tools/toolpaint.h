// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>

class QPainter;

namespace quadrille::widgets {

// What view tools draw over the picture. Lines and handles have a halo in the colour of surfaces, so that
// they show on everything.

void paintToolLine(QPainter& painter, const QPolygonF& line, const QColor& color, double width,
                   Qt::PenStyle style);

/// Something to take hold of.
struct HandleLook
{
    enum class Form
    {
        Circle,
        Square,
        Diamond,
        Cross
    };
    Form form = Form::Circle;
    double radius = 5.0; ///< logical pixels
    QColor color;
    bool isSelected = false;
    bool isHovered = false;
};

void paintHandle(QPainter& painter, const QPointF& at, const HandleLook& look);

/// Words on a plate whose middle is `at`. \param widest  pixels; longer ones take several lines.
/// \return the plate.
QRectF paintToolWords(QPainter& painter, const QPointF& at, const QString& text, double widest = 4096.0);

/// What there is to say, in the middle of the lower end of a view. \return the plate.
QRectF paintToolHint(QPainter& painter, const QSizeF& view, const QString& text);

} // namespace quadrille::widgets
