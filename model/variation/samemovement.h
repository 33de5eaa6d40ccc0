// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/movement.h"

#include <vector>

namespace quadrille {

/// How far a take moves: mean distance of a vertex from its mean place, metres.
double rangeOfMotion(const AlignedTake& take);

/// How far two captured takes are apart: mean distance of a vertex from the one of the same phase, as a share
/// of how far it moves in both: its mean distance from its mean place.
double movementDistance(const Movement& movement, std::size_t take, std::size_t other);

/// The captured takes of the same movement as one of them, itself included: how it varies is told by them.
/// Those with the same labels; where either has none, those that are less than 0.92 apart.
std::vector<std::size_t> sameMovement(const Movement& movement, std::size_t take);

} // namespace quadrille
