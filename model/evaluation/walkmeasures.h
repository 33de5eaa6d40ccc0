// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clipplan.h"
#include "model/synthesis/walks/constraints.h"

#include <array>
#include <string_view>
#include <vector>

namespace quadrille {

/// What of a clip a viewer sees slide or hurry, by its surface alone.
struct MotionMeasures
{
    /// Of the foot that stands, which is the one that slips least of those on the ground: how fast what
    /// touches the ground slips, in 95 of 100 frames no faster, units of length a second.
    double slide95 = 0;
    /// Root mean square of how much the speed of the centre over the ground changes within a fifth of a
    /// second, units of length a second.
    double speedChange = 0;
};

/// \param levels  of standingLevels; a foot is on the ground up to a hundredth of the figure's height above.
MotionMeasures measureMotion(const Clip& clip, const Stances& stances, UpAxis up,
                             const std::vector<double>& levels);

/// Of each foot the median height of its sole in the captured frames in which it stands: captured soles lie
/// centimetres apart. Negative infinity for a foot that never stands.
std::vector<double> standingLevels(const CharacterFrames& character, const Stances& stances, UpAxis up);

/// The 95th percentile of both measures over all takes of which a walk shows something, each measured whole;
/// of slides that of all frames together, of changes the root mean square.
MotionMeasures measureTakes(const CharacterFrames& character, const RootPoses& roots,
                            const std::vector<WalkSpan>& shown, const std::vector<double>& levels);

/// How restless a walk is.
struct WalkCalmness
{
    double seconds = 0;
    int transitions = 0;
    NodeIndex shortestRun = 0; ///< captured frames between two transitions, or at an end
    double blendedShare = 0;   ///< of the frames
    double strayShare = 0;     ///< what is shown of frames that are no locomotion, in all that is shown
    double transitionsPerSecond() const { return seconds > 0 ? transitions / seconds : 0; }
};
/// \param locomotion  which captured frames are (WalkMaterial); empty: nobody knows.
WalkCalmness calmnessOf(const ClipPlan& plan, const Walk& walk, const std::vector<bool>& locomotion,
                        double fps);

/// The paths that walks are compared on.
inline constexpr std::array<std::string_view, 5> standardPaths{"straight", "s", "circle", "right-angle",
                                                               "figure-of-eight"};
/// Points of a standard path on the ground, some centimetres apart, metres: 8 m straight; an S of 9 m; a
/// circle of 3 m radius; 4 m, a right angle to the left, 4 m; two circles of 2 m radius.
std::vector<Vec2d> standardPath(std::string_view name);

} // namespace quadrille
