// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

/// In pixels.
inline double distanceBetween(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// \param t  where the nearest place of the segment is, 0 … 1.
inline double distanceToSegment(const QPointF& point, const QPointF& a, const QPointF& b, double* t = nullptr)
{
    const QPointF along = b - a;
    const double squared = QPointF::dotProduct(along, along);
    const double nearest =
        squared > 0.0 ? std::clamp(QPointF::dotProduct(point - a, along) / squared, 0.0, 1.0) : 0.0;
    if (t != nullptr)
        *t = nearest;
    return distanceBetween(point, a + nearest * along);
}

} // namespace quadrille::widgets
