// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/viewport.h"

#include <QString>
#include <cstdint>
#include <vector>

namespace quadrille::widgets {

/// A curve that clings to a figure's surface, as an editor of them shows it.
struct ShownCurve
{
    QString name;
    std::vector<std::uint32_t> vertices; ///< of the figure, along the curve
    /// Places in `vertices` of the points that can be dragged, ascending.
    std::vector<std::size_t> points;
    bool isClosed = true; ///< the last vertex is joined with the first
    QColor color;
    QString problem; ///< what is wrong with it; empty when nothing is

    bool operator==(const ShownCurve&) const = default;
};

/// Something of curves that can be taken hold of.
struct SurfaceCurvePart
{
    enum class Kind
    {
        None,
        Point,
        Curve
    };
    Kind kind = Kind::None;
    int curve = 0;
    int point = 0; ///< index in ShownCurve::points

    bool operator==(const SurfaceCurvePart&) const = default;
};

/// A place on the figure that a gesture asks for.
struct SurfacePlace
{
    Pick pick;
    bool snaps = true; ///< false while Alt is held: the point stays where it was put
};

} // namespace quadrille::widgets
