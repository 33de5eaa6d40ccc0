// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/finishing/loop.h"

#include <functional>
#include <memory>
#include <vector>

namespace quadrille {

/// Some playings of a loop, which may differ, as one cycle.
struct LoopPlayings
{
    Loop loop;                         ///< all of them, one behind the other
    std::vector<GroundMotion> travels; ///< of each to the next, and of the last to the first; at least one

    std::int64_t framesOfEach() const { return loop.cycle.frameCount() / std::ssize(travels); }
};

/// What a playing of a loop shows, counted from 0. Playings that show the same may have one clip.
using PlayingClip = std::function<std::shared_ptr<const Clip>(int playing, const Progress& progress)>;

/// Plays a loop several times, each time as another clip shows it. One goes on into the next as the loop
/// does, by its closure. Where the loop goes round by itself, playings come back to its first clip at both
/// ends, over as many frames as the ease lasts.
/// \param loop  of seamlessLoop, not in place, of the first clip. \param clipOf  clips of as many frames, in
/// the same place over the ground. \param easeSeconds  at most a third of a playing. \throws Error
/// BadArgument (1 … 10,000 playings), what `clipOf` and closingBlend throw, Cancelled.
LoopPlayings playedAs(const Loop& loop, int playings, const PlayingClip& clipOf, const BlendMethod& method,
                      double easeSeconds = 0.2, const Progress& progress = {});

/// The playings with their travels taken out, each evenly. \see inPlace of a loop.
LoopPlayings inPlace(LoopPlayings playings, UpAxis up);

} // namespace quadrille
