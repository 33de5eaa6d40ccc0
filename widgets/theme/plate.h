// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

class QPainter;

namespace quadrille::widgets {

// What keeps words readable over a picture: a plate of the theme that lets some of it through.

QColor plateColor();
void paintPlate(QPainter& painter, const QRectF& place, double radius = 4);

/// The plate that a word needs. \param mark  colour of a dot before it; invalid: none.
QSizeF labelSize(const QPainter& painter, const QString& text, const QColor& mark = {});
/// A word on its plate. \param place  as large as labelSize() says.
void paintLabel(QPainter& painter, const QRectF& place, const QString& text, const QColor& mark = {});

} // namespace quadrille::widgets
