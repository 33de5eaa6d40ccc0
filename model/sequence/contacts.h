// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <vector>

namespace quadrille {

/// When a foot is taken to stand on the ground. It begins to stand when its lowest vertices are both lower
/// and slower than the first pair of limits, and stands until they are above the second, looser pair.
struct ContactOptions
{
    double landHeight = 0.025; ///< metres above the ground
    double leaveHeight = 0.035;
    double landSpeed = 0.35; ///< metres per second
    double leaveSpeed = 0.50;
    double shortest = 0.08;   ///< seconds; shorter contacts are dropped
    double longestGap = 0.05; ///< seconds; shorter gaps are closed
    /// Share of the figure's height, from below, in which feet are looked for.
    double footShare = 0.07;
};

/// Finds when the feet stand: heights and speeds of the lowest vertices.
///
/// The feet are the vertices that are lowest in frames where the figure stands, split into two groups that
/// lie apart; left and right are told by the direction in which the toes point, as seen from the ankles. The
/// ground is where the lowest vertices rest in most frames. Nothing depends on where the figure stands or how
/// it is turned about the up axis.
/// \param up the sequence's up axis.
/// \return spans named "left" and "right", in order of their first frames; empty when there are fewer than
/// two frames or no two feet are found. \throws Error BadArgument (a limit that is not positive, or a loose
/// one below its strict one), Cancelled, and what reading frames throws.
std::vector<ContactSpan> detectContacts(const MeshSequence& sequence, const ContactOptions& options = {},
                                        UpAxis up = UpAxis::Y, const Progress& progress = {});

} // namespace quadrille
