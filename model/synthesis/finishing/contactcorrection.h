// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/feet.h"
#include "model/sequence/meshsequence.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/finishing/postprocessingsettings.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// What a correction of contacts knows beside them.
struct ContactScope
{
    UpAxis up = UpAxis::Y;
    /// The frames that are corrected; all when empty. Contacts beyond them count all the same.
    std::optional<FrameRange> frames;
    /// The legs of the character, for clips in which it does not stand upright; null where nobody knows.
    const Legs* legs = nullptr;
    /// Takes these legs although the clip may show some: contacts of captured frames call feet as their take
    /// does, which a made clip in which they slide may take for each other.
    bool trustsLegs = false;
};

/// Makes feet stand still on the ground during their contacts. What touches the ground is followed from frame
/// to frame; the way that it slips, and the angle that it turns about the vertical, are taken from the foot,
/// shared out so that the foot is moved as little as possible over each contact, eased in before and out
/// behind. A foot that rolls goes on rolling. The foot moves as a whole; the leg above it follows, as rigidly
/// as it can (as-rigid-as-possible deformation, Sorkine and Alexa 2007), up to where legs meet. Frames
/// without a correction stay bit for bit. \param contacts  of feet by the names that detectContacts gives, in
/// frames of the clip; contacts with another name go to the foot that moves least during them.
/// \throws Error NoFeet, BadArgument (settings), Cancelled. Cost: O(frames · vertices); a solve of each leg's
/// vertices for each frame that changes, in parallel.
Clip contactsCorrected(Clip clip, std::span<const ContactSpan> contacts,
                       const ContactCorrectionSettings& settings = {}, const ContactScope& scope = {},
                       const Progress& progress = {});

} // namespace quadrille
