// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/symmetry.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/finishing/loopplayings.h"
#include "model/synthesis/finishing/postprocessingsettings.h"

#include <functional>
#include <optional>
#include <vector>

namespace quadrille {

/// What post-processing needs to know beside the clip.
struct PostProcessingInputs
{
    BlendMethod method;
    /// Frames of the clip that show what was asked for: a loop keeps them.
    FrameRange asked;
    /// Finds the contacts of a clip, such as those of its origins; detectContacts where empty. It may be
    /// asked about several cycles of the clip's loop.
    std::function<std::vector<ContactSpan>(const Clip& clip)> contactsOf;
    /// The character: its frames tell what its legs are where the clip does not show it upright.
    std::optional<CharacterFrames> character;
    /// What each playing of a loop shows; the clip itself where empty.
    PlayingClip playing;
    double easeSeconds = 0.2; ///< see playedAs
    /// The symmetry of the character, asked for where the clip is to be mirrored. Where empty it is sought in
    /// the first frame, which finds symmetries of the connectivity in any pose.
    std::function<Symmetry(const Progress& progress)> symmetry;
};

struct PostProcessed
{
    Clip clip;
    /// Where the clip is a loop: from one playing of all its repeats to the next.
    std::optional<GroundMotion> travel;
    /// What closes the loop, in frames of the clip before.
    std::optional<Transition> closure;
    /// That the clip lasts before it is retimed: until its last frame, a loop until its first comes again.
    std::int64_t framesBeforeRetime = 0;
};

/// Applies all steps that are asked for, in the order of PostProcessing. A loop whose contacts are corrected
/// and in which a foot stands all the time does not travel. Where a curve of times does not go all round the
/// repeats of a loop, the result is no loop any more.
/// \throws Error what the steps throw; BadArgument where repeats are asked for without a loop.
PostProcessed postProcessed(Clip clip, const PostProcessing& settings, const PostProcessingInputs& inputs,
                            const Progress& progress = {});

/// The loop with the slip of its contacts taken out, all round: contacts may go on from its end to its
/// beginning. \throws Error as contactsCorrected.
Loop contactsCorrected(Loop loop, const ContactCorrectionSettings& settings,
                       const PostProcessingInputs& inputs, const Progress& progress = {});
/// \overload of playings, from each to the next.
LoopPlayings contactsCorrected(LoopPlayings playings, const ContactCorrectionSettings& settings,
                               const PostProcessingInputs& inputs, const Progress& progress = {});

} // namespace quadrille
