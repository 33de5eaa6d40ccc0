// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace quadrille::widgets {

/// A plate of words that belongs to a point; logical pixels.
struct PlateRequest
{
    QPointF place;
    QSizeF size;
    std::vector<QRectF> keptClear = {}; ///< what this one should not hide, beside what none should
};

/// Where plates are drawn: each above its point if nothing is covered there, otherwise below, at a side, or
/// farther away, wherever it covers least. Earlier plates count as something to cover.
/// \param keptClear  what words should not hide; pixels \param within  the view; what lies outside counts as
/// covered
std::vector<QRectF> placePlates(const std::vector<PlateRequest>& plates, std::vector<QRectF> keptClear,
                                const QRectF& within);

} // namespace quadrille::widgets
