// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The part that plays again and again: a band along the top of the ruler.
#include "widgets/theme/theme.h"
#include "widgets/timeline/timelineprivate.h"

#include <QPainter>
#include <algorithm>

namespace quadrille::widgets {

void Timeline::Private::paintLoop(QPainter& painter) const
{
    using Kind = TimelineDrag::Kind;
    const bool isDragged = drag.moved && (drag.kind == Kind::LoopStart || drag.kind == Kind::LoopEnd ||
                                          drag.kind == Kind::LoopNew);
    if (!loop && !isDragged)
        return;
    const auto [first, last] = isDragged ? std::pair{drag.first, drag.last} : *loop;
    const QColor color = Theme::color(ColorRole::Key);
    const QRectF band(x(first), 0, x(last + 1) - x(first), loopHeight);
    QColor ground = color;
    ground.setAlphaF(0.10F);
    painter.fillRect(QRectF(band.left(), loopHeight, band.width(), rulerHeight - loopHeight), ground);
    ground.setAlphaF(0.75F);
    painter.fillRect(band.adjusted(0, 1, 0, -2), ground);
    painter.setPen(QPen(Theme::color(ColorRole::Text), 1.5));
    for (const double end : {band.left() + 1, band.right() - 1})
        painter.drawLine(QPointF(end, 0), QPointF(end, rulerHeight - 2.0));
}

/// Makes the playhead the first or last frame of the loop.
void Timeline::editLoopByKey(bool isStart)
{
    const auto [in, out] = d->loop.value_or(d->effectiveRange());
    if (isStart)
        emit loopEdited(d->current, std::max(d->current, out), true);
    else
        emit loopEdited(std::min(in, d->current), d->current, true);
}

} // namespace quadrille::widgets
