// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <vector>

namespace quadrille {

/// When a foot is taken to stand on the ground. It begins to stand when its lowest vertices are both lower
/// and slower than the first pair of limits, and stands until they are above the second, looser pair. Lengths
/// are shares of the figure's height, so that units do not matter.
struct ContactOptions
{
    UpAxis up = UpAxis::Y;
    double landHeight = 0.0143; ///< above the ground, body heights: 25 mm for somebody of 1.75 m
    double leaveHeight = 0.02;
    double landSpeed = 0.20; ///< body heights per second
    double leaveSpeed = 0.29;
    double shortest = 0.08;   ///< seconds; shorter contacts are dropped
    double longestGap = 0.05; ///< seconds; shorter gaps are closed
    double footShare = 0.07;  ///< how high feet reach, from below, body heights
};

/// Finds when the feet stand: heights and speeds of the lowest vertices.
///
/// The legs are the connected pieces of the surface below knee height in the frame where the figure stands
/// tallest on more than one of them; a foot is the lowest part of a leg. Two feet are told apart by where
/// their toes point from the ankles. The ground is where the lowest vertices rest in a good share of the
/// frames; each foot has its own level within 3 cm of a grown-up's size, as captured soles rarely lie at one.
/// Nothing depends on where the figure stands or how it is turned about the up axis. \return spans in order
/// of their first frames, named "left" and "right", or "foot 1", "foot 2", … where there are not two feet;
/// empty when there are fewer than two frames or nothing like feet. \throws Error BadArgument (a limit that
/// is not positive, or a loose one below its strict one), Cancelled, and what reading frames throws.
std::vector<ContactSpan> detectContacts(const MeshSequence& sequence, const ContactOptions& options = {},
                                        const Progress& progress = {});

} // namespace quadrille
