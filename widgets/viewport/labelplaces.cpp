// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/labelplaces.h"

#include <array>

namespace quadrille::widgets {

namespace {

/// Between a point and its plate, logical pixels.
constexpr double besideGap = 9.0;

double areaOf(const QRectF& rect)
{
    return rect.isValid() ? rect.width() * rect.height() : 0.0;
}

double coveredBy(const QRectF& plate, const std::vector<QRectF>& others)
{
    double covered = 0.0;
    for (const QRectF& other : others)
        covered += areaOf(plate & other);
    return covered;
}

/// Middles relative to the point, the best first.
std::array<QPointF, 10> offsetsFor(const QSizeF& size)
{
    const double up = size.height() / 2.0 + besideGap;
    const double aside = size.width() / 2.0 + besideGap;
    const double farther = up + size.height() + besideGap;
    return {QPointF(0.0, -up),      QPointF(0.0, up),     QPointF(aside, 0.0), QPointF(-aside, 0),
            QPointF(aside, -up),    QPointF(-aside, -up), QPointF(aside, up),  QPointF(-aside, up),
            QPointF(0.0, -farther), QPointF(0.0, farther)};
}

} // namespace

std::vector<QRectF> placePlates(const std::vector<PlateRequest>& plates, std::vector<QRectF> keptClear,
                                const QRectF& within)
{
    std::vector<QRectF> placed;
    placed.reserve(plates.size());
    for (const PlateRequest& request : plates) {
        QRectF best;
        double least = 0.0;
        for (const QPointF& offset : offsetsFor(request.size)) {
            QRectF plate(QPointF(), request.size);
            plate.moveCenter(request.place + offset);
            const double covered = areaOf(plate) - areaOf(plate & within) + coveredBy(plate, keptClear) +
                                   coveredBy(plate, request.keptClear);
            if (best.isNull() || covered < least) {
                best = plate;
                least = covered;
            }
            if (least <= 0.0)
                break;
        }
        placed.push_back(best);
        keptClear.push_back(best);
    }
    return placed;
}

} // namespace quadrille::widgets
