// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/transitionmotion.h"
#include "model/synthesis/clips/walk.h"

#include <span>
#include <vector>

namespace quadrille {

/// How a frame of a clip comes about: from which poses, and where they are put.
struct PlannedFrame
{
    FrameProvenance origin;        ///< by the captured frames nearest to the moments that are shown
    BlendTimes times;              ///< both are one for a pose that is not blended
    double lambda = 0;             ///< weight of the destination, 0 … 1
    GroundMotion placeSource;      ///< of the source sequence as captured
    GroundMotion placeDestination; ///< of the destination sequence as captured
    Vec3d centre = Vec3d::Zero();  ///< mean of the vertices

    /// Whether it shows one frame as it is, captured or varied.
    bool isSingle() const { return times.source == times.destination && times.source.part == 0; }
    bool isCaptured() const { return isSingle() && origin.isCaptured(); }
};

/// All of a clip but its surfaces: cheap to make and to keep.
struct ClipPlan
{
    /// Where a transition lies in the clip.
    struct Junction
    {
        FramePair frames;       ///< i and j
        std::int64_t first = 0; ///< frame of the clip that shows pose i
        std::int64_t last = 0;  ///< frame of the clip that shows pose j; both are one where L = 1
        float cost = 0;         ///< D
        bool contains(std::int64_t frame) const { return first <= frame && frame <= last; }
    };

    UpAxis up = UpAxis::Y;
    std::vector<PlannedFrame> frames;
    std::vector<Junction> junctions;      ///< of each transition
    std::vector<std::int64_t> spanStarts; ///< frame of the clip where each span of the walk begins
    FrameRange asked;                     ///< frames that show what was asked for, where that is known

    std::int64_t frameCount() const { return static_cast<std::int64_t>(frames.size()); }
};

struct PlanOptions
{
    GroundMotion start; ///< places the first sequence as captured
    BlendSettings blend;
};

/// \throws Error BadArgument where a walk has no span, or a span is not of frames of one sequence, in order.
void checkWalk(const Walk& walk, const FrameLayout& layout);

/// The transitions of a walk. \throws Error as checkWalk, NoTransition, BadArgument.
std::vector<Transition> transitionsOf(const Walk& walk, const FrameLayout& layout, const WarpPaths& paths);

/// A walk frame by frame (SMCAS Alg. 2): its spans are played as captured, turned and moved over the ground
/// so that each goes on where the transition before it ends; each transition adds L − 2 blended frames
/// between the last frame of one span and the first of the next. A transition of one frame shows only the
/// pose that it leaves. \pre The walk passed checkWalk, and these are its transitions.
ClipPlan planClip(const RootPoses& roots, const Walk& walk, std::span<const Transition> transitions,
                  const PlanOptions& options = {});

/// As above. \throws Error as transitionsOf.
ClipPlan planClip(const RootPoses& roots, const FrameLayout& layout, const WarpPaths& paths, const Walk& walk,
                  const PlanOptions& options = {});

/// Where the centre of the blended pose goes, with each of the ways to lay the windows over each other
/// (SMCAS Fig. 11–12), one point for each frame of a transition.
struct CentreTrajectories
{
    std::vector<Vec3d> everyStep;
    std::vector<Vec3d> midWindow;
    std::vector<Vec3d> none;
};

/// \param constantWeight  λ of all frames (the figures have 0.5); otherwise it rises from 0 to 1.
CentreTrajectories centreTrajectories(const RootPoses& roots, const Transition& transition,
                                      std::optional<double> constantWeight = {});

} // namespace quadrille
