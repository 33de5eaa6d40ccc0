// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/supports.h"

#include <vector>

namespace quadrille {

/// What of captured frames stands.
struct CapturedStanding
{
    CharacterFrames character;
    std::vector<Support> supports; ///< of each of its frames, of findSupports
};

/// Moves the frames of a variation so that what stood in the captured frames that it follows stands still in
/// it as well, and at the same height: its way comes from its steps, as a body's does, instead of from
/// displacements that know nothing of the legs. Legs are drawn without knowing of each other, so the way is
/// evened out from step to step; what little slides then is for the correction of contacts. Where nothing
/// stands, the way over the ground stays as it is, and the height has an even share of what it was moved by
/// before and after, unless something would be deeper than the deepest point of the captured frames. Poses
/// and headings stay.
/// \param captured  the frames that origins count.
void keepStanding(Clip& clip, const CapturedStanding& captured, UpAxis up);

} // namespace quadrille
