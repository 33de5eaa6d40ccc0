// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/alignment.h"

namespace quadrille {

/// What matches cost, not negative: distances without a share of what the frames of either take differ from
/// all of the other on average (see AlignmentSettings), and what it costs that feet stand in one frame and
/// not in the other, of the feet that both sequences have contacts of.
/// \param distances  frames of the reference × frames of the take.
Table<float> matchCosts(const Table<float>& distances, const MeshSequence& reference,
                        const MeshSequence& take, const AlignmentSettings& settings);

/// Stores costs in a report, shrunk by means of blocks where there are too many.
void shrink(const Table<float>& costs, WarpReport& report);

} // namespace quadrille
