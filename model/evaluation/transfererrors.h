// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

namespace quadrille {

/// How far the vertices of a pose are from where they ought to be, in the unit of the positions.
struct VertexErrors
{
    double mean = 0;
    double worst = 0;
};

/// The same with the pose where it is, and with the body as a whole moved onto the truth.
struct TransferErrors
{
    VertexErrors moved;  ///< the means of all vertices at one place; not turned
    VertexErrors placed; ///< as both are
};

/// \pre Both poses have as many vertices, one at least.
TransferErrors transferErrors(Positions made, Positions truth);

} // namespace quadrille
