// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace quadrille {

/// A turn over the ground, as points are turned by it.
struct TurnParts
{
    double cosine = 1;
    double sine = 0;
};

/// Cosines and sines of angles, radians, within 1e-10 of the true ones up to some hundred turns. \param turns
/// as many as angles.
void turnsOf(std::span<const double> angles, std::span<TurnParts> turns);

} // namespace quadrille
