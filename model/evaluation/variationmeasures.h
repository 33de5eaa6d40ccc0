// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/stances.h"
#include "model/variation/movement.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// What of a clip is compared with the take that it varies.
struct MovedMeasures
{
    double acceleration = 0;       ///< mean over frames and vertices, m/s²
    double centreAcceleration = 0; ///< of the centre of all vertices, mean over frames, m/s²
    std::optional<double> slide;   ///< of standing feet over the ground, mean, m/s
    /// First frame against the last, laid onto the template: mean distance of a vertex, metres.
    double closing = 0;
    std::vector<double> lowest;          ///< of each frame the height of its lowest vertex, metres
    std::vector<RigidMotion> placements; ///< of each frame, from the template's place
    RowMatrix limbs; ///< frames × three coordinates of the middle of each part but the root, laid
};

/// \param stances  of the character that origins count. \pre At least one frame.
MovedMeasures measureMoved(const Clip& clip, const Movement& movement, const Stances& stances, UpAxis up);

/// A variation against the captured frames that it follows.
struct VariationComparison
{
    double acceleration = 1;       ///< ratio
    double centreAcceleration = 1; ///< ratio
    std::optional<double> slide;   ///< ratio; nothing where nothing stands in either
    double sink = 0;               ///< deepest point below that of the take, metres
    double hover = 0;              ///< greatest height of the lowest point above that of the take's frame
    double heading = 0;            ///< greatest angle about the up axis from the take's frame, radians
    /// How well limbs keep step: of the pairs whose swing is correlated by a half or more in the take, the
    /// mean correlation in the variation, counted as in the take; 1 in both where there is no such pair.
    double step = 1;
    double takeStep = 1;
    double closing = 0; ///< metres beyond that of the take
};

/// The captured frames that a clip follows: of two the nearer ones.
struct FollowedTake
{
    Clip clip;                       ///< from the first to the last of them, each once
    std::vector<std::size_t> frames; ///< of each frame of the variation its frame in it
};
/// \pre The clip follows one take, forwards.
FollowedTake followedTake(const Clip& clip, const CharacterFrames& character);

/// \param of  the variation. \param take  of the take that it follows. \param frames  FollowedTake::frames.
VariationComparison compared(const MovedMeasures& of, const MovedMeasures& take,
                             std::span<const std::size_t> frames, UpAxis up);

} // namespace quadrille
