// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/executor.h"
#include "model/core/progress.h"
#include "model/core/sharedtable.h"
#include "model/synthesis/clips/ground.h"
#include "model/synthesis/clips/stances.h"
#include "model/synthesis/clips/supports.h"
#include "model/transition/characterframes.h"
#include "model/transition/posedistance.h"

#include <vector>

namespace quadrille {

/// Where the frames of a character stand, and how they are turned against each other.
struct RootPoses
{
    UpAxis up = UpAxis::Y;
    std::vector<Vec3d> centres; ///< mean of the vertices of each frame, metres
    /// frames × frames, radians in (−π, π]: the angle about the up axis by which the pose of the column turns
    /// to lie nearest to that of the row, centres together (the function Align of SMCAS Alg. 1).
    SharedTable<float> turns;
    /// What each frame stands on, of findSupports; empty: nothing is known of it.
    std::vector<Support> supports;
    /// Which feet stand, of findStances; unknown: nothing is known of them.
    Stances stances;
};

/// What `turns` holds of a pair of frames, for posePairs.
OfCovariance turnOf(UpAxis up);

/// Of what posePairs found by turnOf: no supports, no stances.
RootPoses rootPoses(std::vector<Vec3d> centres, Table<float> turns, UpAxis up);

/// The same by a pass of its own. \throws Error what reading frames throws, Cancelled.
/// Cost: O(frames² · vertices); memory: as poseDistances.
RootPoses rootPoses(const CharacterFrames& character, UpAxis up, const Progress& progress = {},
                    const Executor& executor = localExecutor());

/// How fast the body gets on over the ground around each frame, up to half a second to either side, units of
/// length a second.
std::vector<double> pacesOf(const RootPoses& roots, const FrameLayout& layout, double fps);

/// The angle about the up axis by which a pose turns to lie nearest to a target, centres together.
/// \pre Both poses have as many vertices. \return radians in (−π, π]; 0 where every angle is as good.
double groundAlignment(Positions moved, Positions target, const Ground& ground);

} // namespace quadrille
