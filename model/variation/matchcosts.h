// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/alignment.h"

namespace quadrille {

/// Adds to each match what it costs that feet stand in one frame and not in the other: of the feet that both
/// sequences have contacts of.
/// \param weight  of a match whose feet all differ, in mean costs. \param costs  frames of one × frames of
/// the other.
void addContactCosts(const MeshSequence& reference, const MeshSequence& take, double weight,
                     Table<float>& costs);

/// Stores costs in a report, shrunk by means of blocks where there are too many.
void shrink(const Table<float>& costs, WarpReport& report);

} // namespace quadrille
