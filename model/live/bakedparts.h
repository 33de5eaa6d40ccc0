// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/bakedbytes.h"
#include "model/live/bakedplayer.h"

namespace quadrille {

// Each writes a value by BakedWriter, or reads one by BakedReader; the latter then fits together, else it
// throws as BakedReader::refuse.

void bake(BakedWriter& bytes, const BakedPlayer& player);
void bake(BakedReader& bytes, BakedPlayer& player);

} // namespace quadrille
