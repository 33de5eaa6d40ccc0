// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/ground.h"
#include "model/synthesis/clips/transitionmotion.h"
#include "model/synthesis/finishing/postprocessingsettings.h"
#include "model/transition/interpolationmethod.h"
#include "model/transition/posedistancesettings.h"
#include "model/transition/warppath.h"

namespace quadrille {

/// How the transitions of a character are sought and blended.
struct BlendMethod
{
    UpAxis up = UpAxis::Y;
    PoseDistanceSettings pose;
    /// Their rate is that of the clip, their cost the sum, whatever is said here.
    TransitionSettings transitions;
    InterpolationMethod interpolation = InterpolationMethod::Poisson;
    BlendSettings blend = {.timing = BlendTiming::Smooth, .easing = BlendEasing::Smooth};
};

/// A clip to be played again and again: after its last frame comes its first one, moved by `travel`.
struct Loop
{
    Clip cycle;
    GroundMotion travel; ///< from one cycle to the next
    /// The transition that closes it, in frames of the clip that it was made from: from a late one to an
    /// early one. The cycle begins with the early one. The path is empty where the clip went round by itself.
    Transition closure;
};

/// Closes a clip to a loop. A clip that goes round by itself (see ownPeriod) stays as it is. Otherwise the
/// best transition, warped or not, from a frame near its end to one near its beginning closes it; what lies
/// before and behind is blended or dropped. The best is that of the least mean pose distance along its path,
/// twice as much where the path lets the pose stand still for a moment; among those as good within 5 % that
/// of the longest cycle, then the earliest. The cycle lies where the clip does. \throws Error LoopTooShort,
/// LoopCutTooShort, NoTransition (the slope lets no path span the windows), BadArgument (times, settings of
/// transitions), NoUsableTriangles, Cancelled. Cost: that of pose distances and transitions of the frames
/// that may be cut, and of one blend.
/// \param asked  frames that the cycle is to show as they are: nothing of them is cut, and they are blended
/// over only as far as they lie within the shortest window of an end of the clip.
Loop seamlessLoop(const Clip& clip, const LoopSettings& settings, const BlendMethod& method,
                  const FrameRange& asked = {}, const Progress& progress = {});

/// How a loop goes on from its late frame to its early one.
struct ClosingBlend
{
    GroundMotion travel; ///< of the clip that it leads to
    Clip between;        ///< the frames in between, where the clip lies that it leaves
};

/// Closes a loop from one clip to another, which may be the same. \param closure  of seamlessLoop, not empty.
/// \pre Both clips have as many frames as the one that the closure was found in. \throws Error as
/// blendTransition.
ClosingBlend closingBlend(const Clip& from, const Clip& to, const Transition& closure,
                          const BlendMethod& method, const Progress& progress = {});

/// The loop with its travel taken out, the same from frame to frame (along a circle where it turns).
Loop inPlace(Loop loop, UpAxis up);

/// \throws Error BadArgument where a loop is to be played fewer than 1 or more than 10,000 times.
void checkPlayings(int playings);
/// A loop played several times, each time moved on. \param cycles  1 … 10,000. \throws Error BadArgument.
Clip repeated(const Loop& loop, int cycles, UpAxis up);
/// The cycle and the first frame of the next one.
Clip closedCycle(const Loop& loop, UpAxis up);
/// How several cycles move over the ground.
GroundMotion repeatedTravel(const GroundMotion& travel, int cycles);

/// Puts the frames of a clip behind those of another.
void append(const Clip& clip, Clip& to);
/// Moves the frames of a clip over the ground, in place.
void moveFrame(MutablePositions positions, const GroundMotion& motion, const Ground& ground);

} // namespace quadrille
