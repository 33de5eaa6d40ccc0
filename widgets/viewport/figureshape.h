// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/figuremesh.h"

#include <QVector3D>

namespace quadrille::widgets {

/// A figure as it stands in a view. What it refers to lasts until the figure changes.
struct FigureShape
{
    const FigureMesh& mesh;
    std::span<const float> positions; ///< vertices × 3
    QVector3D shift;                  ///< added to the positions

    QVector3D place(std::uint32_t vertex) const
    {
        const float* p = &positions[std::size_t{3} * vertex];
        return QVector3D(p[0], p[1], p[2]) + shift;
    }
};

} // namespace quadrille::widgets
