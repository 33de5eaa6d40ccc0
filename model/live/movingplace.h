// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/weightspace.h"

namespace quadrille {

/// Moves a place of a motion space for one tick towards where it is wanted: as fast as it may, but it takes a
/// while to reach that pace, to change it, and to come to rest; a pace that began or ended at once would show
/// as a jolt of the whole body. It never goes beyond what is wanted from rest, and is exactly there in the
/// end. \param least, greatest  of the places of the space; nothing moves along axes of no length. \param
/// secondsAcross  over the whole of an axis at full pace, which is reached in a quarter of that. \param
/// seconds  of the tick. \param pace  of the place, a second: as of the last tick, then as of this one.
void movePlaceTowards(const SpacePoint& wanted, const SpacePoint& least, const SpacePoint& greatest,
                      double secondsAcross, double seconds, SpacePoint& place, SpacePoint& pace);

/// How much of its way a place has gone in a transition, after a share of its frames: smooth.
double wayGone(double share);
/// By how many steps a place moves in a frame on average on such ways, so that at its fastest it is as fast
/// as when it is steered. \param steps  of an axis. \param fps  of the space.
double stepsAFrame(int steps, double secondsAcross, double fps);

} // namespace quadrille
