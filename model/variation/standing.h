// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clip.h"
#include "model/synthesis/supports.h"

#include <span>

namespace quadrille {

/// Moves the frames of a variation over the ground so that what stood in the captured frames that it follows
/// stands still in it as well: its way comes from its steps, as a body's does, instead of from displacements
/// that know nothing of the legs. Legs are drawn without knowing of each other, so the way is evened out from
/// step to step; what little slides then is for the correction of contacts. Where nothing stands, the way
/// stays as it is. Poses, heights and headings stay.
/// \param supports  of each captured frame that origins count, of findSupports.
void keepStanding(Clip& clip, std::span<const Support> supports, UpAxis up);

} // namespace quadrille
