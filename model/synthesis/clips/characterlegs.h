// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/feet.h"
#include "model/transition/characterframes.h"

namespace quadrille {

/// The legs of a character as the first of its sequences shows them that has any; none where none does.
/// \throws Error as loadFrames.
Legs legsOf(const CharacterFrames& character, UpAxis up, const Progress& progress = {});

} // namespace quadrille
