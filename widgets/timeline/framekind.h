// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

class QPainter;

namespace quadrille::widgets {

/// Where the frames of a clip come from. Each kind has a colour and a pattern of its own, everywhere the
/// same.
enum class FrameKind
{
    Captured,  ///< plain
    Varied,    ///< drawn from a model, dotted
    Transition ///< blended, hatched
};

QColor frameKindColor(FrameKind kind);
/// "captured", translated.
QString frameKindName(FrameKind kind);

/// Lays a kind's pattern over a box that has been filled with a colour.
void paintFramePattern(QPainter& painter, const QRectF& box, FrameKind kind, const QColor& color);

} // namespace quadrille::widgets
